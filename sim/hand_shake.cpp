// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/hand_shake.h"

#include <numbers>
#include <string>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt::sim {

void HandShakeOptions::Validate() const {
  const auto refuse = [](const char* name, double value, const char* range) {
    throw Error(std::string(name) + " = " + std::to_string(value) + " must be " + range);
  };
  if (!(position_mm >= 0 && position_mm <= 100)) refuse("position_mm", position_mm, "in 0 … 100");
  if (!(rotation_deg >= 0 && rotation_deg <= 30)) refuse("rotation_deg", rotation_deg, "in 0 … 30");
  if (!(low_hz >= 1e-3 && low_hz < high_hz)) {
    refuse("low_hz", low_hz, "at least 0.001 and below high_hz");
  }
  if (!(high_hz <= 1000)) refuse("high_hz", high_hz, "at most 1000");
}

HandShake::HandShake(const HandShakeOptions& options) {
  options.Validate();
  constexpr double kTwoPi = 2 * std::numbers::pi;
  for (int axis = 0; axis < 6; ++axis) {
    const CounterRandom random(options.seed, std::uint64_t(axis));
    const double rms =
        axis < 3 ? options.position_mm / 1000 : options.rotation_deg * std::numbers::pi / 180;
    double power = 0;
    for (int i = 0; i < kSines; ++i) {
      const double place = (i + random.Uniform(2 * i)) / kSines;
      const double hz = options.low_hz * std::pow(options.high_hz / options.low_hz, place);
      // A band even in log f is as wide as f: 1/f² of density makes 1/f of power, ½·amplitude².
      const double amplitude = std::sqrt(1 / hz);
      power += amplitude * amplitude / 2;
      sines_.push_back({amplitude, kTwoPi * hz, kTwoPi * random.Uniform(2 * i + 1)});
    }
    const double scale = rms / std::sqrt(3 * power);
    for (int i = 0; i < kSines; ++i) sines_[axis * kSines + i].amplitude *= scale;
  }
}

}  // namespace silt::sim
