// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/program.h"

int main(int argc, char** argv) { return silt::experiments::RunProgram(argc, argv); }
