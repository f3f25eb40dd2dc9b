// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

// What is told of a device that does not serve: one line each, without an end.
namespace silt::cuda {

// Of memory that it does not have.
std::string OutOfMemoryText(std::size_t bytes);

}  // namespace silt::cuda
