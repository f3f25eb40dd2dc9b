// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/experiments/json.h"

// The test of OpenCV's own odometries (modules/rgbd/test/test_odometry.cpp): one RGB-D frame and
// random small motions of it, each to be found from no motion at all.
namespace silt::experiments {

inline constexpr double kTrialMinTurn_rad = 0.007;
inline constexpr double kTrialMaxTurn_rad = 3 * 3.14159265358979323846 / 180;
inline constexpr double kTrialMinShift_m = 0.008;
inline constexpr double kTrialMaxShift_m = 0.02;

// A turn about a random axis and a shift in a random direction, of uniform magnitudes between
// the least and the greatest: rounded to pixels, a smaller motion would hardly show. A pure
// function of its arguments.
SE3d TrialMotion(std::uint64_t seed, int index);

// What the moved camera sees of the frame's points: each is drawn at the pixel nearest to where it
// lands, the nearest point of a pixel wins, and pixels without one that touch one with (up, down,
// left, right, across) get the mean of the least and the greatest value around them.
Frame ForwardWarp(const Frame& frame, const PinholeCamera& camera, const SE3d& current_from_frame);

struct TrialError {
  double motion_rad = 0, motion_m = 0;  // of the true motion's rotation vector and translation
  double error_rad = 0, error_m = 0;    // of what was found
};

struct OdometryTrial {
  std::string preset, current;  // "warped" or "rendered"
  std::vector<TrialError> errors;

  int BelowMotion() const;                // both errors below the motion
  int Below(double rad, double m) const;  // both errors below these
  TrialError Worst() const;               // the greatest errors of all
};

// Where the current frame of a motion comes from.
using MovedFrame = std::function<Frame(const SE3d& current_from_frame)>;

// Tracks from the frame to each of `count` moved frames. Where the tracker is lost, it counts as
// one that found no motion.
OdometryTrial RunTrial(const Frame& frame, const PinholeCamera& camera, const MovedFrame& moved,
                       const std::string& preset, int count, std::uint64_t seed);

Json TrialRows(const std::vector<OdometryTrial>& trials);
std::string FormatTrials(const std::vector<OdometryTrial>& trials);

}  // namespace silt::experiments
