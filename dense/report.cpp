// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/report.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "silt/core/error.h"
#include "silt/dense/align_bench.h"
#include "silt/dense/align_figures.h"
#include "silt/dense/backend_comparison.h"
#include "silt/dense/backends.h"

namespace silt::dense {
namespace {

// More than the caches of a large GPU hold the images of.
constexpr int kPairs = 32;

// Of neighbouring frames, evenly spread; those without a depth are left out.
std::vector<MovedPair> PairsOf(const std::vector<RawFrame>& frames) {
  std::vector<MovedPair> pairs;
  const std::size_t last = frames.size() - 1, count = std::min<std::size_t>(kPairs, last);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = i * last / count;
    const RawFrame &a = frames[k], &b = frames[k + 1];
    if (a.frame.depth_m.empty() || b.frame.depth_m.empty()) continue;
    pairs.push_back(
        {a.camera, a.frame, b.frame, b.world_from_camera.Inverse() * a.world_from_camera});
  }
  if (pairs.empty()) throw Error("the sequence has no two neighbouring frames with depth");
  return pairs;
}

struct Preset {
  const char* name;
  tracker::TrackerOptions options;
};

std::vector<Preset> Presets() {
  return {{"paper", tracker::PaperPreset()},
          {"accurate", tracker::AccuratePreset()},
          {"fast", tracker::FastPreset()}};
}

void AddTracking(const std::vector<RawFrame>& frames,
                 const std::shared_ptr<const tracker::Backend>& backend, JsonText* json,
                 Report* report) {
  const auto cpu = MakeBackend("cpu");
  for (const Preset& preset : Presets()) {
    TrackAll(frames, preset.options, backend);  // warms up
    const TrackedSequence ours = TrackAll(frames, preset.options, backend);
    const TrackedSequence cpus = TrackAll(frames, preset.options, cpu);
    const SequenceDifference difference = Compare(cpus, ours, frames);
    const bool agrees = difference.Agree(int(frames.size()));
    report->agrees = report->agrees && agrees;
    JsonText of_preset;
    of_preset.Add("frames", double(frames.size()))
        .Add("frames_per_s", ours.frames_per_s)
        .Add("cpu_frames_per_s", cpus.frames_per_s)
        .Add("coarse_starts", ours.coarse_starts)
        .Add("lost", ours.lost)
        .Add("cpu_lost", cpus.lost)
        .Add("frames_with_same_keyframes", difference.same_keyframes)
        .Add("apart_m", difference.metres)
        .Add("apart_rad", difference.radians)
        .Add("rmse_m", difference.rmse_b_m)
        .Add("cpu_rmse_m", difference.rmse_a_m)
        .AddFlag("agrees", agrees);
    json->AddObject(preset.name, of_preset);
    char line[240];
    std::snprintf(line, sizeof line,
                  "%-12s %.5g frames/s (cpu %.5g), %.2g m and %.2g rad from the cpu's poses, RMSE "
                  "%.3g m (cpu %.3g): %s\n",
                  preset.name, ours.frames_per_s, cpus.frames_per_s, difference.metres,
                  difference.radians, difference.rmse_b_m, difference.rmse_a_m,
                  agrees ? "agrees" : "DIFFERS");
    report->text += line;
  }
}

}  // namespace

Report MakeReport(const std::vector<RawFrame>& frames, const ReportOptions& options) {
  if (frames.size() < 2) throw Error("a sequence of at least two frames is needed");
  const auto backend = MakeBackend(options.backend);
  const std::vector<MovedPair> pairs = PairsOf(frames);
  Report report;
  JsonText json, tracking;
  const Ceilings ceilings = MeasureCeilings(options.backend);
  json.Add("commit", options.commit).AddObject("device", DeviceFacts(options.backend, ceilings));
  json.Add("width", frames.front().camera.width).Add("height", frames.front().camera.height);
  AddTracking(frames, backend, &tracking, &report);
  json.AddObject("tracking", tracking);
  const AlignFigures refinement =
      MeasureRefinement(*backend, pairs, RefinementOptions(), options.repeats);
  json.AddObject("refinement_20_20_5_2", FiguresJson(refinement, ceilings));
  report.text += FiguresText("refinement", refinement, ceilings);
  const AlignFigures batch = MeasureBatch(*backend, pairs, RefinementOptions(), options.starts);
  json.AddObject("batch_20_20_5_2", FiguresJson(batch, ceilings));
  report.text += FiguresText("batch", batch, ceilings);
  const AlignFigures accurate_batch =
      MeasureBatch(*backend, pairs, tracker::AccuratePreset().alignment, options.starts);
  json.AddObject("batch_accurate", FiguresJson(accurate_batch, ceilings));
  report.text += FiguresText("accurate", accurate_batch, ceilings);
  json.AddFlag("agrees_with_cpu", report.agrees);
  report.json = json.Text() + "\n";
  return report;
}

}  // namespace silt::dense
