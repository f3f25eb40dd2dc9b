// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/align.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/core/formatted.h"
#include "silt/core/frame.h"
#include "silt/core/io/image_file.h"
#include "silt/experiments/colour_registration.h"
#include "silt/experiments/tracker_options.h"
#include "silt/tracker/image_content.h"

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

std::string TumLine(double time_s, const SE3d& pose) {
  const Quaterniond& q = pose.rotation;
  const Vec3d& t = pose.translation;
  return Formatted("%.9f %.9f %.9f %.9f %.9f %.9f %.9f %.9f", time_s, t.x, t.y, t.z, q.x, q.y, q.z,
                   q.w);
}

// TUM's files are named by their time; 0 for other names.
double TimeOf(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  double time_s = 0;
  const auto [rest, error] = std::from_chars(name.data(), name.data() + name.size(), time_s);
  const bool good = error == std::errc() && rest == name.data() + name.size();
  return good && std::isfinite(time_s) ? time_s : 0;
}

// An initial pose is where to start also with a preset that else asks features about every frame.
TrackerSetup SetupOf(const AlignSetup& setup) {
  TrackerSetup tracker = setup.tracker;
  if (setup.initial && tracker.initializer == "auto" &&
      PresetOptions(tracker.preset).always_initialize) {
    tracker.initializer = "identity";
  }
  return tracker;
}

std::string Rows(const double* values, int rows, int columns, const char* format) {
  std::string text;
  for (int i = 0; i < rows * columns; ++i) {
    char number[40];
    std::snprintf(number, sizeof number, format, values[i]);
    text += std::string(i % columns == 0 ? "" : " ") + number;
    if (i % columns == columns - 1) text += "\n";
  }
  return text;
}

// Of a pair that has one.
std::string FormatPose(const AlignedPair& pair) {
  const auto& c = pair.covariance;
  const SE3d& pose = *pair.current_from_reference;
  return Rows(Matrix(pose).data(), 4, 4, "%12.9f") +
         "t tx ty tz qx qy qz qw: " + TumLine(pair.time_s, pose) +
         "\ncovariance of (omega, v), rad and m:\n" + Rows(c.data(), 6, 6, "%10.2e") +
         Formatted("standard deviations %.2g %.2g %.2g rad, %.2g %.2g %.2g m\n", std::sqrt(c[0]),
                   std::sqrt(c[7]), std::sqrt(c[14]), std::sqrt(c[21]), std::sqrt(c[28]),
                   std::sqrt(c[35]));
}

}  // namespace

SE3d Mirrored(const SE3d& pose) {
  const Quaterniond& q = pose.rotation;
  const Vec3d& t = pose.translation;
  return {Quaterniond{q.w, -q.x, q.y, -q.z}, {t.x, -t.y, t.z}};
}

std::vector<std::string> PairInitializerNames() {
  std::vector<std::string> names = InitializerNames();
  std::erase_if(names, [](const std::string& name) {
    return name == "previous" || name == "constant-velocity" || name == "truth";
  });
  return names;
}

void CheckStart(const AlignSetup& setup) {
  const std::string kind = ParseInitializer(setup.tracker.initializer).kind;
  const std::vector<std::string> names = PairInitializerNames();
  if (std::find(names.begin(), names.end(), kind) == names.end()) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Error("--init '" + kind + "': a pair knows no motion and no truth; there are: " + list);
  }
  const bool takes_pose = kind == "auto" || kind == "identity" || kind == "rotation";
  if (setup.initial && !takes_pose) {
    throw Error("--initial: --init " + kind + " finds its own start; give one of the two");
  }
}

AlignedPair AlignFiles(const PairFiles& files, const AlignSetup& setup) {
  PinholeCamera camera = setup.camera;
  const Frame reference =
      ReadFrame(files.reference_rgb, files.reference_depth, setup.depth_per_metre, &camera);
  const Frame current =
      ReadFrame(files.current_rgb, files.current_depth, setup.depth_per_metre, &camera);
  // The reference stands at the origin and becomes the first keyframe.
  tracker::KeyframeTracker tracker = MakeTracker(camera, SetupOf(setup), SE3d{});
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
  pair.time_s = TimeOf(files.current_rgb);
  if (pair.status != tracker::TrackingStatus::kLost) {
    const SE3d& pose = alignment.current_from_reference;
    pair.current_from_reference = setup.mirrored ? Mirrored(pose) : pose;
    pair.covariance = setup.mirrored ? Mirrored(alignment.covariance) : alignment.covariance;
  }
  pair.residual = std::sqrt(alignment.final_cost().mean_square());
  pair.inverse_depth_residual = alignment.inverse_depth_scale;
  pair.edge_contrast = tracker::ContentOf(reference.rgb, reference.depth_m).edge_contrast;
  pair.doubt_of_colours = DoubtOfColours(setup.tracker.preset, pair.edge_contrast);
  for (const tracker::AlignmentLevel& level : alignment.levels) pair.iterations += level.iterations;
  pair.milliseconds = first.times.total_ms + tracked.times.total_ms;
  return pair;
}

Json ToJson(const AlignedPair& pair) {
  Json json{{"status", tracker::Name(pair.status)},
            {"message", pair.message},
            {"current_from_reference", nullptr},
            {"tum", nullptr},
            {"covariance", nullptr},
            {"residual", pair.residual},
            {"inverse_depth_residual", pair.inverse_depth_residual},
            {"edge_contrast", nullptr},
            {"iterations", pair.iterations},
            {"ms", pair.milliseconds}};
  if (pair.edge_contrast > 0) json["edge_contrast"] = pair.edge_contrast;
  if (!pair.current_from_reference) return json;
  json["current_from_reference"] = Matrix(*pair.current_from_reference);
  json["tum"] = TumLine(pair.time_s, *pair.current_from_reference);
  json["covariance"] = pair.covariance;
  return json;
}

std::string Format(const AlignedPair& pair) {
  return (pair.current_from_reference ? FormatPose(pair) : "") +
         (pair.message.empty() ? tracker::Name(pair.status) : pair.message) +
         Formatted(", residual %.5f, %d iterations, %.1f ms\n", pair.residual, pair.iterations,
                   pair.milliseconds) +
         (pair.doubt_of_colours.empty() ? "" : pair.doubt_of_colours + "\n");
}

}  // namespace silt::experiments
