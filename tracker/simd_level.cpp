// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd_level.h"

#include "silt/core/error.h"

namespace silt::tracker {

std::vector<SimdLevel> SupportedSimdLevels() {
  std::vector<SimdLevel> levels{SimdLevel::kBaseline};
#if defined(__x86_64__)
  // xsimd's own detection takes an old processor for one with AVX.
  if (__builtin_cpu_supports("avx2")) levels.push_back(SimdLevel::kAvx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
    levels.push_back(SimdLevel::kAvx512);
  }
#endif
  return levels;
}

SimdLevel BestSimdLevel() { return SupportedSimdLevels().back(); }

std::string Name(SimdLevel level) {
  switch (level) {
    case SimdLevel::kAvx2:
      return "avx2";
    case SimdLevel::kAvx512:
      return "avx512";
    case SimdLevel::kBaseline:
      break;
  }
#if defined(__x86_64__)
  return "sse2";
#else
  return "baseline";
#endif
}

SimdLevel SimdLevelFromName(const std::string& name) {
  if (name == "auto") return BestSimdLevel();
  std::string known = "auto";
  for (const SimdLevel level : SupportedSimdLevels()) {
    if (name == Name(level)) return level;
    known += ", " + Name(level);
  }
  throw Error("SIMD level '" + name + "': this processor has " + known);
}

}  // namespace silt::tracker
