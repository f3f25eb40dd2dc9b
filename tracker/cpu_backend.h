// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "silt/tracker/backend.h"

namespace silt::tracker {

// The reductions on the processor, in tiles of rows on ParallelFor's threads.
std::unique_ptr<Backend> MakeCpuBackend();

}  // namespace silt::tracker
