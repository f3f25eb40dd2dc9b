// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/vector.h"

namespace silt::sim {

// Random numbers of one path among many that estimate the same value. Those of equal position in
// the paths 0 … 2^m − 1 of one key are a (0, m, 2)-net in base 2 (or a (0, m, 1)-net): Sobol's
// first two dimensions with hashed Owen scrambling, each pair shuffled against the others (Burley
// 2020, "Practical hash-based Owen scrambling"). A pure function of (key, index, position).
class PathSampler {
 public:
  PathSampler() = default;
  PathSampler(std::uint64_t key, std::uint32_t index) : key_(key), index_(index) {}

  // In [0, 1).
  float Next();
  Vec2f Next2();

 private:
  std::uint32_t NextSeed();

  std::uint64_t key_ = 0;
  std::uint32_t index_ = 0, position_ = 0;
};

}  // namespace silt::sim
