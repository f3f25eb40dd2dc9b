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

// What computes: the device's name, capability, driver and toolkit, and what it reaches in kernels
// that do nothing but copy or multiply. Of a CPU, nothing but the name.
JsonText DeviceFacts(const std::string& backend);

}  // namespace silt::dense
