// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace silt {

// Calls body(i) once for every i in [0, n), on as many threads as SetThreadCount allows. Bodies
// write to places of their own; a sum is kept per i and added up in order afterwards, so that
// results do not depend on the number of threads. An exception from a body reaches the caller.
void ParallelFor(int n, const std::function<void(int)>& body);

// Limits ParallelFor, and all else that runs on TBB, to `threads` threads of this process; 0: one
// per processor. A program calls it once, before it starts work.
void SetThreadCount(int threads);
int ThreadCount();

}  // namespace silt
