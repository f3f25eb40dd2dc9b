// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include <cstdio>
#include <string>

#include "silt/core/error.h"

namespace silt::cuda {

// An error that is told is not to be found again by the next check.
inline void ForgetLastError() noexcept { (void)cudaGetLastError(); }

// Every call of CUDA's goes through one of these.
inline void Check(cudaError_t status, const char* what) {
  if (status == cudaSuccess) return;
  ForgetLastError();
  throw Error(std::string("CUDA: ") + what + ": " + cudaGetErrorString(status));
}

// Where nothing may be thrown, as in destructors: what fails is told on stderr. At the end of the
// process the runtime may be gone already, and all that it held with it.
inline void Report(cudaError_t status, const char* what) noexcept {
  if (status == cudaSuccess || status == cudaErrorCudartUnloading) return;
  std::fprintf(stderr, "CUDA: %s: %s\n", what, cudaGetErrorString(status));
}

}  // namespace silt::cuda
