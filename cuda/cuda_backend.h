// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "silt/tracker/backend.h"

namespace silt::cuda {

// The tracker on the first GPU. Throws silt::Error where there is none that can serve it.
std::unique_ptr<const tracker::Backend> MakeCudaBackend();

}  // namespace silt::cuda
