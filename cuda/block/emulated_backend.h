// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "silt/cuda/block/host_machine.h"
#include "silt/tracker/backend.h"

namespace silt::cuda {

// The GPU's code run by the CPU, block by block and thread by thread: slow, and the way to try it
// where there is no GPU. It counts in `use`, if that is given.
std::unique_ptr<const tracker::Backend> MakeEmulatedBackend(
    ThreadOrder order = ThreadOrder::kForward, std::shared_ptr<MachineUse> use = nullptr);

}  // namespace silt::cuda
