// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/frame.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/options.h"

namespace silt::tracker {

// A frame whose depth the tracker uses: r_j of the paper.
struct Keyframe {
  int id = 0;  // counts from 0 in the order of creation
  Frame frame;
  Image<float> intensity;  // of frame.rgb, in [0, 1]
  SE3d world_from_camera;  // T_wr, as estimated
};

// Index of the keyframe whose camera is nearest in position to that of `world_from_camera`; the
// earlier one of two at the same distance. `keyframes` must not be empty.
int NearestKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera);

// The rule of §3.1: the camera is farther than the threshold from every keyframe, or the sum of its
// rotations about x, y and z since the last created keyframe exceeds the threshold.
bool NeedsKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                   const KeyframeOptions& options);

}  // namespace silt::tracker
