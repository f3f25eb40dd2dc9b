// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

// Marks a function that the CPU and, when nvcc compiles it, the GPU may call.
#ifdef __CUDACC__
#define SILT_HOST_DEVICE __host__ __device__
#else
#define SILT_HOST_DEVICE
#endif

// Before a loop over a small array: on the GPU its elements then lie in registers.
#ifdef __CUDA_ARCH__
#define SILT_UNROLL _Pragma("unroll")
#else
#define SILT_UNROLL
#endif
