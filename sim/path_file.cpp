// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_file.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/toml_table.h"

namespace silt::sim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
// Nearer than this to the vertical, look_at says too little about the camera's heading.
constexpr double kLeastTilt = 0.1 * kRadians;
constexpr double kLargestTurn = 120 * kRadians;

Quaterniond ParseLookAt(const TomlTable& key, const Vec3d& position) {
  const Vec3d target = key.Vector("look_at");
  const Vec3d view = target - position;
  if (!(Norm(view) > 1e-6))
    key.Fail("look_at", "is the position itself: a view direction is missing");
  if (std::hypot(view.x, view.y) < std::sin(kLeastTilt) * Norm(view)) {
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
  if (key.Has("look_at") && key.Has("quaternion")) {
    key.Fail("quaternion", "and look_at exclude each other");
  }
  const double time_s = key.Number("time_s");
  const Vec3d position = key.Vector("position");
  const Quaterniond rotation =
      key.Has("quaternion") ? ParseQuaternion(key) : ParseLookAt(key, position);
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

HandShake ParseHandShake(const TomlTable& file) {
  const std::optional<TomlTable> table = file.Table("hand_shake");
  if (!table) return {};
  HandShakeOptions options;
  options.position_mm = table->Number("position_mm", options.position_mm);
  options.rotation_deg = table->Number("rotation_deg", options.rotation_deg);
  const int seed = table->Integer("seed", 0);
  if (seed < 0) table->Fail("seed", "must not be negative");
  options.seed = std::uint64_t(seed);
  if (table->Has("band_hz")) {
    const std::vector<double> band = table->Numbers("band_hz", 2);
    options.low_hz = band[0];
    options.high_hz = band[1];
  }
  table->RejectUnknownKeys();
  try {
    return HandShake(options);
  } catch (const Error& error) {
    throw Error(table->place() + ": " + error.what());
  }
}

CameraPath ReadPath(const TomlTable& file) {
  const Trajectory keys = ParseKeys(file);
  const HandShake shake = ParseHandShake(file);
  file.RejectUnknownKeys();
  try {
    return CameraPath(PoseSpline::Through(keys), shake);
  } catch (const Error& error) {
    throw Error(file.place() + ": " + error.what());
  }
}

}  // namespace

SE3d LookAt(const Vec3d& position, const Vec3d& target) {
  const Vec3d forward = Normalized(target - position);
  const Vec3d right = Normalized(Cross(forward, {0, 0, 1}));
  const Mat3d camera_from_world{{right, Cross(forward, right), forward}};
  return {QuaternionFromMatrix(Transposed(camera_from_world)), position};
}

CameraPath LoadCameraPath(const std::filesystem::path& file) {
  return ReadPath(TomlTable::ReadFile(file));
}

CameraPath ParseCameraPath(const std::string& text, const std::string& name) {
  return ReadPath(TomlTable::Parse(text, name));
}

}  // namespace silt::sim
