// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/alignment.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/tracker/alignment_result.h"
#include "silt/tracker/judged_residuals.h"
#include "silt/tracker/residual_scale.h"
#include "silt/tracker/stopwatch.h"

namespace silt::tracker {
namespace {

// The camera is the same for all of them.
double EdgeContrast(const ReferenceViews& references) {
  double most = 0;
  for (const ReferenceView& view : references) most = std::max(most, view.edge_contrast);
  return most;
}

AlignmentPlan PlanOf(const ReferenceViews& references, const CurrentPyramid& current,
                     const AlignmentOptions& options) {
  SILT_CHECK(options.levels() <= kMaxPyramidLevels);
  AlignmentPlan plan;
  plan.levels = options.levels();
  const int finest = options.Pyramids().finest;
  for (int i = 0; i < plan.levels; ++i) {
    plan.max_iterations[i] = options.max_iterations[i];
    plan.min_update_norm[i] =
        options.min_update_norm * std::pow(options.coarser_update_norm, std::max(0, i - finest));
    for (const ReferenceView& reference : references) {
      plan.measured_pixels[i] += reference.pyramid.levels()[i].measured_pixels;
    }
  }
  plan.initial_damping = options.initial_damping;
  plan.damping_factor = options.damping_factor;
  plan.scaled_damping = options.scaled_damping;
  plan.take_last_step = options.take_last_step;
  plan.scale_rounds = options.scale_rounds;
  plan.min_overlap = options.min_overlap;
  plan.robust = options.robust();
  plan.use_depth = options.depth_residual && current.has_depth();
  plan.rotation_only = options.rotation_only;
  plan.fit_brightness = options.affine_brightness;
  plan.depth_patch_px = options.depth_patch_px;
  if (options.DoubtsColours(EdgeContrast(references)))
    plan.max_disagreement = options.max_disagreement;
  plan.keep_log = options.keep_log;
  plan.robust_scale = options.robust_scale;
  plan.robust_gradient = options.robust_gradient;
  plan.robust_loss = options.robust_loss;
  plan.reference_gradient = options.reference_gradient;
  if (plan.robust) {
    plan.robust_share = MeanRobustSquare(options.robust_loss, options.robust_scale);
    plan.step_factor = CurvatureLoss(options.robust_loss, options.robust_scale);
  }
  return plan;
}

// Computes what the optimizer wants, on any backend.
class Evaluation {
 public:
  Evaluation(const Backend& backend, const ReferenceViews& references,
             const CurrentPyramid& current, bool exclude_hidden)
      : backend_(backend),
        references_(references),
        current_(current),
        exclude_hidden_(exclude_hidden),
        visible_(references.size()),
        brightness_(references.size()),
        fitted_(references.size()) {}

  NormalEquations Compute(const LevenbergMarquardt& optimizer) {
    if (optimizer.starts_level() && exclude_hidden_) FindVisible(optimizer);
    if (optimizer.wanted() == LevenbergMarquardt::Wanted::kCost) return Cost(optimizer);
    return Linearized(optimizer);
  }

  // The pose that was computed last is taken, and with it the brightness that fits there.
  void TakeBrightness() { brightness_ = fitted_; }
  const Brightness& brightness_of_first() const { return brightness_.front(); }

  AlignmentTimes times;

 private:
  // Where the keyframe's own depth tells: at the first level, whose result serves the finer ones
  // too, and again where the pose is all but known.
  void FindVisible(const LevenbergMarquardt& optimizer) {
    const Stopwatch watch(&times.residual_ms);
    for (std::size_t i = 0; i < references_.size(); ++i) {
      if (visible_[i] && optimizer.level() > 1 && !current_.has_depth()) continue;
      visible_[i] =
          backend_.WithoutHidden({references_[i].pyramid, current_}, optimizer.level() - 1,
                                 optimizer.pose() * references_[i].anchor_from_reference);
    }
  }

  ImagePair VisiblePair(std::size_t i) const {
    return {visible_[i] ? *visible_[i] : references_[i].pyramid, current_};
  }

  NormalEquations Cost(const LevenbergMarquardt& optimizer) {
    const Stopwatch watch(&times.residual_ms);
    NormalEquations sum;
    for (std::size_t i = 0; i < references_.size(); ++i) {
      sum.cost += backend_.Cost(VisiblePair(i), optimizer.level() - 1,
                                optimizer.pose() * references_[i].anchor_from_reference);
    }
    return sum;
  }

  NormalEquations Linearized(const LevenbergMarquardt& optimizer) {
    const Stopwatch watch(&times.jacobian_ms);
    NormalEquations sum;
    ResidualNorm norm = optimizer.norm();
    for (std::size_t i = 0; i < references_.size(); ++i) {
      norm.brightness = brightness_[i];
      const NormalEquations equations =
          backend_.Linearize(VisiblePair(i), optimizer.level() - 1,
                             optimizer.pose() * references_[i].anchor_from_reference, norm);
      fitted_[i] = equations.brightness;
      sum += equations;
    }
    return sum;
  }

