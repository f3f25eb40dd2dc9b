// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "silt/dense/json_text.h"
#include "silt/tracker/backend.h"

namespace silt::dense {

// cpu, cuda or cuda-emulated. Throws silt::Error for others, and for cuda where there is no device.
std::shared_ptr<const tracker::Backend> MakeBackend(const std::string& name);

// What the device of a backend reaches in kernels that do nothing else; zeros where that is not
// measured, as of a CPU.
struct Ceilings {
  double bytes_per_s = 0;           // read and written, by a copy
  double operations_per_s = 0;      // multiplications and additions apart, as silt's kernels
  double fma_operations_per_s = 0;  // fused, each counted as two
};
Ceilings MeasureCeilings(const std::string& backend);

// What computes: the device's name, capability, driver and toolkit, and its ceilings. Of a CPU,
// nothing but the name.
JsonText DeviceFacts(const std::string& backend, const Ceilings& ceilings);

}  // namespace silt::dense
