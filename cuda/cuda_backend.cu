// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/block_backend.h"
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#include "silt/cuda/gpu_machine.cuh"

namespace silt::cuda {

std::unique_ptr<const tracker::Backend> MakeCudaBackend() {
  if (DeviceList().empty()) {
    throw Error("--backend cuda: no CUDA device is at hand; use --backend cpu");
  }
  Check(cudaSetDevice(0), "choosing the first device");
  return std::make_unique<BlockBackend<GpuMachine>>("cuda", GpuMachine());
}

}  // namespace silt::cuda
