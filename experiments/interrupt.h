// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace silt::experiments {

// Thrown by ThrowIfInterrupted; unwinding removes what is half written.
struct Interrupted {
  std::string consequence = "nothing half written is left";
};

// From now on the first SIGINT or SIGTERM is only noted; a second one ends the process.
void CatchInterrupts();

// For loops that take long, between two pieces of work.
void ThrowIfInterrupted();

}  // namespace silt::experiments
