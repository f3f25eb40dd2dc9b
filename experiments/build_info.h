// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace silt::experiments {

// What the build knew of itself. Commit() is taken at each build: "unknown" outside a git checkout,
// with "-dirty" behind it where tracked files had been changed.
extern const char* const kVersion;
extern const char* const kCompiler;
extern const char* const kCompilerFlags;
extern const char* const kSourceFolder;
extern const bool kHasCuda;
std::string Commit();

}  // namespace silt::experiments
