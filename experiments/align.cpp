// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/align.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/core/frame.h"
#include "silt/core/io/image_file.h"

namespace silt::experiments {
namespace {

void CheckSize(const std::filesystem::path& file, int width, int height,
               const PinholeCamera& camera) {
  if (width == camera.width && height == camera.height) return;
  throw Error(file.string() + ": " + std::to_string(width) + "x" + std::to_string(height) +
              " pixels where " + std::to_string(camera.width) + "x" +
              std::to_string(camera.height) + " are expected");
}

Frame ReadFrame(const std::filesystem::path& rgb, const std::filesystem::path& depth,
                double depth_per_metre, PinholeCamera* camera) {
  Frame frame;
  frame.rgb = ReadRgb(rgb);
  if (camera->width == 0) {
    camera->width = frame.rgb.width();
    camera->height = frame.rgb.height();
  }
  CheckSize(rgb, frame.rgb.width(), frame.rgb.height(), *camera);
  if (depth.empty()) return frame;
  frame.depth_m = ReadDepth(depth, depth_per_metre);
  CheckSize(depth, frame.depth_m.width(), frame.depth_m.height(), *camera);
  return frame;
}

// ω is an axial vector: of it, the mirror turns what v keeps.
std::array<double, 36> Mirrored(const std::array<double, 36>& covariance) {
  constexpr double sign[6] = {-1, 1, -1, 1, -1, 1};
  std::array<double, 36> mirrored;
  for (int i = 0; i < 36; ++i) mirrored[i] = sign[i / 6] * sign[i % 6] * covariance[i];
  return mirrored;
}

std::array<double, 16> Matrix(const SE3d& pose) {
  const Mat3<double> r = pose.rotation.Matrix();
  const Vec3d& t = pose.translation;
  return {r.row[0].x, r.row[0].y, r.row[0].z, t.x, r.row[1].x, r.row[1].y, r.row[1].z, t.y,
          r.row[2].x, r.row[2].y, r.row[2].z, t.z, 0,          0,          0,          1};
}

std::string TumLine(const SE3d& pose) {
  char line[200];
  const Quaterniond& q = pose.rotation;
  std::snprintf(line, sizeof line, "%.9f %.9f %.9f %.9f %.9f %.9f %.9f", pose.translation.x,
                pose.translation.y, pose.translation.z, q.x, q.y, q.z, q.w);
  return line;
}

}  // namespace

SE3d Mirrored(const SE3d& pose) {
  const Quaterniond& q = pose.rotation;
  const Vec3d& t = pose.translation;
  return {Quaterniond{q.w, -q.x, q.y, -q.z}, {t.x, -t.y, t.z}};
}

AlignedPair AlignFiles(const PairFiles& files, const AlignSetup& setup) {
  PinholeCamera camera = setup.camera;
  const Frame reference =
      ReadFrame(files.reference_rgb, files.reference_depth, setup.depth_per_metre, &camera);
  const Frame current =
      ReadFrame(files.current_rgb, files.current_depth, setup.depth_per_metre, &camera);
  // The reference stands at the origin and becomes the first keyframe.
  tracker::KeyframeTracker tracker = MakeTracker(camera, setup.tracker, SE3d{});
  const tracker::TrackedFrame first = tracker.Track(reference);
  if (!first.new_keyframe) {
    throw Error(files.reference_depth.string() + ": too few pixels have a depth");
  }
  std::optional<SE3d> expected;
  if (setup.initial) {
    expected = (setup.mirrored ? Mirrored(*setup.initial) : *setup.initial).Inverse();
  }
  const tracker::TrackedFrame tracked = tracker.Track(current, expected);
  const tracker::AlignmentResult& alignment = tracked.alignment;
  AlignedPair pair;
  pair.status = tracked.status;
  const bool alright = pair.status == tracker::TrackingStatus::kTracked;
  pair.message = alright ? "" : tracked.message;
  const SE3d pose = !pair.lost() ? alignment.current_from_reference : SE3d{};
  pair.current_from_reference = setup.mirrored ? Mirrored(pose) : pose;
  pair.covariance = {};
  if (!pair.lost()) {
    pair.covariance = setup.mirrored ? Mirrored(alignment.covariance) : alignment.covariance;
  }
  pair.residual = std::sqrt(alignment.final_cost().mean_square());
  pair.inverse_depth_residual = alignment.inverse_depth_scale;
  for (const tracker::AlignmentLevel& level : alignment.levels) pair.iterations += level.iterations;
  pair.milliseconds = first.times.total_ms + tracked.times.total_ms;
  return pair;
}

Json ToJson(const AlignedPair& pair) {
  return {{"status", tracker::Name(pair.status)},
          {"message", pair.message},
          {"current_from_reference", Matrix(pair.current_from_reference)},
          {"tum", TumLine(pair.current_from_reference)},
          {"covariance", pair.covariance},
          {"residual", pair.residual},
          {"inverse_depth_residual", pair.inverse_depth_residual},
          {"iterations", pair.iterations},
          {"ms", pair.milliseconds}};
}

std::string Format(const AlignedPair& pair) {
  const std::array<double, 16> m = Matrix(pair.current_from_reference);
  std::string text;
  char line[200];
  for (int row = 0; row < 4; ++row) {
    const double* r = m.data() + 4 * row;
    std::snprintf(line, sizeof line, "%12.9f %12.9f %12.9f %12.9f\n", r[0], r[1], r[2], r[3]);
    text += line;
  }
  const auto& c = pair.covariance;
  std::snprintf(line, sizeof line, "standard deviations %.2g %.2g %.2g rad, %.2g %.2g %.2g m\n",
                std::sqrt(c[0]), std::sqrt(c[7]), std::sqrt(c[14]), std::sqrt(c[21]),
                std::sqrt(c[28]), std::sqrt(c[35]));
  text += "tx ty tz qx qy qz qw: " + TumLine(pair.current_from_reference) + "\n";
  if (!pair.lost()) text += line;
  std::snprintf(line, sizeof line, ", residual %.5f, %d iterations, %.1f ms\n", pair.residual,
                pair.iterations, pair.milliseconds);
  return text + (pair.message.empty() ? tracker::Name(pair.status) : pair.message) + line;
}

}  // namespace silt::experiments
