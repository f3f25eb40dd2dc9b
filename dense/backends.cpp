// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/backends.h"

#include "silt/core/error.h"
#include "silt/cuda/block/emulated_backend.h"
#include "silt/tracker/cpu_backend.h"
#ifdef SILT_HAVE_CUDA
#include "silt/cuda/ceilings.h"
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#endif

namespace silt::dense {

std::shared_ptr<const tracker::Backend> MakeBackend(const std::string& name) {
  if (name == "cpu") return tracker::MakeCpuBackend();
  if (name == "cuda-emulated") return cuda::MakeEmulatedBackend();
#ifdef SILT_HAVE_CUDA
  if (name == "cuda") return cuda::MakeCudaBackend();
#else
  if (name == "cuda") {
    throw Error("--backend cuda: this build was made without nvcc; use --backend cpu");
  }
#endif
  throw Error("no backend is named '" + name + "'; there are: cpu, cuda, cuda-emulated");
}

Ceilings MeasureCeilings(const std::string& backend) {
#ifdef SILT_HAVE_CUDA
  if (backend == "cuda") {
    const cuda::Ceilings measured = cuda::MeasureCeilings();
    return {measured.bytes_per_s, measured.operations_no_fma_per_s, measured.operations_per_s};
  }
#else
  (void)backend;
#endif
  return {};
}

JsonText DeviceFacts(const std::string& backend, const Ceilings& ceilings) {
  JsonText facts;
  facts.Add("backend", backend);
#ifdef SILT_HAVE_CUDA
  if (backend != "cuda") return facts;
  const cuda::Device device = cuda::DeviceList().at(0);
  const cuda::Versions versions = cuda::DriverAndToolkit();
  facts.Add("device", device.name)
      .Add("capability", std::to_string(device.major) + "." + std::to_string(device.minor))
      .Add("driver", versions.driver)
      .Add("toolkit", versions.toolkit)
      .Add("copy_bytes_per_s", ceilings.bytes_per_s)
      .Add("fma_operations_per_s", ceilings.fma_operations_per_s)
      .Add("multiply_add_operations_per_s", ceilings.operations_per_s);
#else
  (void)ceilings;
#endif
  return facts;
}

}  // namespace silt::dense
