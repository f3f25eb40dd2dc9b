// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/bench_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "silt/core/error.h"
#include "silt/core/io/icl_camera.h"
#include "silt/core/io/image_file.h"
#include "silt/core/io/tum_sequence.h"
#include "silt/core/trajectory.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/pair_list.h"
#include "silt/experiments/progress.h"
#include "silt/tracker/stopwatch.h"

namespace silt::experiments {
namespace {

constexpr double kWidestGap_s = 0.1;  // between true poses; motion capture comes at 100 Hz

SE3d TruthAt(const Trajectory& truth, double time_s, const std::filesystem::path& file) {
  const std::optional<SE3d> pose = InterpolatedPose(truth, time_s, kWidestGap_s);
  if (pose) return *pose;
  throw Error(file.string() + ": no true pose at " + std::to_string(time_s) + " s");
}

// The first of `count` places, evenly spread over [0, last].
double Place(int i, int count, double last) { return count > 1 ? last * i / (count - 1) : 0; }

// Seconds since some beginning, as the stem of the name says.
double TimeOf(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  char* end = nullptr;
  const double time_s = std::strtod(stem.c_str(), &end);
  if (end != stem.c_str() && *end == '\0' && std::isfinite(time_s)) return time_s;
  throw Error(file.string() + ": its name tells no time; name files as TUM does, 12.345.png");
}

Frame ReadFrame(const std::filesystem::path& rgb, const std::filesystem::path& depth,
                double depth_per_metre) {
  if (depth.empty()) throw Error(rgb.string() + ": its pair needs the depth of both frames");
  return {TimeOf(rgb), ReadRgb(rgb), ReadDepth(depth, depth_per_metre)};
}

}  // namespace

std::vector<BenchPair> RenderBenchPairs(const World& world, const sim::RenderOptions& options,
                                        double fps, const PairChoice& choice) {
  const int longest = *std::max_element(choice.gaps.begin(), choice.gaps.end());
  const int last = int(std::floor(world.path.duration_s() * fps + 1e-9)) - longest;
  if (last < 0) {
    throw Error(world.path_file.string() + ": lasts " + std::to_string(world.path.duration_s()) +
                " s, less than a gap of " + std::to_string(longest) + " frames");
  }
  const auto pose_at = [&](int k) { return world.path.WorldFromCamera(k / fps); };
  std::vector<BenchPair> pairs;
  Progress progress(double(choice.instants) * double(choice.gaps.size() + 1));
  for (int i = 0; i < choice.instants; ++i) {
    ThrowIfInterrupted();
    const int k = int(Place(i, choice.instants, last));
    const Frame reference = RenderAt(world, options, k / fps);
    progress.Advance(1, "rendering");
    for (const int gap : choice.gaps) {
      pairs.push_back({{options.camera, reference, RenderAt(world, options, (k + gap) / fps),
                        pose_at(k + gap).Inverse() * pose_at(k)},
                       gap});
      progress.Advance(1, "rendering");
    }
  }
  return pairs;
}

std::vector<BenchPair> FolderBenchPairs(const std::filesystem::path& folder,
                                        const PinholeCamera& camera, double depth_per_metre,
                                        const PairChoice& choice) {
  TumSequenceOptions reading;
  reading.depth_per_metre = depth_per_metre;
  TumSequence sequence(folder, reading, camera);
  std::vector<Frame> frames;
  double load_ms = 0;
  {
    const tracker::Stopwatch watch(&load_ms);
    while (std::optional<Frame> frame = sequence.Next()) frames.push_back(*std::move(frame));
  }
  load_ms /= double(frames.size());
  const auto pose_of = [&](const Frame& frame) {
    return TruthAt(sequence.truth(), frame.time_s, folder / "groundtruth.txt");
  };
  std::vector<BenchPair> pairs;
  for (const int gap : choice.gaps) {
    const int places = int(frames.size()) - gap;
    const int count = std::min(choice.instants, places);
    for (int i = 0; i < count; ++i) {
      const auto k = std::size_t(Place(i, count, places - 1));
      const Frame &a = frames[k], &b = frames[k + std::size_t(gap)];
      if (a.depth_m.empty() || b.depth_m.empty()) continue;
      pairs.push_back({{sequence.camera(), a, b, pose_of(b).Inverse() * pose_of(a)}, gap, load_ms});
    }
  }
  if (pairs.empty()) throw Error(folder.string() + ": has no two frames with depth so far apart");
  return pairs;
}

std::vector<BenchPair> ListedBenchPairs(const std::filesystem::path& list,
                                        const std::filesystem::path& truth_file,
                                        const PinholeCamera& camera, double depth_per_metre) {
  const Trajectory truth = ReadTumTrajectory(truth_file);
  const auto pose_of = [&](const Frame& frame) {
    const SE3d pose = TruthAt(truth, frame.time_s, truth_file);
    return camera.fy < 0 ? SiltFromIcl(pose) : pose;
  };
  std::vector<BenchPair> pairs;
  for (const PairFiles& files : ReadPairList(list)) {
    BenchPair pair;
    {
      const tracker::Stopwatch watch(&pair.load_ms);
      pair.frames.reference =
          ReadFrame(files.reference_rgb, files.reference_depth, depth_per_metre);
      pair.frames.current = ReadFrame(files.current_rgb, files.current_depth, depth_per_metre);
    }
    pair.load_ms /= 2;
    pair.frames.camera = camera;
    pair.frames.camera.fy = std::abs(camera.fy);
    pair.frames.camera.width = pair.frames.reference.rgb.width();
    pair.frames.camera.height = pair.frames.reference.rgb.height();
    pair.frames.current_from_reference =
        pose_of(pair.frames.current).Inverse() * pose_of(pair.frames.reference);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace silt::experiments
