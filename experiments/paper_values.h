// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

namespace silt::experiments {

// One column of a table of the paper, as printed there.
struct PaperColumn {
  const char* rmse;
  const char* max;
  const char* min;
  const char* mean;
  const char* median;
  const char* std_dev;
};

// Table 2 [cm]; it states no minimum.
const PaperColumn* PaperPosition(const std::string& sequence);

// Table 3 [deg] about x, y, z. The printed minimum about z of 60fps-blur, 0.40, lies above the
// mean: a misprint that is left as it is.
const PaperColumn* PaperOrientation(const std::string& sequence, int axis);

}  // namespace silt::experiments
