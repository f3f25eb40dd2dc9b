// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/device_needs.h"

namespace silt::cuda {

std::string OutOfMemoryText(std::size_t bytes) {
  const std::size_t mebibytes = (bytes >> 20) + (bytes % (std::size_t(1) << 20) > 0 ? 1 : 0);
  return "CUDA: the device has no " + std::to_string(mebibytes) +
         " MiB left; use smaller images, fewer keyframes or fewer starts at once";
}

}  // namespace silt::cuda
