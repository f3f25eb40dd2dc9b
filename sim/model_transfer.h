// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "silt/sim/model_import.h"

// A model as bytes, for the pipe between two processes of one program on one machine: no format for
// files.
namespace silt::sim {

std::string ModelToBytes(const Model& model);

// Trusts nothing: throws silt::Error where the bytes are no whole model, an index leads nowhere or
// a number is not finite.
Model ModelFromBytes(std::string_view bytes);

}  // namespace silt::sim
