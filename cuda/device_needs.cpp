// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/device_needs.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <system_error>

#include "silt/core/error.h"

namespace silt::cuda {

namespace {

// What is compiled (cmake/SiltCuda.cmake) starts there.
constexpr int kMajor = 7, kMinor = 5;

std::string Capability(int major, int minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

}  // namespace

std::string VersionText(int version) {
  if (version == 0) return "none";
  return Capability(version / 1000, version % 1000 / 10);
}

std::string WhyNoDevice(int driver_version, int toolkit_version) {
  // A driver serves all toolkits of its own major version.
  if (driver_version == 0 || driver_version / 1000 >= toolkit_version / 1000) {
    return "no CUDA device is at hand";
  }
  return "the driver is too old: it knows CUDA " + VersionText(driver_version) +
         ", and this program was compiled with " + VersionText(toolkit_version);
}

std::string WhatLacks(const Device& device) {
  if (device.major < kMajor || (device.major == kMajor && device.minor < kMinor)) {
    return device.name + " is of compute capability " + Capability(device.major, device.minor) +
           ", and " + Capability(kMajor, kMinor) + " is needed";
  }
  if (!device.cooperative_launch) return device.name + " cannot launch cooperative kernels";
  if (!device.memory_pools) return device.name + " has no memory pools";
  return "";
}

int LimitedBlocks(int resident, const char* limit) {
  if (limit == nullptr) return resident;
  int blocks = 0;
  const char* const end = limit + std::strlen(limit);
  const auto [stop, error] = std::from_chars(limit, end, blocks);
  if (error != std::errc() || stop != end || blocks < 1) {
    throw Error("SILT_CUDA_BLOCKS: '" + std::string(limit) + "' is not a number above 0");
  }
  return std::min(resident, blocks);
}

std::string OutOfMemoryText(std::size_t bytes) {
  const std::size_t mebibytes = (bytes >> 20) + (bytes % (std::size_t(1) << 20) > 0 ? 1 : 0);
  return "CUDA: the device has no " + std::to_string(mebibytes) +
         " MiB left; use smaller images, fewer keyframes or fewer starts at once";
}

}  // namespace silt::cuda
