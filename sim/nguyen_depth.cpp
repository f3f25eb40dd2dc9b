// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/nguyen_depth.h"

#include <algorithm>
#include <cmath>

#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr double kSteepest = 80 * M_PI / 180;

}  // namespace

double NguyenDepth::AxialSigma(double z, double theta) {
  const double slope = theta / (M_PI / 2 - theta);
  return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4) + 0.0001 / std::sqrt(z) * slope * slope;
}

double NguyenDepth::LateralSigma(double theta) { return 0.8 + 0.035 * theta / (M_PI / 2 - theta); }

Image<float> NguyenDepth::Measure(const DepthView& view, const NoiseKey& key) const {
  const CounterRandom column = NoiseStream(key, NoiseUse::kDepthColumn);
  const CounterRandom row = NoiseStream(key, NoiseUse::kDepthRow);
  const CounterRandom axial = NoiseStream(key, NoiseUse::kDepth);
  Image<float> measured_m(view.camera.width, view.camera.height);
  ParallelFor(measured_m.height(), [&](int y) {
    for (int x = 0; x < measured_m.width(); ++x) {
      if (!(view.truth.depth_m(x, y) > 0)) continue;
      const auto i = std::uint64_t(y) * std::uint64_t(measured_m.width()) + std::uint64_t(x);
      const double theta = std::min(std::acos(std::min(view.CosIncidence(x, y), 1.0)), kSteepest);
      const double sigma_px = LateralSigma(theta);
      const double z =
          double(view.SurfaceDepth(x + sigma_px * column.Normal(i), y + sigma_px * row.Normal(i)));
      if (!(z > 0)) continue;
      measured_m(x, y) = float(std::max(0.0, z + AxialSigma(z, theta) * axial.Normal(i)));
    }
  });
  return measured_m;
}

}  // namespace silt::sim
