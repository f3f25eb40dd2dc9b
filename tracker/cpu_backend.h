// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "silt/tracker/backend.h"
#include "silt/tracker/simd_level.h"

namespace silt::tracker {

// The reductions on the processor, in tiles of rows on ParallelFor's threads.
// The processor must have the level.
std::unique_ptr<Backend> MakeCpuBackend(SimdLevel level = BestSimdLevel());

}  // namespace silt::tracker
