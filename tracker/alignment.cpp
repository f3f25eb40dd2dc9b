// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/alignment.h"

#include <Eigen/Cholesky>
#include <memory>
#include <utility>

#include "silt/core/error.h"
#include "silt/tracker/levenberg_marquardt.h"
#include "silt/tracker/residual_scale.h"
#include "silt/tracker/stopwatch.h"

namespace silt::tracker {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 SymmetricMatrix(const std::array<double, 21>& upper) {
  Matrix6 h;
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) h(i, j) = h(j, i) = upper[k];
  }
  return h;
}

AlignmentPlan PlanOf(const std::vector<ReferenceView>& references, const CurrentPyramid& current,
                     const AlignmentOptions& options) {
  SILT_CHECK(options.levels() <= kMaxPyramidLevels);
  AlignmentPlan plan;
  plan.levels = options.levels();
  for (int i = 0; i < plan.levels; ++i) {
    plan.max_iterations[i] = options.max_iterations[i];
    for (const ReferenceView& reference : references) {
      plan.measured_pixels[i] += reference.pyramid.levels()[i].measured_pixels;
    }
  }
  plan.initial_damping = options.initial_damping;
  plan.damping_factor = options.damping_factor;
  plan.min_update_norm = options.min_update_norm;
  plan.min_overlap = options.min_overlap;
  plan.robust = options.robust();
  plan.use_depth = options.depth_residual && current.has_depth();
  plan.rotation_only = options.rotation_only;
  plan.keep_log = options.keep_log;
  plan.robust_scale = options.robust_scale;
  plan.robust_gradient = options.robust_gradient;
  if (plan.robust) plan.robust_share = MeanRobustSquare(options.robust_scale);
  return plan;
}

// Computes what the optimizer wants, on any backend.
class Evaluation {
 public:
  Evaluation(const Backend& backend, const std::vector<ReferenceView>& references,
             const CurrentPyramid& current, bool exclude_hidden)
      : backend_(backend),
        references_(references),
        current_(current),
        exclude_hidden_(exclude_hidden),
        visible_(references.size()) {}

  NormalEquations Compute(const LevenbergMarquardt& optimizer) {
    if (optimizer.starts_level() && exclude_hidden_) FindVisible(optimizer);
    if (optimizer.wanted() == LevenbergMarquardt::Wanted::kCost) return Cost(optimizer);
    return Linearized(optimizer);
  }

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
    for (std::size_t i = 0; i < references_.size(); ++i) {
      sum += backend_.Linearize(VisiblePair(i), optimizer.level() - 1,
                                optimizer.pose() * references_[i].anchor_from_reference,
                                optimizer.norm());
    }
    return sum;
  }

  const Backend& backend_;
  const std::vector<ReferenceView>& references_;
  const CurrentPyramid& current_;
  const bool exclude_hidden_;
  std::vector<std::unique_ptr<ReferencePyramid>> visible_;  // the references, less hidden pixels
};

std::string Text(const LevenbergMarquardt& optimizer, const AlignmentPlan& plan) {
  switch (optimizer.failure()) {
    case AlignmentFailure::kTooFewPixels:
      return "the images share " + std::to_string(optimizer.equations().cost.pixels) + " of " +
             std::to_string(plan.measured_pixels[optimizer.level() - 1]) +
             " measured pixels at level " + std::to_string(optimizer.level());
    case AlignmentFailure::kNoSolution:
      return "the normal equations have no finite solution";
    case AlignmentFailure::kNoLevel:
      return "no pyramid level has enough measured pixels";
    case AlignmentFailure::kNoTexture:
      return "the images' texture does not determine a pose";
    case AlignmentFailure::kNone:
      break;
  }
  return "";
}

// Of a residual that knows nothing of its neighbours. Depth residuals come with weights in these
// units already.
double ResidualVariance(const LevenbergMarquardt& optimizer, const AlignmentOptions& options) {
  if (optimizer.norm().use_depth) return 1;
  const double scale = optimizer.norm().intensity.scale / options.robust_scale;
  return options.robust() ? scale * scale : optimizer.equations().cost.mean_square();
}

// C = κ·H⁻¹ with κ = tr(H⁻¹·Σg·gᵀ)/6: the variance of the residuals by what the gradients of
// tiles scatter, so that neighbours that err together count for fewer. A robust norm's curvature
// is less than H, which holds weights alone.
Covariance6 CovarianceOf(const LevenbergMarquardt& optimizer, const AlignmentOptions& options) {
  const NormalEquations& equations = optimizer.equations();
  const double loss = options.robust() ? CurvatureLoss(options.robust_scale) : 1;
  const Matrix6 inverse = SymmetricMatrix(equations.hessian).ldlt().solve(Matrix6::Identity());
  const double scattered = (inverse * SymmetricMatrix(equations.scatter)).trace() / 6;
  const double variance = scattered > 0 ? scattered : ResidualVariance(optimizer, options);
  Covariance6 covariance;
  for (int i = 0; i < 36; ++i) {
    covariance[i] = variance * loss * loss * 0.5 * (inverse(i / 6, i % 6) + inverse(i % 6, i / 6));
  }
  return covariance;
}

// What of an alignment its optimizer knows.
AlignmentResult ResultOf(const LevenbergMarquardt& optimizer, const AlignmentPlan& plan,
                         const std::vector<PyramidLevel>& levels, const AlignmentOptions& options) {
  AlignmentResult result;
  for (int i = 0; i < optimizer.level_count(); ++i) {
    AlignmentLevel summary = optimizer.level_summary(i);
    const PinholeCamera& camera = levels[summary.level - 1].camera;
    summary.width = camera.width;
    summary.height = camera.height;
    result.levels.push_back(summary);
  }
  result.failure = Text(optimizer, plan);
  result.ok = result.failure.empty();
  if (options.robust()) {
    result.intensity_scale = optimizer.norm().intensity.scale / options.robust_scale;
    result.inverse_depth_scale = optimizer.norm().inverse_depth.scale / options.robust_scale;
  }
  if (result.ok) result.covariance = CovarianceOf(optimizer, options);
  result.current_from_reference = optimizer.accepted_pose();
  return result;
}

}  // namespace

AlignmentResult Align(const Backend& backend, const std::vector<ReferenceView>& references,
                      const CurrentPyramid& current, const SE3d& initial,
                      const AlignmentOptions& options) {
  SILT_CHECK(!references.empty());
  for (const ReferenceView& reference : references) {
    SILT_CHECK(int(reference.pyramid.levels().size()) >= options.levels());
  }
  const AlignmentPlan plan = PlanOf(references, current, options);
  Evaluation evaluation(backend, references, current, options.exclude_hidden);
  LevenbergMarquardt optimizer(plan, initial);
  std::vector<AlignmentStep> log;
  while (optimizer.wanted() != LevenbergMarquardt::Wanted::kNothing) {
    const NormalEquations equations = evaluation.Compute(optimizer);
    const int steps = optimizer.steps();
    const Stopwatch watch(&evaluation.times.update_ms);
    optimizer.Take(plan, equations);
    if (options.keep_log && optimizer.steps() > steps) log.push_back(optimizer.last_step());
  }
  AlignmentResult result = ResultOf(optimizer, plan, references.front().pyramid.levels(), options);
  if (!result.ok) result.current_from_reference = initial;
  result.times = evaluation.times;
  result.log = std::move(log);
  return result;
}

AlignmentResult Align(const Backend& backend, const ImagePair& pair, const SE3d& initial,
                      const AlignmentOptions& options) {
  return Align(backend, {{pair.reference, {}}}, pair.current, initial, options);
}

}  // namespace silt::tracker
