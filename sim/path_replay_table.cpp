// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>
#include <string>

#include "silt/core/error.h"
#include "silt/sim/path_tables.h"

namespace silt::sim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kFarthest_m = 1e6;

double NumberIn(const TomlTable& table, const std::string& key, double fallback, double low,
                double high) {
  const double value = table.Number(key, fallback);
  if (value < low || value > high) {
    table.Fail(key, "must be in " + std::to_string(low) + " … " + std::to_string(high));
  }
  return value;
}

// The poses of the file from start_s on, for duration_s, on its own clock.
Trajectory ReadStretch(const TomlTable& replay, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / replay.String("file");
  Trajectory recorded;
  try {
    recorded = ReadTumTrajectory(file);
  } catch (const Error& error) {
    throw Error(replay.PlaceOf("file") + ": " + error.what());
  }
  if (recorded.size() < 2) replay.Fail("file", "holds fewer than two poses: " + file.string());
  const double begin_s = recorded.front().time_s;
  const double whole_s = recorded.back().time_s - begin_s;
  const double start_s = NumberIn(replay, "start_s", 0, 0, whole_s);
  const double rest_s = whole_s - start_s;
  const double duration_s = NumberIn(replay, "duration_s", rest_s, 0, rest_s + 1e-6);
  Trajectory stretch;
  for (const StampedPose& pose : recorded) {
    if (!(Norm(pose.world_from_camera.translation) < kFarthest_m)) {
      replay.Fail("file", "leads farther than 1000 km away: " + file.string());
    }
    const double time_s = pose.time_s - begin_s - start_s;
    if (time_s >= -1e-6 && time_s <= duration_s + 1e-6) stretch.push_back(pose);
  }
  if (stretch.size() < 2) replay.Fail("duration_s", "leaves fewer than two poses of the recording");
  return stretch;
}

// The pose that the first one becomes, given that pose with its distances scaled.
SE3d FirstPose(const TomlTable& replay, const SE3d& recorded) {
  const Vec3d position = replay.Vector("position", recorded.translation);
  if (replay.Has("look_at") || replay.Has("quaternion")) {
    if (replay.Has("yaw_deg")) replay.Fail("yaw_deg", "excludes look_at and quaternion");
    return {ReadRotationAt(replay, position), position};
  }
  const Vec3d turn{0, 0, kRadians * replay.Number("yaw_deg", 0)};
  return {Quaterniond::Exp(turn) * recorded.rotation, position};
}

// world_from_camera = world_from_recorded·recorded_from_camera, distances scaled, time by 1/speed.
Trajectory Placed(const TomlTable& replay, Trajectory recorded) {
  const double scale = NumberIn(replay, "scale", 1, 1e-3, 1e3);
  const double speed = NumberIn(replay, "speed", 1, 1e-2, 1e2);
  const double begin_s = recorded.front().time_s;
  for (StampedPose& pose : recorded) {
    pose.time_s = (pose.time_s - begin_s) / speed;
    pose.world_from_camera.translation = scale * pose.world_from_camera.translation;
  }
  const SE3d first = recorded.front().world_from_camera;
  const SE3d world_from_recorded = FirstPose(replay, first) * first.Inverse();
  for (StampedPose& pose : recorded) {
    pose.world_from_camera = world_from_recorded * pose.world_from_camera;
  }
  return recorded;
}

}  // namespace

SmoothedTrajectory ReadReplay(const TomlTable& replay, const std::filesystem::path& folder) {
  SmoothingOptions options;
  options.knot_spacing_s = replay.Number("knot_spacing_s", options.knot_spacing_s);
  options.smoothing_s = replay.Number("smoothing_s", options.smoothing_s);
  options.max_gap_s = replay.Number("max_gap_s", options.max_gap_s);
  const Trajectory measured = Placed(replay, ReadStretch(replay, folder));
  replay.RejectUnknownKeys();
  try {
    return SmoothTrajectory(measured, options);
  } catch (const Error& error) {
    throw Error(replay.place() + ": " + error.what());
  }
}

}  // namespace silt::sim
