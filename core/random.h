// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace silt {

// Random numbers as a pure function of what they are for: the same (seed, stream, index) gives the
// same value whatever the thread, the order or the number of draws elsewhere.
class CounterRandom {
 public:
  // `stream` separates uses that must be independent: a frame, a pixel, an experiment's case.
  explicit CounterRandom(std::uint64_t seed, std::uint64_t stream = 0)
      : key_(Mix(Mix(seed + kGolden) ^ (stream + kGolden))) {}

  std::uint64_t Bits(std::uint64_t index) const { return Mix(key_ + (index + 1) * kGolden); }

  // Uniform in [0, 1), 53 bits.
  double Uniform(std::uint64_t index) const { return double(Bits(index) >> 11) * 0x1p-53; }

  // Standard normal, by Box and Muller; uses the sub-indices 2i and 2i + 1.
  double Normal(std::uint64_t index) const {
    const double radius = std::sqrt(-2 * std::log(1 - Uniform(2 * index)));
    return radius * std::cos(2 * 3.14159265358979323846 * Uniform(2 * index + 1));
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;

  // The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint64_t Mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
};

}  // namespace silt
