// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/error.h"

namespace silt::error_detail {

void CheckFailed(const char* condition, const char* file, int line) {
  throw std::logic_error(std::string("contract broken: ") + condition + " at " + file + ":" +
                         std::to_string(line));
}

}  // namespace silt::error_detail
