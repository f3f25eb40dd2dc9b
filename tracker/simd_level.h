// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace silt::tracker {

// Instruction sets for which the CPU backend's sums are compiled. All give the same bits.
enum class SimdLevel { kBaseline, kAvx2, kAvx512 };

// What this processor offers, slowest first.
std::vector<SimdLevel> SupportedSimdLevels();
SimdLevel BestSimdLevel();

// "sse2", "avx2", "avx512"; the baseline of other architectures is called "baseline".
std::string Name(SimdLevel level);

// The level of that name, or the best for "auto". Throws silt::Error where this processor does not
// have it.
SimdLevel SimdLevelFromName(const std::string& name);

}  // namespace silt::tracker