  const Backend& backend_;
  const ReferenceViews& references_;
  const CurrentPyramid& current_;
  const bool exclude_hidden_;
  PooledVector<std::unique_ptr<ReferencePyramid>> visible_;  // the references, less hidden pixels
  PooledVector<Brightness> brightness_, fitted_;             // of the references
};

AlignmentJob JobOf(const Backend& backend, const ReferenceViews& references,
                   const CurrentPyramid& current, const SE3d& initial,
                   const AlignmentOptions& options) {
  SILT_CHECK(!references.empty());
  backend.CheckHas(options, int(references.size()));
  for (const ReferenceView& reference : references) {
    SILT_CHECK(int(reference.pyramid.levels().size()) >= options.levels());
  }
  return {PlanOf(references, current, options),
          references,
          current,
          options.exclude_hidden,
          initial,
          JudgedLevel(references.front().pyramid),
          JudgedNorm(),
          {},
          {},
          {}};
}

AlignmentStage StageOf(const Backend& backend, const OwnedPair& pair,
                       const AlignmentOptions& options) {
  const AlignmentJob alone = JobOf(backend, {{*pair.reference, {}}}, *pair.current, {}, options);
  return {alone.plan, pair.images(), alone.exclude_hidden};
}

void AddStages(const Backend& backend, const CoarseStart& first, AlignmentJob* job) {
  for (const CoarseStart::Stage& stage : first.stages) {
    job->first.push_back(StageOf(backend, stage.pair, stage.options));
  }
  job->compared.emplace(first.compared.images());
}

AlignmentResult ResultOf(const FinishedAlignment& finished, const AlignmentJob& job,
                         const AlignmentOptions& options) {
  AlignmentResult result =
      ResultOf(finished.optimizer, job.plan, job.references.front().pyramid.levels(), options);
  if (!result.ok) result.current_from_reference = job.initial;
  return result;
}

AlignmentResult StepByStep(const Backend& backend, const AlignmentJob& job,
                           const AlignmentOptions& options) {
  Evaluation evaluation(backend, job.references, job.current, job.exclude_hidden);
  LevenbergMarquardt optimizer(job.plan, job.initial);
  std::vector<AlignmentStep> log;
  while (optimizer.wanted() != LevenbergMarquardt::Wanted::kNothing) {
    const NormalEquations equations = evaluation.Compute(optimizer);
    const int steps = optimizer.steps();
    const Stopwatch watch(&evaluation.times.update_ms);
    optimizer.Take(job.plan, equations);
    if (options.affine_brightness && optimizer.took()) evaluation.TakeBrightness();
    if (options.keep_log && optimizer.steps() > steps) log.push_back(optimizer.last_step());
  }
  AlignmentResult result = ResultOf(FinishedAlignment{optimizer, {}, {}, {}, 0}, job, options);
  result.times = evaluation.times;
  if (options.affine_brightness) result.brightness = evaluation.brightness_of_first();
  result.log = std::move(log);
  return result;
}

// Where its stages lead to from `initial`, one by one.
std::optional<SE3d> EndOf(const Backend& backend, const CoarseStart& first, const SE3d& initial) {
  SE3d end = initial;
  for (const CoarseStart::Stage& stage : first.stages) {
    const AlignmentResult result = Align(backend, stage.pair.images(), end, stage.options);
    if (!result.ok) return std::nullopt;
    end = result.current_from_reference;
  }
  const std::vector<PhotometricCost> costs =
      backend.Costs(first.compared.images(), 0, {initial, end});
  return IsMoreAlike(costs[1], costs[0]) ? std::optional(end) : std::nullopt;
}

}  // namespace

AlignmentResult Align(const Backend& backend, const ReferenceViews& references,
                      const CurrentPyramid& current, const SE3d& initial,
                      const AlignmentOptions& options, const CoarseStart* first,
                      const Polish* last) {
  AlignmentJob job = JobOf(backend, references, current, initial, options);
  if (first) AddStages(backend, *first, &job);
  if (last) job.last.emplace(StageOf(backend, last->pair, last->options));
  double milliseconds = 0;
  std::vector<FinishedAlignment> finished;
  {
    const Stopwatch watch(&milliseconds);
    finished = backend.Run({job});
  }
  if (finished.empty()) {
    const std::optional<SE3d> coarse = first ? EndOf(backend, *first, initial) : std::nullopt;
    if (coarse) job.initial = *coarse;
    AlignmentResult result = StepByStep(backend, job, options);
    result.coarse = coarse;
    return result;
  }
  job.initial = finished.front().coarse.value_or(initial);
  AlignmentResult result = ResultOf(finished.front(), job, options);
  result.coarse = finished.front().coarse;
  result.times.jacobian_ms = milliseconds;  // the whole of it: it is not known in parts
  result.batch_ms = finished.front().batch_ms;
  if (result.ok) result.judged = finished.front().judged;
  if (result.ok && finished.front().last) {
    result.polished = std::make_shared<const AlignmentResult>(ResultOf(
        *finished.front().last, job.last->plan, last->pair.reference->levels(), last->options));
  }
  return result;
}

AlignmentResult Align(const Backend& backend, const ImagePair& pair, const SE3d& initial,
                      const AlignmentOptions& options) {
  return Align(backend, {{pair.reference, {}}}, pair.current, initial, options);
}

std::vector<AlignmentResult> AlignBatch(const Backend& backend,
                                        const std::vector<AlignmentStart>& starts,
                                        const AlignmentOptions& options) {
  AlignmentJobs jobs;
  for (const AlignmentStart& start : starts) {
    jobs.push_back(JobOf(backend, {{start.reference, {}}}, start.current, start.initial, options));
    jobs.back().judged_level = -1;
  }
  const std::vector<FinishedAlignment> finished = backend.Run(jobs);
  std::vector<AlignmentResult> results(starts.size());
  for (std::size_t i = 0; i < finished.size(); ++i) {
    results[i] = ResultOf(finished[i], jobs[i], options);
    results[i].batch_ms = finished[i].batch_ms;
  }
  if (!finished.empty()) return results;
  // Pairs side by side, rather than the pixels of one.
  ParallelFor(int(jobs.size()), [&](int i) {
    results[std::size_t(i)] = StepByStep(backend, jobs[std::size_t(i)], options);
  });
  return results;
}

}  // namespace silt::tracker
