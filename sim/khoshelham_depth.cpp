// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/khoshelham_depth.h"

#include <algorithm>

#include "silt/core/parallel.h"

namespace silt::sim {

Image<float> KhoshelhamDepth::Measure(const DepthView& view, const NoiseKey& key) const {
  const CounterRandom random = NoiseStream(key, NoiseUse::kDepth);
  Image<float> measured_m = view.truth.depth_m;
  ParallelFor(measured_m.height(), [&](int y) {
    float* row = measured_m.row(y);
    const auto first = std::uint64_t(y) * std::uint64_t(measured_m.width());
    for (int x = 0; x < measured_m.width(); ++x) {
      const double z = double(row[x]);
      const double sigma_m = 1.425e-3 * z * z;
      row[x] = float(std::max(0.0, z + sigma_m * random.Normal(first + std::uint64_t(x))));
    }
  });
  return measured_m;
}

}  // namespace silt::sim
