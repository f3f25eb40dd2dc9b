// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/visibility.h"

#include <algorithm>
#include <limits>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/visibility.h"

namespace silt::tracker {
namespace {

using kernel::CellLanding;

class Cells {
 public:
  explicit Cells(const PinholeCamera& camera)
      : camera_(camera),
        nearest_z_(kernel::CellsOf(camera.width, camera.height).columns,
                   kernel::CellsOf(camera.width, camera.height).rows,
                   std::numeric_limits<float>::max()) {}

  CellLanding Land(const kernel::WarpedPixel<float>& warped) const {
    return kernel::LandInCell(warped, camera_.width, camera_.height);
  }

  void Add(const CellLanding& landing) {
    float& nearest = nearest_z_.data()[landing.cell];
    if (landing.z > 0) nearest = std::min(nearest, landing.z);
  }

  // Each cell takes the least of itself and its neighbours.
  void Spread() {
    const Image<float> rows = LeastOfThree(nearest_z_, 1, 0);
    nearest_z_ = LeastOfThree(rows, 0, 1);
  }

  bool Hides(const CellLanding& landing) const {
    return kernel::IsHidden(landing, nearest_z_.data()[landing.cell]);
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

Image<CellLanding> LandAll(const Image<float>& depth_m, const kernel::Warp<float>& warp,
                           const Cells& cells) {
  Image<CellLanding> landings(depth_m.width(), depth_m.height());
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
  Cells cells(camera);
  const kernel::Warp<float> warp(kernel::Warp<double>(current_from_reference, camera));
  const Image<CellLanding> landings = LandAll(depth_m, warp, cells);
  for (const CellLanding& landing : landings) cells.Add(landing);
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
