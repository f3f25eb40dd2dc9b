// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/handa_noise.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

float Noisy(float signal, double sigma_shot, double sigma_read, double normal) {
  const double saturated = std::clamp(double(signal), 0.0, 1.0);
  const double variance = sigma_shot * sigma_shot * saturated + sigma_read * sigma_read;
  return float(saturated + std::sqrt(variance) * normal);
}

}  // namespace

void HandaNoise::Validate() const {
  for (const Vec3d& sigma : {sigma_shot, sigma_read}) {
    const bool good = sigma.x >= 0 && sigma.y >= 0 && sigma.z >= 0 && Norm(sigma) <= 1;
    if (!good) throw Error("handa noise: each standard deviation must be from 0 to 1");
  }
}

void AddNoise(const HandaNoise& model, const NoiseKey& key, Image<Vec3f>& signal) {
  const CounterRandom random = NoiseStream(key, NoiseUse::kColour);
  ParallelFor(signal.height(), [&](int y) {
    std::uint64_t index = 3 * std::uint64_t(y) * std::uint64_t(signal.width());
    for (int x = 0; x < signal.width(); ++x, index += 3) {
      Vec3f& value = signal(x, y);
      value.x = Noisy(value.x, model.sigma_shot.x, model.sigma_read.x, random.Normal(index));
      value.y = Noisy(value.y, model.sigma_shot.y, model.sigma_read.y, random.Normal(index + 1));
      value.z = Noisy(value.z, model.sigma_shot.z, model.sigma_read.z, random.Normal(index + 2));
    }
  });
}

}  // namespace silt::sim
