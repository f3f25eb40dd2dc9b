// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/tracker/robust_loss.h"

namespace silt::tracker {

// What a residual counts: see kernel/robust_norm.h. Neither bound given: ½r².
struct RobustBounds {
  double gradient = 0;  // g; 0: a steep gradient makes no residual less certain
  double scale = 0;     // c; 0: no residual is too large
  double weight = 1;    // of these residuals among others
  RobustLoss loss = RobustLoss::kGemanMcClure;
};

// The reference's intensity I counts as gain·I + offset: exposures differ.
struct Brightness {
  double gain = 1, offset = 0;
  bool operator==(const Brightness&) const = default;
};

struct ResidualNorm {
  RobustBounds intensity;      // intensity, and intensity per pixel
  RobustBounds inverse_depth;  // 1/m, and 1/m per pixel
  bool use_depth = false;      // residuals of the inverse depth as well
  Brightness brightness;
  bool fit_brightness = false;  // finds one that fits better; of a robust norm
  // This share of the intensity's gradient is the reference's at the pixel, the rest the current
  // image's where it lands.
  double reference_gradient = 0;

  SILT_HOST_DEVICE bool robust() const {
    return use_depth || intensity.gradient > 0 || intensity.scale > 0;
  }
};

}  // namespace silt::tracker
