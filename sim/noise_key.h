// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/random.h"

namespace silt::sim {

// What must differ for two pictures to have independent noise.
struct NoiseKey {
  std::uint64_t seed = 0;
  std::uint32_t frame = 0;
};

// Uses of randomness in one frame that must be independent of each other.
enum class NoiseUse : std::uint32_t {
  kColour = 0,
  kShot,
  kRead,
  kPhotoResponse,
  kDark,
  kDepth,
  kDepthColumn,
  kDepthRow,
};

inline CounterRandom NoiseStream(const NoiseKey& key, NoiseUse use) {
  return CounterRandom(key.seed, std::uint64_t(use) << 32 | key.frame);
}

}  // namespace silt::sim
