// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"

namespace silt {
namespace {

[[noreturn]] void FailAt(const std::string& name, int line, const std::string& what) {
  throw Error(name + ":" + std::to_string(line) + ": " + what);
}

StampedPose ParseLine(const std::string& text, const std::string& name, int line) {
  std::istringstream in(text);
  double value[8];
  for (double& v : value) {
    std::string word;
    if (!(in >> word)) FailAt(name, line, "expected 8 numbers: time tx ty tz qx qy qz qw");
    char* end = nullptr;
    v = std::strtod(word.c_str(), &end);
    if (*end != '\0' || !std::isfinite(v)) FailAt(name, line, Quoted(word) + " is not a number");
  }
  std::string rest;
  if (in >> rest) FailAt(name, line, "more than 8 numbers on the line");
  const Quaterniond q{value[7], value[4], value[5], value[6]};
  const double norm = std::sqrt(q.w * q.w + Dot(q.vec(), q.vec()));
  if (std::abs(norm - 1) > 1e-2) FailAt(name, line, "the quaternion qx qy qz qw is not of norm 1");
  return {value[0], {q.Normalized(), {value[1], value[2], value[3]}}};
}

}  // namespace

Trajectory ParseTumTrajectory(std::istream& in, const std::string& name) {
  Trajectory trajectory;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos || text[first] == '#') continue;
    const StampedPose pose = ParseLine(text, name, line);
    if (!trajectory.empty() && pose.time_s <= trajectory.back().time_s) {
      FailAt(name, line, "time does not increase");
    }
    trajectory.push_back(pose);
  }
  return trajectory;
}

Trajectory ReadTumTrajectory(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw Error(file.string() + ": cannot be read as a trajectory");
  }
  Trajectory trajectory = ParseTumTrajectory(in, file.string());
  if (trajectory.empty()) throw Error(file.string() + ": holds no pose");
  return trajectory;
}

std::string FormatTumTrajectory(const Trajectory& trajectory) {
  std::string text = "# time_s tx ty tz qx qy qz qw (world_from_camera, metres)\n";
  for (const StampedPose& pose : trajectory) {
    const Vec3d& t = pose.world_from_camera.translation;
    const Quaterniond& q = pose.world_from_camera.rotation;
    char line[256];
    std::snprintf(line, sizeof line, "%.9f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", pose.time_s, t.x,
                  t.y, t.z, q.x, q.y, q.z, q.w);
    text += line;
  }
  return text;
}

void WriteTumTrajectory(const std::filesystem::path& file, const Trajectory& trajectory) {
  WriteFileAtomically(file, FormatTumTrajectory(trajectory));
}

std::optional<SE3d> InterpolatedPose(const Trajectory& trajectory, double time_s,
                                     double widest_gap_s) {
  // Times in files are rounded to a nanosecond.
  constexpr double kSame_s = 2e-9;
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), time_s - kSame_s,
                       [](const StampedPose& pose, double time) { return pose.time_s < time; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->time_s <= time_s + kSame_s) return after->world_from_camera;
  if (after == trajectory.begin()) return std::nullopt;
  const StampedPose& before = *std::prev(after);
  const double gap_s = after->time_s - before.time_s;
  if (gap_s > widest_gap_s) return std::nullopt;
  const double share = (time_s - before.time_s) / gap_s;
  const SE3d &a = before.world_from_camera, &b = after->world_from_camera;
  const Vec3d turn = (a.rotation.Conjugate() * b.rotation).Log();
  return SE3d{(a.rotation * Quaterniond::Exp(share * turn)).Normalized(),
              a.translation + share * (b.translation - a.translation)};
}

double PathLength(const Trajectory& trajectory) {
  double length_m = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length_m += Norm(trajectory[i].world_from_camera.translation -
                     trajectory[i - 1].world_from_camera.translation);
  }
  return length_m;
}

}  // namespace silt
