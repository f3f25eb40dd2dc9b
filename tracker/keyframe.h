// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/frame.h"
#include "silt/core/image.h"
#include "silt/core/memory_pool.h"
#include "silt/core/se3.h"
#include "silt/tracker/options.h"
#include "silt/tracker/pose_covariance.h"

namespace silt::tracker {

// A frame whose depth the tracker uses: r_j of the paper.
struct Keyframe {
  int id = 0;  // counts from 0 in the order of creation
  Frame frame;
  Image<float> intensity;    // of frame.rgb, in [0, 1]; empty until an initializer needs it
  SE3d world_from_camera;    // T_wr, as estimated
  Covariance6 covariance{};  // of it, in its camera's frame
};

// By id.
using KeyframeIds = PooledVector<int>;

// Indices of the `count` keyframes, or fewer where there are not so many, whose cameras are nearest
// in position to that of `world_from_camera`, with a turn counted as options.metres_per_radian;
// nearest first, the earlier one of two at the same distance. Beyond the first, those that are
// farther than three times options.max_distance_m are left out.
KeyframeIds NearestKeyframes(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                             const KeyframeOptions& options, int count);
// The first of them. `keyframes` must not be empty.
int NearestKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                    const KeyframeOptions& options = {});

// The rule of §3.1: the camera is farther than the threshold from every keyframe, or the sum of its
// rotations about x, y and z since the last created keyframe exceeds the threshold.
bool NeedsKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                   const KeyframeOptions& options);

}  // namespace silt::tracker
