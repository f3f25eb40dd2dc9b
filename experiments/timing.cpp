// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/timing.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/statistics.h"

namespace silt::experiments {
namespace {

template <typename Work>
double Milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

// The smallest value that at least 90 % of the values do not exceed.
double Percentile90(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() * 9 + 9) / 10 - 1];
}

StageTiming OverFrames(const std::vector<FrameTiming>& frames, const std::string& stage,
                       double paper_ms, const std::function<double(const FrameTiming&)>& value) {
  std::vector<double> values;
  for (std::size_t i = 1; i < frames.size(); ++i) values.push_back(value(frames[i]));
  return {stage, paper_ms, Median(values), Percentile90(values)};
}

}  // namespace

std::vector<FrameTiming> TimeFrames(FrameSource& source, tracker::KeyframeTracker& tracker) {
  std::vector<FrameTiming> timings;
  while (true) {
    ThrowIfInterrupted();
    FrameTiming timing;
    std::optional<Frame> frame;
    timing.load_ms = Milliseconds([&] { frame = source.Next(); });
    if (!frame) return timings;
    const tracker::TrackedFrame tracked = tracker.Track(*frame);
    timing.time_s = tracked.time_s;
    timing.new_keyframe = tracked.new_keyframe;
    timing.stages = tracked.times;
    timings.push_back(timing);
  }
}

CallTimes TimeFullSizeCalls(const tracker::Backend& backend, const FramePair& pair, int calls) {
  SILT_CHECK(calls >= 1);
  const auto reference = backend.MakeReference(GrayFromRgb(pair.reference.rgb),
                                               pair.reference.depth_m, pair.camera, {1});
  const auto current = backend.MakeCurrent(GrayFromRgb(pair.current.rgb), {}, {1});
  const tracker::ImagePair images{*reference, *current};
  std::vector<double> residual, jacobian;
  for (int i = 0; i < calls; ++i) {
    residual.push_back(Milliseconds([&] { backend.Cost(images, 0, pair.current_from_reference); }));
    jacobian.push_back(
        Milliseconds([&] { backend.Linearize(images, 0, pair.current_from_reference); }));
  }
  return {Median(residual), Median(jacobian)};
}

std::vector<StageTiming> SummarizeTiming(const std::vector<FrameTiming>& frames,
                                         const CallTimes& calls) {
  if (frames.size() < 2) throw Error("timing: needs at least two frames; raise --duration");
  const auto stage = [&](const std::string& name, double paper_ms,
                         double tracker::StageTimes::*member) {
    return OverFrames(frames, name, paper_ms,
                      [member](const FrameTiming& frame) { return frame.stages.*member; });
  };
  // 0: the paper does not say.
  return {OverFrames(frames, "load", 3.5, [](const FrameTiming& f) { return f.load_ms; }),
          stage("pyramid", 1.6, &tracker::StageTimes::pyramid_ms),
          stage("initial estimate", 31.3, &tracker::StageTimes::initial_estimate_ms),
          {"warp and residual, one call", 3.9, calls.residual_ms, calls.residual_ms},
          {"Jacobian, one call", 11.1, calls.jacobian_ms, calls.jacobian_ms},
          stage("warps and residuals, all", 0, &tracker::StageTimes::residual_ms),
          stage("Jacobians, all", 0, &tracker::StageTimes::jacobian_ms),
          stage("updates of the pose, all", 5.3, &tracker::StageTimes::update_ms),
          OverFrames(frames, "frame", 100,
                     [](const FrameTiming& f) { return f.load_ms + f.stages.total_ms; })};
}

Json StageRows(const std::vector<StageTiming>& stages) {
  Json rows = Json::array();
  for (const StageTiming& stage : stages) {
    rows.push_back({{"stage", stage.stage},
                    {"paper_ms", stage.paper_ms > 0 ? Json(stage.paper_ms) : Json()},
                    {"median_ms", stage.median_ms},
                    {"percentile_90_ms", stage.percentile_90_ms}});
  }
  return rows;
}

Json FrameRows(const std::vector<FrameTiming>& frames) {
  Json rows = Json::array();
  for (const FrameTiming& frame : frames) {
    rows.push_back({{"time_s", frame.time_s},
                    {"new_keyframe", frame.new_keyframe},
                    {"load_ms", frame.load_ms},
                    {"pyramid_ms", frame.stages.pyramid_ms},
                    {"initial_estimate_ms", frame.stages.initial_estimate_ms},
                    {"residual_ms", frame.stages.residual_ms},
                    {"jacobian_ms", frame.stages.jacobian_ms},
                    {"update_ms", frame.stages.update_ms},
                    {"total_ms", frame.stages.total_ms}});
  }
  return rows;
}

std::string FormatTiming(const std::vector<StageTiming>& stages) {
  std::string text = "milliseconds                   paper   median  90 % below\n";
  for (const StageTiming& stage : stages) {
    char line[120], paper[16] = "       -";
    if (stage.paper_ms > 0) std::snprintf(paper, sizeof paper, "%8.1f", stage.paper_ms);
    std::snprintf(line, sizeof line, "%-28s%s %8.2f %11.2f\n", stage.stage.c_str(), paper,
                  stage.median_ms, stage.percentile_90_ms);
    text += line;
  }
  return text;
}

}  // namespace silt::experiments
