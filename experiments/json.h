// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace silt::experiments {

// Keys stay in the order in which they were written.
using Json = nlohmann::ordered_json;

}  // namespace silt::experiments
