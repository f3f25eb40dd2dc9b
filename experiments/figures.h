// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace silt::experiments {

// Runs a script of experiments/figures with Debian's Python, which has matplotlib, on a folder of
// results; it writes figures/*.svg there. Where it cannot, one warning is logged and false
// returned: results do not depend on figures.
bool DrawFigures(const std::string& script, const std::filesystem::path& folder);

}  // namespace silt::experiments
