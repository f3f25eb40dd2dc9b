// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "silt/core/error.h"
#include "silt/sim/look_at.h"
#include "silt/sim/path_tables.h"

namespace silt::sim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kLargestTurn = 120 * kRadians;

Quaterniond LookAtRotation(const TomlTable& key, const Vec3d& position) {
  const Vec3d target = key.Vector("look_at");
  const Vec3d view = target - position;
  if (!(Norm(view) > 1e-6))
    key.Fail("look_at", "is the position itself: a view direction is missing");
  if (!HasHeading(view)) {
    key.Fail("look_at", "is straight above or below position: give a quaternion instead");
  }
  const Vec3d roll{0, 0, kRadians * key.Number("roll_deg", 0)};
  return LookAt(position, target).rotation * Quaterniond::Exp(roll);
}

Quaterniond ParseQuaternion(const TomlTable& key) {
  const std::vector<double> n = key.Numbers("quaternion", 4);
  const Quaterniond q{n[3], n[0], n[1], n[2]};
  const double norm = std::sqrt(q.w * q.w + Dot(q.vec(), q.vec()));
  if (!(std::abs(norm - 1) < 1e-2)) {
    key.Fail("quaternion", "qx qy qz qw is not of norm 1");
  }
  return q.Normalized();
}

StampedPose ParseKey(const TomlTable& key) {
  const double time_s = key.Number("time_s");
  const Vec3d position = key.Vector("position");
  const Quaterniond rotation = ReadRotationAt(key, position);
  key.RejectUnknownKeys();
  return {time_s, {rotation, position}};
}

void CheckSuccession(const TomlTable& key, const StampedPose& last, const StampedPose& next) {
  if (!(next.time_s - last.time_s >= 1e-3)) {
    key.Fail("time_s", "must be at least 0.001 s after that of the key before");
  }
  if (next.time_s > 1e5) key.Fail("time_s", "must not exceed 100000 s");
  const double turn =
      RotationAngle(last.world_from_camera.rotation.Conjugate() * next.world_from_camera.rotation);
  if (turn > kLargestTurn) {
    key.Fail("key", "turns by " + std::to_string(std::lround(turn / kRadians)) +
                        " degrees from the one before: add keys in between (at most 120 each)");
  }
}

Trajectory ParseKeys(const TomlTable& file) {
  Trajectory keys;
  for (const TomlTable& key : file.Tables("key")) {
    keys.push_back(ParseKey(key));
    if (keys.size() == 1 && keys[0].time_s != 0) {
      key.Fail("time_s", "of the first key must be 0");
    }
    if (keys.size() > 1) CheckSuccession(key, keys[keys.size() - 2], keys.back());
  }
  if (keys.size() < 2)
    file.Fail("key", "is missing: a camera path needs at least two [[key]] tables");
  return keys;
}

}  // namespace

Quaterniond ReadRotationAt(const TomlTable& table, const Vec3d& position) {
  if (!table.Has("quaternion")) return LookAtRotation(table, position);
  if (table.Has("look_at")) table.Fail("quaternion", "and look_at exclude each other");
  return ParseQuaternion(table);
}

PoseSpline ReadKeys(const TomlTable& file) {
  const Trajectory keys = ParseKeys(file);
  try {
    return PoseSpline::Through(keys);
  } catch (const Error& error) {
    throw Error(file.place() + ": " + error.what());
  }
}

}  // namespace silt::sim
