// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/check.cuh"
#include "silt/cuda/device_needs.h"
#include "silt/cuda/devices.h"

namespace silt::cuda {
namespace {

int DriverVersion() {
  int version = 0;
  Check(cudaDriverGetVersion(&version), "asking for the driver's version");
  return version;
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
    int memory_pools = 0;
    Check(cudaDeviceGetAttribute(&memory_pools, cudaDevAttrMemoryPoolsSupported, i),
          "asking for a device's memory pools");
    devices.push_back({properties.name, properties.major, properties.minor,
                       properties.totalGlobalMem, properties.cooperativeLaunch != 0,
                       memory_pools != 0});
  }
  return devices;
}

std::string WhyNoUsableDevice() {
  const std::vector<Device> devices = DeviceList();
  if (devices.empty()) return WhyNoDevice(DriverVersion(), CUDART_VERSION);
  return WhatLacks(devices.front());
}

Versions DriverAndToolkit() { return {VersionText(DriverVersion()), VersionText(CUDART_VERSION)}; }

}  // namespace silt::cuda
