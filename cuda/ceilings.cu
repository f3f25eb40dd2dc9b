// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "silt/cuda/ceilings.h"
#include "silt/cuda/device_array.cuh"
#include "silt/cuda/event_timer.cuh"

namespace silt::cuda {
namespace {

constexpr int kRepeats = 10, kBlocks = 2048, kThreadsOfBlock = 256;
constexpr std::size_t kVectors = std::size_t(1) << 24;  // of 16 bytes: far more than a cache holds
constexpr int kSteps = 4096, kChains = 8;

__global__ void Copy(const float4* from, float4* to, std::size_t n) {
  const std::size_t step = std::size_t(gridDim.x) * blockDim.x;
  for (std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x; i < n; i += step) {
    to[i] = from[i];
  }
}

// Independent chains, so that none waits for another.
template <bool kFused>
__global__ void Multiply(float factor, float* out) {
  float x[kChains];
  for (int k = 0; k < kChains; ++k) x[k] = float(threadIdx.x + k);
  for (int i = 0; i < kSteps; ++i) {
#pragma unroll
    for (int k = 0; k < kChains; ++k) {
      x[k] = kFused ? __fmaf_rn(x[k], factor, 1.0f) : __fadd_rn(__fmul_rn(x[k], factor), 1.0f);
    }
  }
  float sum = 0;
  for (int k = 0; k < kChains; ++k) sum += x[k];
  out[blockIdx.x * blockDim.x + threadIdx.x] = sum;
}

// Of the first run, which warms up, nothing is kept.
template <typename Launch>
double BestSeconds(const Launch& launch) {
  double best = 0;
  for (int i = 0; i <= kRepeats; ++i) {
    EventTimer timer;
    timer.Start(nullptr);
    launch();
    Check(cudaGetLastError(), "starting a kernel");
    timer.Stop(nullptr);
    const double seconds = timer.Milliseconds() / 1000;
    if (i == 1 || (i > 1 && seconds < best)) best = seconds;
  }
  return best;
}

}  // namespace

Ceilings MeasureCeilings() {
  DeviceArray<float4> from(kVectors), to(kVectors);
  Check(cudaMemset(from.data(), 0, kVectors * sizeof(float4)), "clearing memory");
  DeviceArray<float> out(std::size_t(kBlocks) * kThreadsOfBlock);
  const double bytes = 2.0 * double(kVectors * sizeof(float4));
  const double operations = 2.0 * kBlocks * kThreadsOfBlock * double(kSteps) * kChains;
  Ceilings ceilings;
  ceilings.bytes_per_s = bytes / BestSeconds([&] {
                           Copy<<<kBlocks, kThreadsOfBlock>>>(from.data(), to.data(), kVectors);
                         });
  ceilings.operations_per_s = operations / BestSeconds([&] {
                                Multiply<true><<<kBlocks, kThreadsOfBlock>>>(0.5f, out.data());
                              });
  ceilings.operations_no_fma_per_s =
      operations /
      BestSeconds([&] { Multiply<false><<<kBlocks, kThreadsOfBlock>>>(0.5f, out.data()); });
  return ceilings;
}

}  // namespace silt::cuda
