// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::experiments {

// The program `silt`: parses the command line, runs the command and returns the exit code: 0; 1 for
// a failure and 2 for a wrong command line, each told in one line on stderr; 130 when interrupted.
int RunProgram(int argc, const char* const* argv);

}  // namespace silt::experiments
