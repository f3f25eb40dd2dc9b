// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace silt::cuda {

struct Device {
  std::string name;
  int major = 0, minor = 0;  // compute capability
  std::size_t memory_bytes = 0;
  bool cooperative_launch = false;  // all blocks of a kernel at once, so that they can meet
  bool memory_pools = false;        // memory in the order of a stream
};

// The GPUs that this process may use, in CUDA's order; none where there is no GPU or no driver.
// Throws silt::Error where a driver is there and fails.
std::vector<Device> DeviceList();

// Why the first of them cannot serve the tracker, in words without an end: that there is none, or
// that the driver is too old, or what the device lacks. Empty where it can.
std::string WhyNoUsableDevice();

// What CUDA the driver knows, and what this program was compiled with: "13.0". The driver's is
// "none" where there is none.
struct Versions {
  std::string driver, toolkit;
};
Versions DriverAndToolkit();

}  // namespace silt::cuda
