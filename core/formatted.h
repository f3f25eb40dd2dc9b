// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace silt {

// As printf would print it, at any length, with the arguments checked by the compiler.
[[gnu::format(printf, 1, 2)]] std::string Formatted(const char* format, ...);

}  // namespace silt
