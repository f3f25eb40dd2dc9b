// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/error.h"

namespace silt {

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string quoted = "'";
  for (char c : text.substr(0, kLongest)) quoted += c >= 0x20 && c < 0x7f ? c : '?';
  return quoted + (text.size() > kLongest ? "...'" : "'");
}

namespace error_detail {

void CheckFailed(const char* condition, const char* file, int line) {
  throw std::logic_error(std::string("contract broken: ") + condition + " at " + file + ":" +
                         std::to_string(line));
}

}  // namespace error_detail
}  // namespace silt
