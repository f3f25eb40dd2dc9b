// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/track_bench.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/opencv_odometry.h"
#include "silt/experiments/pose_difference.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/tracker_options.h"
#include "silt/experiments/tracker_setup.h"
#include "silt/tracker/stopwatch.h"

namespace silt::experiments {
namespace {

using Backend = std::shared_ptr<const tracker::Backend>;

struct Method {
  MethodRuns runs;
  std::function<PairRun(const FramePair&)> run;
};

void SetError(const SE3d& found, const SE3d& truth, PairRun* run) {
  const PoseDifference error = Difference(found, truth);
  run->t_mm = 1000 * error.distance_m;
  run->r_deg = error.angle_deg;
}

double PixelIterations(const tracker::AlignmentResult& alignment) {
  double sum = 0;
  for (const tracker::AlignmentLevel& level : alignment.levels) {
    sum += double(level.iterations) * level.width * level.height;
  }
  return sum;
}

PairRun RunPreset(const std::string& preset, const Backend& backend, const FramePair& pair) {
  const tracker::TrackerOptions options = PresetOptions(preset);
  tracker::KeyframeTracker tracker(pair.camera, options, backend,
                                   MakeInitializer({}, options, backend));
  // A sequence's reader gives its frames away, too.
  Frame reference = pair.reference;
  const tracker::TrackedFrame first = tracker.Track(std::move(reference));
  const std::unique_ptr<tracker::DeviceClock> clock = backend->StartClock();
  const tracker::TrackedFrame tracked = tracker.Track(pair.current, SE3d{});
  PairRun run;
  if (clock) run.device_ms = clock->Milliseconds();
  run.found = tracked.status != tracker::TrackingStatus::kLost;
  run.milliseconds = first.times.total_ms + tracked.times.total_ms;
  run.stages = tracked.times;
  run.keyframe_ms = first.times.total_ms;
  run.pixel_iterations = PixelIterations(tracked.alignment);
  SetError(run.found ? tracked.alignment.current_from_reference : SE3d{},
           pair.current_from_reference, &run);
  return run;
}

PairRun RunOpenCv(const OpenCvOdometry& odometry, OpenCvOdometry::Kind kind,
                  const FramePair& pair) {
  const OdometryRun found = odometry.Run(pair, kind);
  PairRun run;
  run.found = found.found;
  run.milliseconds = found.milliseconds;
  SetError(found.current_from_reference, pair.current_from_reference, &run);
  return run;
}

Method MakeMethod(const std::string& name, bool has_stages,
                  std::function<PairRun(const FramePair&)> run) {
  Method method;
  method.runs.name = name;
  method.runs.has_stages = has_stages;
  method.run = std::move(run);
  return method;
}

std::vector<Method> Methods(const std::vector<std::string>& presets, const Backend& backend) {
  std::vector<Method> methods;
  for (const std::string& preset : presets) {
    methods.push_back(MakeMethod(
        preset, true, [=](const FramePair& pair) { return RunPreset(preset, backend, pair); }));
  }
  const std::optional<OpenCvOdometry> odometry = OpenCvOdometry::Load();
  if (!odometry) return methods;
  using Kind = OpenCvOdometry::Kind;
  const auto add = [&](const std::string& name, Kind kind) {
    methods.push_back(MakeMethod(name, false, [=, odometry = *odometry](const FramePair& pair) {
      return RunOpenCv(odometry, kind, pair);
    }));
  };
  add("opencv_rgbd", Kind::kRgbd);
  add("opencv_rgbd_icp", Kind::kRgbdIcp);
  return methods;
}

// Every method on every pair, and again: the fastest runs. Whichever comes first to a pair finds
// its images in no cache, so each does in turn.
void RunAll(const std::vector<BenchPair>& pairs, int repeats,
            std::vector<PairRun> MethodRuns::*runs, std::vector<Method>* methods,
            Progress* progress) {
  for (Method& method : *methods) {
    PairRun slowest;
    slowest.milliseconds = std::numeric_limits<double>::infinity();
    (method.runs.*runs).assign(pairs.size(), slowest);
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t m = 0; m < methods->size(); ++m) {
        ThrowIfInterrupted();
        Method& method = (*methods)[(m + std::size_t(repeat)) % methods->size()];
        const PairRun run = method.run(pairs[i].frames);
        PairRun& fastest = (method.runs.*runs)[i];
        if (run.milliseconds < fastest.milliseconds) fastest = run;
        progress->Advance(1, method.runs.name);
      }
    }
  }
}

