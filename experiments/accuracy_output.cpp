// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/accuracy_output.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/formatted.h"
#include "silt/core/io/image_file.h"
#include "silt/core/pyramid.h"
#include "silt/experiments/accuracy_report.h"
#include "silt/experiments/evaluation.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/output.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

std::string Csv(const std::vector<AccuracyRun>& runs) {
  std::string csv =
      "sequence,preset,backend,seed,frames,path_m,keyframes,lost,ms_per_frame,ate_aligned_cm,"
      "position_rmse_cm,position_max_cm,position_mean_cm,position_median_cm,position_std_cm";
  for (const char* axis : {"x", "y", "z"}) {
    for (const char* figure : {"rmse", "max", "min", "mean", "median", "std"}) {
      csv += Formatted(",%s_%s_deg", axis, figure);
    }
  }
  csv += "\n";
  for (const AccuracyRun& run : runs) {
    const TrackingResult& t = run.tracking;
    const Statistics& p = run.statistics.position_cm;
    csv += run.sequence.name + "," + run.setup.preset + "," + run.setup.backend + ",";
    csv += Formatted("%llu,%zu,%.6f,%d,%d,%.3f,%.6f", (unsigned long long)run.setup.seed,
                     t.estimate.size(), PathLength(run.truth), t.keyframes(), t.lost(),
                     t.mean_times.total_ms, run.ate_aligned_cm);
    csv += Formatted(",%.6f,%.6f,%.6f,%.6f,%.6f", p.rmse, p.max, p.mean, p.median, p.std_dev);
    for (const Statistics& s : run.statistics.orientation_deg) {
      csv += Formatted(",%.6f,%.6f,%.6f,%.6f,%.6f,%.6f", s.rmse, s.max, s.min, s.mean, s.median,
                       s.std_dev);
    }
    csv += "\n";
  }
  return csv;
}

// What the figures are drawn from; orientations are turns since the first pose.
std::string ErrorCsv(const AccuracyRun& run) {
  std::string csv =
      "time_s,position_error_cm,error_x_deg,error_y_deg,error_z_deg,keyframe,lost,"
      "true_x_m,true_y_m,true_z_m,x_m,y_m,z_m,turn_x_deg,turn_y_deg,turn_z_deg\n";
  const Quaterniond first = run.truth.front().world_from_camera.rotation;
  for (std::size_t i = 0; i < run.errors.size(); ++i) {
    const PoseError& e = run.errors[i];
    const SE3d& truth = run.truth[i].world_from_camera;
    const Vec3d& p = truth.translation;
    const Vec3d& q = run.tracking.estimate[i].world_from_camera.translation;
    const Vec3d turn =
        (180 / std::numbers::pi) * (first.Conjugate() * truth.rotation).Normalized().Log();
    csv += Formatted("%.9f,%.9f,%.9f,%.9f,%.9f,%d,%d", e.time_s, e.position_cm, e.orientation_deg.x,
                     e.orientation_deg.y, e.orientation_deg.z, int(run.tracking.is_keyframe[i]),
                     int(run.tracking.status[i] == tracker::TrackingStatus::kLost));
    csv += Formatted(",%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", p.x, p.y, p.z, q.x, q.y,
                     q.z, turn.x, turn.y, turn.z);
  }
  return csv;
}

// How the position's RMSE of a sequence and preset varies with the seed; nothing for one seed.
Json Spread(const std::vector<AccuracyRun>& runs) {
  Json spread = Json::array();
  for (const AccuracyRun& first : runs) {
    if (first.setup.seed != runs.front().setup.seed) continue;
    std::vector<double> rmse;
    for (const AccuracyRun& run : runs) {
      const bool same =
          run.sequence.name == first.sequence.name && run.setup.preset == first.setup.preset;
      if (same) rmse.push_back(run.statistics.position_cm.rmse);
    }
    if (rmse.size() < 2) continue;
    spread.push_back({{"sequence", first.sequence.name},
                      {"preset", first.setup.preset},
                      {"seeds", rmse.size()},
                      {"position_rmse_cm", ToJson(Summarize(rmse))}});
  }
  return spread;
}

void WriteTrajectories(const fs::path& folder, const std::vector<AccuracyRun>& runs) {
  for (const AccuracyRun& run : runs) {
    WriteTumTrajectory(folder / "trajectories" / (run.Name() + ".txt"), run.tracking.estimate);
    WriteTumTrajectory(folder / "trajectories" / (run.sequence.name + "-truth.txt"), run.truth);
    WriteFileAtomically(folder / "errors" / (run.Name() + ".csv"), ErrorCsv(run));
  }
}

}  // namespace

Image<Rgb8> DepthPicture(const Image<float>& depth_m) {
  float nearest = 0, farthest = 0;  // as 1/z
  for (const float z : depth_m) {
    if (!IsMeasured(z)) continue;
    nearest = std::max(nearest, 1 / z);
    farthest = farthest == 0 ? 1 / z : std::min(farthest, 1 / z);
  }
  const float range = std::max(nearest - farthest, 1e-9f);
  Image<Rgb8> picture(depth_m.width(), depth_m.height());
  std::transform(depth_m.begin(), depth_m.end(), picture.begin(), [&](float z) {
    if (!IsMeasured(z)) return Rgb8{};
    const auto gray = std::uint8_t(std::lround(20 + 235 * (1 / z - farthest) / range));
    return Rgb8{gray, gray, gray};
  });
  return picture;
}

void WriteAccuracy(const fs::path& folder, const AccuracyResult& result, const Json& manifest) {
  Json json{{"manifest", manifest}, {"runs", Json::array()}};
  for (const AccuracyRun& run : result.runs) json["runs"].push_back(run.ToJson());
  json["spread"] = Spread(result.runs);
  WriteJson(folder / "accuracy.json", json);
  WriteFileAtomically(folder / "accuracy.csv", Csv(result.runs));
  WriteTrajectories(folder, result.runs);
  for (const SamplePicture& picture : result.pictures) {
    WriteRgb(folder / "frames" / (picture.sequence + ".png"), picture.frame.rgb);
    WriteRgb(folder / "frames" / (picture.sequence + "-depth.png"),
             DepthPicture(picture.frame.depth_m));
  }
  DrawFigures("accuracy.py", folder);
  WriteFileAtomically(folder / "report.html", AccuracyReport(folder, result, manifest));
}

}  // namespace silt::experiments
