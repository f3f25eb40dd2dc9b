// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/kinect_depth.h"

#include <cmath>

#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr double kStepsMetre = 351.3;  // steps of disparity at 1 m
constexpr double kSigmaSteps = 1.0 / 6, kSigmaPixels = 0.5;

}  // namespace

Image<float> KinectDepth::Measure(const DepthView& view, const NoiseKey& key) const {
  const CounterRandom column = NoiseStream(key, NoiseUse::kDepthColumn);
  const CounterRandom row = NoiseStream(key, NoiseUse::kDepthRow);
  const CounterRandom disparity = NoiseStream(key, NoiseUse::kDepth);
  Image<float> measured_m(view.camera.width, view.camera.height);
  ParallelFor(measured_m.height(), [&](int y) {
    for (int x = 0; x < measured_m.width(); ++x) {
      const auto i = std::uint64_t(y) * std::uint64_t(measured_m.width()) + std::uint64_t(x);
      const double z = double(view.BilinearDepth(x + kSigmaPixels * column.Normal(i),
                                                 y + kSigmaPixels * row.Normal(i)));
      if (!(z > 0)) continue;
      const double steps = kStepsMetre / z + kSigmaSteps * disparity.Normal(i) + 0.5;
      const double whole =
          rounding_ == Rounding::kFloor ? std::floor(steps) : std::nearbyint(steps);
      if (whole >= 1) measured_m(x, y) = float(kStepsMetre / whole);
    }
  });
  return measured_m;
}

}  // namespace silt::sim
