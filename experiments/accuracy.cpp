// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/accuracy.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "silt/experiments/evaluation.h"
#include "silt/experiments/progress.h"

namespace silt::experiments {
namespace {

// What a blurred frame takes longer to render than a sharp one, for the time left.
constexpr double kBlurredWork = 2.5;

// A run under way.
struct OpenRun {
  AccuracyRun run;
  std::unique_ptr<TrackingRun> tracking;
};

Trajectory EveryNth(const Trajectory& all, int n) {
  Trajectory some;
  for (std::size_t i = 0; i < all.size(); i += std::size_t(n)) some.push_back(all[i]);
  return some;
}

std::vector<OpenRun> OpenRuns(const AccuracyOptions& options, const Trajectory& truth,
                              const PinholeCamera& camera) {
  std::vector<OpenRun> runs;
  for (const PaperSequence& sequence : PaperSequences()) {
    for (const std::string& preset : options.presets) {
      for (int k = 0; k < options.seeds; ++k) {
        OpenRun open;
        open.run.sequence = sequence;
        open.run.setup = {preset, options.backend, options.initializer,
                          options.seed + std::uint64_t(k)};
        open.run.truth = EveryNth(truth, sequence.take_every);
        open.tracking =
            std::make_unique<TrackingRun>(camera, open.run.setup, truth.front().world_from_camera);
        runs.push_back(std::move(open));
      }
    }
  }
  return runs;
}

// The frame in which the camera turns fastest shows the blur best.
int FastestFrame(const Trajectory& truth) {
  int fastest = 0;
  double largest_turn = -1;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const double turn = RotationAngle(truth[i - 1].world_from_camera.rotation.Conjugate() *
                                      truth[i].world_from_camera.rotation);
    if (turn <= largest_turn) continue;
    largest_turn = turn;
    fastest = int(i);
  }
  return fastest;
}

bool TakesPart(const AccuracyRun& run, bool blurred, const RenderedFrame& rendered) {
  if (run.sequence.blur_and_noise != blurred) return false;
  if (rendered.number % run.sequence.take_every != 0) return false;
  return !blurred || run.setup.seed == rendered.seed;
}

AccuracyRun Close(OpenRun open) {
  AccuracyRun run = std::move(open.run);
  run.tracking = open.tracking->Result();
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < run.truth.size(); ++i) {
    pairs.push_back({run.truth[i], run.tracking.estimate[i]});
  }
  run.errors = PaperErrors(pairs);
  run.statistics = SummarizePaperErrors(run.errors);
  run.ate_aligned_cm = 100 * AlignedTrajectoryError(pairs).rmse;
  return run;
}

RenderPlan PlanFor(const AccuracyOptions& options, bool blurred) {
  RenderPlan plan;
  plan.options = PaperRenderOptions(blurred);
  plan.options.camera = IclNuimCameraOfWidth(options.width);
  plan.options.samples_per_pixel = options.samples_per_pixel;
  plan.options.seed = options.seed;
  plan.options.depth_sensor.model = options.depth_sensor;
  plan.stretch = {60, options.start_s, options.duration_s};
  if (blurred) {
    for (int k = 0; k < options.seeds; ++k) {
      plan.noise_seeds.push_back(options.seed + std::uint64_t(k));
    }
  }
  return plan;
}

}  // namespace

Json AccuracyOptions::ToJson() const {
  return {{"scene", scene},     {"trajectory", trajectory},
          {"start_s", start_s}, {"duration_s", duration_s},
          {"width", width},     {"samples_per_pixel", samples_per_pixel},
          {"seed", seed},       {"seeds", seeds},
          {"presets", presets}, {"depth_sensor", depth_sensor},
          {"backend", backend}, {"initializer", initializer}};
}

std::string AccuracyRun::Name() const {
  const std::string seed = setup.seed == 0 ? "" : "-seed" + std::to_string(setup.seed);
  return sequence.name + "-" + setup.preset + seed;
}

Json AccuracyRun::ToJson() const {
  const auto& axes = statistics.orientation_deg;
  return {{"sequence", sequence.name},
          {"preset", setup.preset},
          {"backend", setup.backend},
          {"seed", setup.seed},
          {"frames", tracking.estimate.size()},
          {"path_m", PathLength(truth)},
          {"keyframes", tracking.keyframes()},
          {"doubtful", tracking.doubtful()},
          {"lost", tracking.lost()},
          {"position_cm", experiments::ToJson(statistics.position_cm)},
          {"orientation_deg",
           {{"x", experiments::ToJson(axes[0])},
            {"y", experiments::ToJson(axes[1])},
            {"z", experiments::ToJson(axes[2])}}},
          {"ate_aligned_cm", ate_aligned_cm},
          {"ms_per_frame", tracking.mean_times.total_ms},
          {"trajectory", "trajectories/" + Name() + ".txt"}};
}

AccuracyResult RunAccuracy(const AccuracyOptions& options) {
  AccuracyResult result{LoadWorld(options.scene, options.trajectory), {}, {}, {}};
  const World& world = result.world;
  const RenderPlan sharp_plan = PlanFor(options, false);
  const Trajectory truth = TruePoses(world, sharp_plan.stretch);
  std::vector<OpenRun> runs = OpenRuns(options, truth, sharp_plan.options.camera);
  const int shown = FastestFrame(truth);

  Progress progress(double(truth.size()) * (1 + kBlurredWork));
  for (const bool blurred : {false, true}) {
    result.plans.push_back(PlanFor(options, blurred));
    ForEachFrame(world, result.plans.back(), [&](const RenderedFrame& rendered) {
      for (OpenRun& open : runs) {
        if (TakesPart(open.run, blurred, rendered))
          open.tracking->Track(rendered.frame, rendered.truth.world_from_camera);
      }
      const std::string name = blurred ? "60fps-blur" : "60fps";
      const bool first_seed = !blurred || rendered.seed == options.seed;
      if (rendered.number == shown && first_seed) result.pictures.push_back({name, rendered.frame});
      if (first_seed) {
        progress.Advance(blurred ? kBlurredWork : 1, name + ", frame " +
                                                         std::to_string(rendered.number + 1) +
                                                         " of " + std::to_string(truth.size()));
      }
    });
  }
  for (OpenRun& open : runs) result.runs.push_back(Close(std::move(open)));
  return result;
}

}  // namespace silt::experiments
