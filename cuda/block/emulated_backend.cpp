// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/emulated_backend.h"

#include <utility>

#include "silt/cuda/block/block_backend.h"

namespace silt::cuda {

std::unique_ptr<const tracker::Backend> MakeEmulatedBackend(ThreadOrder order,
                                                            std::shared_ptr<MachineUse> use) {
  return std::make_unique<BlockBackend<HostMachine>>("cuda-emulated",
                                                     HostMachine(order, std::move(use)));
}

}  // namespace silt::cuda
