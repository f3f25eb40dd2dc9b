// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "analytic_room.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/keyframe_tracker.h"

// A walk through the analytic room in small images, and a tracker that starts with it.
namespace silt::tracker {

inline const SE3d kStart{Quaterniond::Exp({0.1, 0.3, 0}), {0.1, 0, -0.4}};

// A walk of small steps, 3 cm and 1° a frame.
inline SE3d TruePose(int frame) {
  const double s = frame;
  return kStart * SE3d::Exp({{0.004 * s, 0.017 * s, 0}, {0.03 * s, 0.004 * s, 0.005 * s}});
}

inline TrackerOptions SmallImages() {
  TrackerOptions options;
  options.alignment.max_iterations = {10, 10, 20};
  return options;
}

inline KeyframeTracker MakeTracker(std::unique_ptr<Initializer> initializer = nullptr,
                                   const TrackerOptions& options = SmallImages()) {
  return KeyframeTracker(kSmallCamera, options, MakeCpuBackend(), std::move(initializer), kStart);
}

inline Frame BlackFrame() { return {0, Image<Rgb8>(160, 120), Image<float>(160, 120, 1.0f)}; }

}  // namespace silt::tracker
