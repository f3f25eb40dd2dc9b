// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/visibility.h"

#include <algorithm>
#include <limits>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/warp.h"

namespace silt::tracker {
namespace {

// A point hides others that are farther by more than this share of its depth: well above the slope
// of a surface over the few pixels looked at, well below the gap between two objects.
constexpr float kDepthMargin = 0.03f;

// The current image in cells of 2×2 pixels: wide enough for no gap to open between the points of a
// surface that the camera comes closer to. A point is hidden by those in its own cell and the eight
// around it, 2 to 4 pixels on each side: the pose is not yet exact, and a residual beside an
// occluding edge mixes both surfaces.
constexpr int kCellPixels = 2;

// A reference pixel in the current image.
struct Landing {
  int cell = 0;
  float z = 0;  // 0: out of view
};

class CellGrid {
 public:
  explicit CellGrid(const PinholeCamera& camera)
      : camera_(camera),
        nearest_z_(camera.width / kCellPixels + 1, camera.height / kCellPixels + 1,
                   std::numeric_limits<float>::max()) {}

  Landing Land(const kernel::WarpedPixel<float>& warped) const {
    const bool in_view = warped.front && warped.u >= 0 && warped.v >= 0 &&
                         warped.u < float(camera_.width) && warped.v < float(camera_.height);
    if (!in_view) return {};
    const int column = int(warped.u) / kCellPixels, row = int(warped.v) / kCellPixels;
    return {row * nearest_z_.width() + column, warped.point.z};
  }

  void Add(const Landing& landing) {
    float& nearest = nearest_z_.data()[landing.cell];
    if (landing.z > 0) nearest = std::min(nearest, landing.z);
  }

  // Each cell takes the least of itself and its neighbours.
  void Spread() {
    const Image<float> rows = LeastOfThree(nearest_z_, 1, 0);
    nearest_z_ = LeastOfThree(rows, 0, 1);
  }

  bool Hides(const Landing& landing) const {
    return nearest_z_.data()[landing.cell] < (1 - kDepthMargin) * landing.z;
  }

 private:
  // Of the cells at −step, 0 and +step; those beyond the border do not count.
  static Image<float> LeastOfThree(const Image<float>& z, int step_x, int step_y) {
    Image<float> least = z;
    for (int y = step_y; y < z.height(); ++y) {
      for (int x = step_x; x < z.width(); ++x) {
        float &here = least(x, y), &before = least(x - step_x, y - step_y);
        here = std::min(here, z(x - step_x, y - step_y));
        before = std::min(before, z(x, y));
      }
    }
    return least;
  }

  const PinholeCamera& camera_;
  Image<float> nearest_z_;
};

Image<Landing> LandAll(const Image<float>& depth_m, const kernel::Warp<float>& warp,
                       const CellGrid& cells) {
  Image<Landing> landings(depth_m.width(), depth_m.height());
  ParallelFor(depth_m.height(), [&](int y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      landings(x, y) =
          cells.Land(kernel::WarpPixel<float>(warp, {float(x), float(y), depth_m(x, y), 0.0f}));
    }
  });
  return landings;
}

}  // namespace

Image<float> VisibleDepth(const Image<float>& depth_m, const PinholeCamera& camera,
                          const SE3d& current_from_reference) {
  SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
  CellGrid cells(camera);
  const kernel::Warp<float> warp(kernel::Warp<double>(current_from_reference, camera));
  const Image<Landing> landings = LandAll(depth_m, warp, cells);
  for (const Landing& landing : landings) cells.Add(landing);
  cells.Spread();
  Image<float> visible = depth_m;
  ParallelFor(depth_m.height(), [&](int y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      if (cells.Hides(landings(x, y))) visible(x, y) = 0;
    }
  });
  return visible;
}

}  // namespace silt::tracker