double LeastMilliseconds(const tracker::Backend& backend, int calls,
                         const std::function<void()>& call) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < calls; ++i) {
    double ms = 0;
    const std::unique_ptr<tracker::DeviceClock> clock = backend.StartClock();
    {
      const tracker::Stopwatch watch(&ms);
      call();
    }
    const double device_ms = clock ? clock->Milliseconds() : 0;
    least = std::min(least, device_ms > 0 ? device_ms : ms);
  }
  return least;
}

// With bounds such as `fast` has them: what they are does not change the time. On a device, other
// images come at each call; on a processor, one alignment's passes find theirs where the last one
// has left them.
FusedPass MeasureFusedPass(const Backend& backend, const std::vector<BenchPair>& all, int calls) {
  tracker::PyramidOptions pyramid = PresetOptions("fast").alignment.Pyramids();
  pyramid.levels = 1;
  pyramid.finest = 0;
  std::vector<tracker::OwnedPair> pairs;
  for (const BenchPair& each : all) {
    const FramePair& frames = each.frames;
    pairs.push_back(
        {backend->MakeReference(GrayFromRgb(frames.reference.rgb), frames.reference.depth_m,
                                frames.camera, pyramid),
         backend->MakeCurrent(GrayFromRgb(frames.current.rgb), frames.current.depth_m, pyramid)});
    if (!backend->runs_alignments()) break;
  }
  std::size_t next = 0;
  const auto time = [&](const tracker::ResidualNorm& norm) {
    return LeastMilliseconds(*backend, calls, [&] {
      const std::size_t i = next++ % pairs.size();
      (void)backend->Linearize(pairs[i].images(), 0, all[i].frames.current_from_reference, norm);
    });
  };
  tracker::ResidualNorm robust;
  robust.intensity = {8.0 / 255, 5.0 / 255, 1};
  tracker::ResidualNorm with_depth = robust;
  with_depth.inverse_depth.scale = 1e-3;
  with_depth.use_depth = true;
  return {time({}), time(robust), time(with_depth)};
}

std::vector<Refinement> MeasureRefinements(const Backend& backend,
                                           const std::vector<BenchPair>& pairs,
                                           const TrackBenchOptions& options) {
  std::vector<dense::MovedPair> moved;
  for (const BenchPair& pair : pairs) {
    const FramePair& frames = pair.frames;
    moved.push_back(
        {frames.camera, frames.reference, frames.current, frames.current_from_reference});
  }
  std::vector<Refinement> refinements;
  for (const std::string& preset : options.presets) {
    ThrowIfInterrupted();
    refinements.push_back(
        {preset, dense::MeasureRefinement(*backend, moved, PresetOptions(preset).alignment,
                                          options.repeats * int(pairs.size()))});
  }
  return refinements;
}

}  // namespace

Json TrackBenchOptions::ToJson() const {
  return {{"backend", backend}, {"presets", presets}, {"repeats", repeats}, {"threads", threads}};
}

TrackBench MeasureTracking(std::vector<BenchPair> pairs, const TrackBenchOptions& options) {
  SILT_CHECK(!pairs.empty() && options.repeats >= 1 && options.threads >= 1);
  const int threads_before = ThreadCount();
  const Backend backend = MakeBackend(options.backend);
  std::vector<Method> methods = Methods(options.presets, backend);
  Progress progress(2.0 * options.repeats * double(pairs.size() * methods.size()));
  TrackBench bench;
  bench.threads = options.threads;
  bench.backend = backend->name();
  for (const Method& method : methods) method.run(pairs.front().frames);
  SetThreadCount(1);
  bench.fused_pass = MeasureFusedPass(backend, pairs, 5 * options.repeats);
  RunAll(pairs, options.repeats, &MethodRuns::one_thread, &methods, &progress);
  SetThreadCount(options.threads);
  RunAll(pairs, options.repeats, &MethodRuns::threads, &methods, &progress);
  bench.refinements = MeasureRefinements(backend, pairs, options);
  bench.ceilings = dense::MeasureCeilings(bench.backend);
  SetThreadCount(threads_before);
  for (Method& method : methods) bench.methods.push_back(std::move(method.runs));
  bench.pairs = std::move(pairs);
  return bench;
}

}  // namespace silt::experiments
