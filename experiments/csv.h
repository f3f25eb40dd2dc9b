// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/experiments/json.h"

namespace silt::experiments {

// A JSON list of flat objects as comma-separated values: the keys of the first object are the
// header, and all objects have these keys. Numbers have nine significant digits; null is empty.
std::string FormatCsv(const Json& rows);

}  // namespace silt::experiments
