// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "silt/experiments/json.h"

namespace silt::experiments {

// To stdout. Throws silt::Error where it cannot be written (a full disk behind a redirection).
void Print(std::string_view text);

// Indented, whole or not at all; `-` is stdout.
void WriteJson(const std::filesystem::path& file, const Json& json);

// Throws silt::Error where the file is none or is no JSON.
Json ReadJson(const std::filesystem::path& file);

}  // namespace silt::experiments
