// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/experiments/accuracy.h"

namespace silt::experiments {

// The report as one HTML file that needs no other: tables beside the paper's, the figures and
// pictures found in `folder`, the manifest.
std::string AccuracyReport(const std::filesystem::path& folder, const AccuracyResult& result,
                           const Json& manifest);

}  // namespace silt::experiments
