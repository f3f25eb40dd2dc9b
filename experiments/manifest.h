// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "silt/experiments/json.h"

namespace silt::experiments {

// What this build and machine are: version, commit, compiler and flags, processor, threads, SIMD
// level, CUDA, versions of the libraries.
Json BuildFacts();

// What a run writes beside its results, so that it can be repeated: the command line, the resolved
// configuration, the seed, the date and BuildFacts.
Json MakeManifest(const std::string& command_line, const Json& config, std::uint64_t seed);

}  // namespace silt::experiments
