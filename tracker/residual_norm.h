// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// What a residual counts: see kernel/robust_norm.h. Neither given: ½r².
struct ResidualNorm {
  double gradient =
      0;             // g: intensity per pixel; 0: a steep gradient makes no residual less certain
  double scale = 0;  // c: intensity; 0: no residual is too large

  bool robust() const { return gradient > 0 || scale > 0; }
};

}  // namespace silt::tracker
