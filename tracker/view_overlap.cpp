// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/view_overlap.h"

#include "silt/core/error.h"
#include "silt/core/pyramid.h"

namespace silt::tracker {
namespace {

constexpr int kStep_px = 16;

bool Sees(const PinholeCamera& camera, const Vec3d& point) {
  if (!(point.z > 0)) return false;
  const Vec2d p = camera.Project(point);
  return p.x >= 0 && p.y >= 0 && p.x <= camera.width - 1 && p.y <= camera.height - 1;
}

}  // namespace

double ViewOverlap(const Image<float>& depth_m, const PinholeCamera& camera,
                   const SE3d& current_from_reference) {
  SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
  int measured = 0, seen = 0;
  for (int y = kStep_px / 2; y < depth_m.height(); y += kStep_px) {
    for (int x = kStep_px / 2; x < depth_m.width(); x += kStep_px) {
      const float z = depth_m(x, y);
      if (!IsMeasured(z)) continue;
      ++measured;
      seen += Sees(camera, current_from_reference * camera.Unproject(x, y, double(z))) ? 1 : 0;
    }
  }
  return measured > 0 ? double(seen) / measured : 0;
}

}  // namespace silt::tracker
