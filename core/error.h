// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace silt {

// What a user can mend: a bad file, option, device or disk. The message is one line that names the
// file, the place in it and the mend; programs print it and exit with a status other than 0.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Text from a file as a message may show it: in quotes, at most 40 characters of it, the
// unprintable ones as '?'.
std::string Quoted(std::string_view text);

namespace error_detail {
[[noreturn]] void CheckFailed(const char* condition, const char* file, int line);
}

}  // namespace silt

// A contract between functions; breaking it is a defect of the program, not of its input.
#define SILT_CHECK(condition) \
  ((condition) ? void() : ::silt::error_detail::CheckFailed(#condition, __FILE__, __LINE__))
