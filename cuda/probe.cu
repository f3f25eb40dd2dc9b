// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/device_array.cuh"
#include "silt/cuda/probe.h"
#include "silt/tracker/kernel/image_sampler.h"

namespace silt::cuda {
namespace {

namespace kernel = tracker::kernel;

constexpr int kThreads = 64;
constexpr int kBlocks = 32;

template <typename T>
__device__ void AddTo(kernel::Sums<T>* total, const kernel::Sums<T>& part) {
  for (int i = 0; i < kernel::kHessianSize; ++i) total->hessian[i] += part.hessian[i];
  for (int i = 0; i < kernel::kGradientSize; ++i) total->gradient[i] += part.gradient[i];
  total->cost.squares += part.cost.squares;
  total->cost.count += part.cost.count;
}

// Halves the number of partial sums until the first holds them all: an order of addition that
// depends on the size of the block alone.
template <typename T>
__device__ void ReduceBlock(kernel::Sums<T>* partial) {
  for (int half = kThreads / 2; half > 0; half /= 2) {
    __syncthreads();
    if (int(threadIdx.x) < half) AddTo(&partial[threadIdx.x], partial[threadIdx.x + half]);
  }
}

template <typename T>
struct Work {
  kernel::Warp<T> warp;
  kernel::ImageSampler<T> sampler;
  const kernel::ReferencePixel<T>* pixels;
  int count;
};

// Thread i of all takes the pixels i, i + threads, …; writes one sum per block.
template <typename T>
__global__ void __launch_bounds__(kThreads)
    LinearizePixels(Work<T> work, kernel::LinearizedResidual<T>* residuals,
                    kernel::Sums<T>* block_sums) {
  __shared__ alignas(16) unsigned char storage[kThreads * sizeof(kernel::Sums<T>)];
  auto* partial = reinterpret_cast<kernel::Sums<T>*>(storage);
  kernel::Sums<T> sums;
  for (int i = int(blockIdx.x) * kThreads + int(threadIdx.x); i < work.count;
       i += kThreads * kBlocks) {
    residuals[i] = kernel::Linearize(work.warp, work.sampler, work.pixels[i]);
    sums.Add(residuals[i]);
  }
  partial[threadIdx.x] = sums;
  ReduceBlock(partial);
  if (threadIdx.x == 0) block_sums[blockIdx.x] = partial[0];
}

template <typename T>
kernel::Sums<T> AddInOrder(const std::vector<kernel::Sums<T>>& blocks) {
  kernel::Sums<T> total;
  for (const kernel::Sums<T>& block : blocks) {
    for (int i = 0; i < kernel::kHessianSize; ++i) total.hessian[i] += block.hessian[i];
    for (int i = 0; i < kernel::kGradientSize; ++i) total.gradient[i] += block.gradient[i];
    total.cost.squares += block.cost.squares;
    total.cost.count += block.cost.count;
  }
  return total;
}

}  // namespace

template <typename T>
ProbeResult<T> Probe(const ProbeInput<T>& input) {
  const Image<float>& image = input.current_intensity;
  SILT_CHECK(image.width() >= 2 && image.height() >= 2);
  const DeviceArray<float> pixels(image.data(), image.size());
  const DeviceArray<kernel::ReferencePixel<T>> points(input.pixels.data(), input.pixels.size());
  DeviceArray<kernel::LinearizedResidual<T>> residuals(input.pixels.size());
  DeviceArray<kernel::Sums<T>> block_sums(kBlocks);
  const kernel::Warp<double> warp(input.current_from_reference, input.camera);
  const Work<T> work{kernel::Warp<T>(warp),
                     {pixels.data(), image.width(), image.height()},
                     points.data(),
                     int(input.pixels.size())};
  LinearizePixels<T><<<kBlocks, kThreads>>>(work, residuals.data(), block_sums.data());
  Check(cudaGetLastError(), "starting the probe kernel");
  return {residuals.ToHost(), AddInOrder(block_sums.ToHost())};
}

template ProbeResult<float> Probe(const ProbeInput<float>&);
template ProbeResult<double> Probe(const ProbeInput<double>&);

}  // namespace silt::cuda
