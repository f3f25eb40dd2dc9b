// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/work_floor.h"

namespace silt::dense {
namespace {

// Per pixel. The warp: two coordinates 4, a direction 12, a point 6, 1/Z, a projection 6. A sample:
// its place 2, its value and derivatives 12. Residual and Jacobian: 1 and 21. Sums: 27 products
// added, Σr² and a count 57.
constexpr double kWarp = 29, kSample = 14, kJacobian = 22, kSums = 57;
// The weight, and what is multiplied with it: 19. A residual of the inverse depth: a sample, a
// Jacobian with 2 more, a weight and sums.
constexpr double kWeight = 19, kDepth = kSample + kJacobian + 2 + kWeight + kSums;
// Intensity and depth of the keyframe, intensity of the current image, and its inverse depth.
constexpr double kBytes = 12, kDepthBytes = 4;

}  // namespace

Work& Work::operator+=(const Work& other) {
  passes += other.passes;
  bytes += other.bytes;
  operations += other.operations;
  return *this;
}

Work Work::operator*(double factor) const {
  return {passes * factor, bytes * factor, operations * factor};
}

Work WorkOf(const tracker::AlignmentResult& alignment, const tracker::AlignmentOptions& options) {
  const double operations = kWarp + kSample + kJacobian + kSums + (options.robust() ? kWeight : 0) +
                            (options.depth_residual ? kDepth : 0);
  const double bytes = kBytes + (options.depth_residual ? kDepthBytes : 0);
  Work work;
  for (const tracker::AlignmentLevel& level : alignment.levels) {
    const double passes = 1 + level.iterations, pixels = double(level.width) * level.height;
    work += {passes, passes * pixels * bytes, passes * pixels * operations};
  }
  return work;
}

}  // namespace silt::dense
