// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/sim/depth_view.h"

namespace silt::sim {

// Where a depth camera of structured light measures nothing. Each is off unless asked for.
struct DepthDropouts {
  double grazing_deg = 90;  // rays that meet a surface at more than this off its normal; 90: off
  // Pixels within edge_px of a depth that is farther or nearer by more than this share; 0: off.
  double edge_share = 0;
  int edge_px = 1;
  // What the projector, so far to the right of the camera, cannot light; 0: off.
  double shadow_baseline_m = 0;

  bool AreNone() const { return grazing_deg == 90 && edge_share == 0 && shadow_baseline_m == 0; }
  void Validate() const;  // throws silt::Error

  // As a Kinect has them: its projector stands 7.5 cm from its camera.
  static DepthDropouts Kinect() { return {80, 0.05, 1, 0.075}; }
};

// Sets a measured depth to 0 where it drops out.
void DropOut(const DepthDropouts& dropouts, const DepthView& view, Image<float>& measured_m);

}  // namespace silt::sim
