// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/emulated_backend.h"

#include "silt/cuda/block_backend.h"

namespace silt::cuda {

std::unique_ptr<const tracker::Backend> MakeEmulatedBackend(ThreadOrder order) {
  return std::make_unique<BlockBackend<HostMachine>>("cuda-emulated", HostMachine(order));
}

}  // namespace silt::cuda
