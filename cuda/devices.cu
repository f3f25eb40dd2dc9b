// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/check.cuh"
#include "silt/cuda/devices.h"

namespace silt::cuda {
namespace {

std::string VersionText(int version) {
  if (version == 0) return "none";
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

}  // namespace

std::vector<Device> DeviceList() {
  int count = 0;
  const cudaError_t status = cudaGetDeviceCount(&count);
  if (status == cudaErrorNoDevice || status == cudaErrorInsufficientDriver) {
    ForgetLastError();  // no GPU is an answer, not an error to be kept
    return {};
  }
  Check(status, "counting devices");
  std::vector<Device> devices;
  for (int i = 0; i < count; ++i) {
    cudaDeviceProp properties;
    Check(cudaGetDeviceProperties(&properties, i), "asking for a device's properties");
    devices.push_back(
        {properties.name, properties.major, properties.minor, properties.totalGlobalMem});
  }
  return devices;
}

Versions DriverAndToolkit() {
  int driver = 0;
  Check(cudaDriverGetVersion(&driver), "asking for the driver's version");
  return {VersionText(driver), VersionText(CUDART_VERSION)};
}

}  // namespace silt::cuda
