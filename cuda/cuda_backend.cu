// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/block_backend.h"
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#include "silt/cuda/gpu_machine.cuh"

namespace silt::cuda {

std::unique_ptr<const tracker::Backend> MakeCudaBackend() {
  const std::string why_not = WhyNoUsableDevice();
  if (!why_not.empty()) throw Error("--backend cuda: " + why_not + "; use --backend cpu");
  Check(cudaSetDevice(0), "choosing the first device");
  return std::make_unique<BlockBackend<GpuMachine>>("cuda", GpuMachine());
}

}  // namespace silt::cuda
