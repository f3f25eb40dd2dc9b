// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace silt::experiments {

// RFC 4648, with padding: for pictures inside HTML.
std::string Base64(std::string_view bytes);

}  // namespace silt::experiments
