// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/depth_dropouts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

// Whether a pixel next to (x, y) shows something else, by depth.
bool OnEdge(const DepthDropouts& dropouts, const Image<float>& depth_m, int x, int y) {
  const float here = depth_m(x, y);
  const float most = float(1 + dropouts.edge_share);
  for (int v = y - dropouts.edge_px; v <= y + dropouts.edge_px; ++v) {
    for (int u = x - dropouts.edge_px; u <= x + dropouts.edge_px; ++u) {
      if (!depth_m.Contains(u, v)) continue;
      const float there = depth_m(u, v);
      if (!(std::max(here, there) <= most * std::min(here, there))) return true;
    }
  }
  return false;
}

// Which pixels of a row the projector does not light. It stands at (b, 0, 0) and sees pixel u of
// depth z at u − fx·b/z. From the right to the left of the picture, its column decreases along a
// lit surface; a pixel whose column has been passed already lies behind something.
void DropShadows(const DepthDropouts& dropouts, const DepthView& view, int y,
                 Image<float>& measured_m) {
  const Image<float>& depth_m = view.truth.depth_m;
  const double disparity_m = view.camera.fx * dropouts.shadow_baseline_m;
  double passed = std::numeric_limits<double>::infinity();
  for (int x = depth_m.width() - 1; x >= 0; --x) {
    const double z = double(depth_m(x, y));
    if (!(z > 0)) continue;
    const double column = x - disparity_m / z;
    if (column > passed) measured_m(x, y) = 0;
    passed = std::min(passed, column);
  }
}

}  // namespace

void DepthDropouts::Validate() const {
  const auto require = [](bool good, const char* what) {
    if (!good) throw Error(std::string("depth dropouts: ") + what);
  };
  require(grazing_deg > 0 && grazing_deg <= 90, "the grazing angle must be above 0 and at most 90");
  require(edge_share >= 0 && edge_share <= 10, "the edge's share must be from 0 to 10");
  require(edge_px >= 1 && edge_px <= 16, "the edge's width must be 1 to 16 pixels");
  require(shadow_baseline_m >= 0 && shadow_baseline_m <= 1,
          "the projector must stand 0 to 1 m from the camera");
}

void DropOut(const DepthDropouts& dropouts, const DepthView& view, Image<float>& measured_m) {
  if (dropouts.AreNone()) return;
  const double least_cosine = std::cos(dropouts.grazing_deg * M_PI / 180);
  ParallelFor(measured_m.height(), [&](int y) {
    for (int x = 0; x < measured_m.width(); ++x) {
      const bool grazing = dropouts.grazing_deg < 90 && view.CosIncidence(x, y) < least_cosine;
      const bool edge = dropouts.edge_share > 0 && OnEdge(dropouts, view.truth.depth_m, x, y);
      if (grazing || edge) measured_m(x, y) = 0;
    }
    if (dropouts.shadow_baseline_m > 0) DropShadows(dropouts, view, y, measured_m);
  });
}

}  // namespace silt::sim
