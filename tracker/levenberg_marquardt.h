// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "silt/core/se3.h"
#include "silt/tracker/alignment_steps.h"
#include "silt/tracker/kernel/ldlt6.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/residual_agreement.h"
#include "silt/tracker/residual_norm.h"

// The decisions of Algorithm 1, once for the CPU and for the GPU: what to compute next, given what
// was computed last. It touches no image.
namespace silt::tracker {

inline constexpr int kMaxPyramidLevels = 12;

// AlignmentOptions, and what is to be known of the images, as plain data.
struct AlignmentPlan {
  int levels = 0;
  int max_iterations[kMaxPyramidLevels] = {};            // from the finest level
  std::int64_t measured_pixels[kMaxPyramidLevels] = {};  // of all references
  double min_update_norm[kMaxPyramidLevels] = {};
  double initial_damping = 0, damping_factor = 0, min_overlap = 0;
  bool scaled_damping = false;
  bool take_last_step = false;
  int scale_rounds = 0;
  bool robust = false, use_depth = false, rotation_only = false, fit_brightness = false;
  double depth_patch_px = 1;
  double max_disagreement = 0;  // 0: nothing is asked
  // Asks for the equations of a trial at once, as with a robust norm, instead of for its cost and
  // then for the equations where it is taken: the same results in fewer rounds.
  bool linearize_trials = false;
  bool keep_log = false;  // computes the cost of the last step of a level too, which is not taken
  double robust_scale = 0, robust_gradient = 0, reference_gradient = 0;
  RobustLoss robust_loss = RobustLoss::kGemanMcClure;
  // MeanRobustSquare(…): what makes a scale of the residuals a standard deviation.
  double robust_share = 1;
  double step_factor = 1;  // CurvatureLoss(…): how far short weighted squares fall

  bool operator==(const AlignmentPlan&) const = default;
};

enum class AlignmentFailure { kNone, kTooFewPixels, kNoSolution, kNoLevel, kNoTexture };

// Levenberg-Marquardt from the coarsest level to the finest. As long as something is wanted(), the
// caller computes it at level(), pose() and norm(), over all references, and hands it to Take().
class LevenbergMarquardt {
 public:
  enum class Wanted { kNothing, kCost, kEquations };

  SILT_HOST_DEVICE LevenbergMarquardt() = default;  // wants nothing
  SILT_HOST_DEVICE LevenbergMarquardt(const AlignmentPlan& plan, const SE3d& initial)
      : pose_(initial), level_(plan.levels + 1) {
    norm_.intensity.gradient = plan.robust_gradient;
    norm_.intensity.loss = norm_.inverse_depth.loss = plan.robust_loss;
    norm_.reference_gradient = plan.reference_gradient;
    norm_.use_depth = plan.use_depth;
    norm_.fit_brightness = plan.fit_brightness;
    NextLevel(plan);
  }

  SILT_HOST_DEVICE Wanted wanted() const { return wanted_; }
  SILT_HOST_DEVICE int level() const { return level_; }  // as in the paper: 1 is the finest
  SILT_HOST_DEVICE const SE3d& pose() const {
    if (phase_ == Phase::kAgreement) return agreement_.pose();
    return phase_ == Phase::kTrial ? trial_ : pose_;
  }
  SILT_HOST_DEVICE const ResidualNorm& norm() const { return norm_; }
  // Whether what is wanted comes first at its level: hidden pixels are to be found before.
  SILT_HOST_DEVICE bool starts_level() const { return phase_ == Phase::kStart; }

  // Of a cost, equations.cost alone counts.
  SILT_HOST_DEVICE void Take(const AlignmentPlan& plan, const NormalEquations& equations) {
    took_ = phase_ != Phase::kTrial && phase_ != Phase::kAgreement;
    if (phase_ == Phase::kAgreement) return TakeAgreement(plan, equations);
    if (phase_ == Phase::kTrial) return Judge(plan, equations);
    equations_ = equations;
    if (phase_ == Phase::kRelinearize) return Propose(plan);
    if (plan.robust && rounds_ < (level_count_ ? plan.scale_rounds : kFirstScaleRounds) &&
        !SetScales(plan)) {
      ++rounds_;
      phase_ = Phase::kScale;
      return;
    }
    BeginLevel(plan);
  }

  // Whether what was taken last was at the accepted pose, or at one that now is.
  SILT_HOST_DEVICE bool took() const { return took_; }

  // The result, once nothing is wanted; where it has failed, `equations` are those of the failure.
  SILT_HOST_DEVICE AlignmentFailure failure() const { return failure_; }
  SILT_HOST_DEVICE const SE3d& accepted_pose() const { return pose_; }
  SILT_HOST_DEVICE const NormalEquations& equations() const { return equations_; }
  SILT_HOST_DEVICE int level_count() const { return level_count_; }
  SILT_HOST_DEVICE const AlignmentLevel& level_summary(int i) const { return summaries_[i]; }
  // How many steps were tried, and the last one.
  SILT_HOST_DEVICE int steps() const { return steps_; }
  SILT_HOST_DEVICE const AlignmentStep& last_step() const { return last_step_; }

 private:
  enum class Phase { kStart, kScale, kTrial, kRelinearize, kAgreement };

  // Fewer residuals than this say nothing about six parameters; a level that cannot have them is
  // skipped.
  static constexpr int kMinPixels = 30;
  static constexpr int kFirstScaleRounds = 4;
  // A quarter of the size tells whether both kinds of residuals agree, in a sixteenth of the time.
  static constexpr int kAgreementLevel = 3;
  // Residuals are not taken for smaller than these: rounding to 8 bits leaves the first. Depth that
  // is exact would outweigh all intensities, and with them what they alone can tell of a camera
  // before a plane, while interpolating it over curved surfaces is not exact: what rounding to the
  // 0.2 mm of 16-bit files leaves at 1 m, and twice as much with each coarser level.
  static constexpr double kLeastIntensityScale = 0.2 / 255, kLeastInverseDepthScale = 5e-5;  // 1/m

  SILT_HOST_DEVICE void NextLevel(const AlignmentPlan& plan) {
    for (--level_; level_ >= 1; --level_) {
      if (plan.max_iterations[level_ - 1] > 0 && plan.measured_pixels[level_ - 1] >= kMinPixels) {
        rounds_ = 0;
        phase_ = Phase::kStart;
        wanted_ = Wanted::kEquations;
        return;
      }
    }
    wanted_ = Wanted::kNothing;
    phase_ = Phase::kStart;
    if (level_count_ == 0) {
      failure_ = AlignmentFailure::kNoLevel;
    } else if (!plan.rotation_only && !DeterminesPose()) {
      failure_ = AlignmentFailure::kNoTexture;
    } else if (plan.robust && plan.take_last_step) {
      Close(plan);
    }
  }

  // A level that ran out of iterations leaves equations at its pose, of a robust norm: one more
  // step costs no pass over the pixels. Nothing judges it, so steps must grow shorter.
  SILT_HOST_DEVICE void Close(const AlignmentPlan& plan) {
    Twistd update;
    if (!step_.accepted || summaries_[level_count_ - 1].converged) return;
    if (!Solve(plan, &update) || Length(update) > step_.update_norm) return;
    pose_ = SE3d::Exp(plan.step_factor * update) * pose_;
  }

  SILT_HOST_DEVICE void Fail(AlignmentFailure why) {
    failure_ = why;
    wanted_ = Wanted::kNothing;
  }

  SILT_HOST_DEVICE bool EnoughPixels(const AlignmentPlan& plan, const PhotometricCost& cost) const {
    return cost.pixels >= kMinPixels &&
           double(cost.pixels) >= plan.min_overlap * double(plan.measured_pixels[level_ - 1]);
  }

  SILT_HOST_DEVICE void BeginLevel(const AlignmentPlan& plan) {
    if (!EnoughPixels(plan, equations_.cost)) return Fail(AlignmentFailure::kTooFewPixels);
    AlignmentLevel& summary = summaries_[level_count_];
    summary.level = level_;
    summary.initial_cost = equations_.cost;
    damping_ = plan.initial_damping;
    cost_ = equations_.cost;
    Propose(plan);
  }

  SILT_HOST_DEVICE void EndLevel(const AlignmentPlan& plan) {
    summaries_[level_count_++].final_cost = cost_;
    if (AsksForAgreement(plan)) return BeginAgreement(plan);
    NextLevel(plan);
  }

  SILT_HOST_DEVICE bool AsksForAgreement(const AlignmentPlan& plan) const {
    bool finer = false;
    for (int level = 1; level < level_; ++level)
      finer = finer || plan.max_iterations[level - 1] > 0;
    return finer && level_ == kAgreementLevel && plan.max_disagreement > 0 && norm_.use_depth &&
           !plan.rotation_only;
  }

  SILT_HOST_DEVICE void BeginAgreement(const AlignmentPlan& plan) {
    kept_ = norm_;
    agreement_.Begin(pose_);
    phase_ = Phase::kAgreement;
    wanted_ = Wanted::kEquations;
    WeighOneKind(plan);
  }

  SILT_HOST_DEVICE void WeighOneKind(const AlignmentPlan& plan) {
    norm_.intensity.weight = agreement_.of_depth() ? 0 : 1 / Square(kept_.intensity, plan);
    norm_.inverse_depth.weight = agreement_.of_depth() ? 1 / Square(kept_.inverse_depth, plan) : 0;
  }

  SILT_HOST_DEVICE void TakeAgreement(const AlignmentPlan& plan, const NormalEquations& equations) {
    agreement_.Take(equations);
    if (!agreement_.done()) return WeighOneKind(plan);
    norm_ = kept_;
    intensity_share_ = agreement_.IntensityShare(plan.max_disagreement);
    LimitIntensities(plan);
    NextLevel(plan);
  }

  // σ², of a kind of residuals.
  SILT_HOST_DEVICE static double Square(const RobustBounds& bounds, const AlignmentPlan& plan) {
    const double sigma = bounds.scale / plan.robust_scale;
    return sigma * sigma;
  }

  SILT_HOST_DEVICE void LimitIntensities(const AlignmentPlan& plan) {
    if (intensity_share_ == 0) return;
    const double share =
        intensity_share_ * norm_.inverse_depth.weight * Square(norm_.inverse_depth, plan);
    norm_.intensity.weight = (share < 1 ? share : 1) / Square(norm_.intensity, plan);
  }

  // One iteration of Algorithm 1, up to the trial pose, unless the level is done.
  SILT_HOST_DEVICE void Propose(const AlignmentPlan& plan) {
    AlignmentLevel& summary = summaries_[level_count_];
    if (summary.iterations >= plan.max_iterations[level_ - 1]) return EndLevel(plan);
    ++summary.iterations;
    Twistd update;
    if (!Solve(plan, &update)) return Fail(AlignmentFailure::kNoSolution);
    const double norm = Length(update);
    step_ = {level_, summary.iterations, damping_, norm, cost_, {}, false};
    summary.converged = norm < plan.min_update_norm[level_ - 1];
    trial_ = SE3d::Exp(summary.converged ? plan.step_factor * update : update) * pose_;
    // What the last step leads to, only the log asks.
    if (summary.converged && !plan.keep_log) return TakeLastStep(plan);
    phase_ = Phase::kTrial;
    wanted_ = plan.robust || EquationsWithTrial(plan) ? Wanted::kEquations : Wanted::kCost;
  }

  // After a level's last trial nobody asks for its equations.
  SILT_HOST_DEVICE bool EquationsWithTrial(const AlignmentPlan& plan) const {
    return plan.linearize_trials &&
           summaries_[level_count_].iterations < plan.max_iterations[level_ - 1];
  }

  SILT_HOST_DEVICE void TakeLastStep(const AlignmentPlan& plan) {
    if (plan.take_last_step) pose_ = trial_;
    EndLevel(plan);
  }

  SILT_HOST_DEVICE static double Length(const Twistd& d) {
    using std::sqrt;
    return sqrt(Dot(d.omega, d.omega) + Dot(d.v, d.v));
  }

  // The other part of an iteration: whether the trial pose is taken.
  SILT_HOST_DEVICE void Judge(const AlignmentPlan& plan, const NormalEquations& trial) {
    const AlignmentLevel& summary = summaries_[level_count_];
    step_.trial_cost = trial.cost;
    step_.accepted = summary.converged
                         ? plan.take_last_step
                         : EnoughPixels(plan, trial.cost) && trial.cost.mean() < cost_.mean();
    ++steps_;
    took_ = step_.accepted;
    last_step_ = step_;
    if (summary.converged) return TakeLastStep(plan);
    if (!step_.accepted) {
      damping_ *= plan.damping_factor;
      return Propose(plan);
    }
    pose_ = trial_;
    cost_ = trial.cost;
    damping_ /= plan.damping_factor;
    if (plan.robust || EquationsWithTrial(plan)) {
      equations_ = trial;
    } else if (summary.iterations < plan.max_iterations[level_ - 1]) {
      phase_ = Phase::kRelinearize;
      wanted_ = Wanted::kEquations;
      return;
    }
    Propose(plan);
  }

  SILT_HOST_DEVICE void GetMatrix(double (&matrix)[6][6]) const {
    SILT_UNROLL for (int i = 0, k = 0; i < 6; ++i) {
      SILT_UNROLL for (int j = i; j < 6; ++j, ++k) {
        matrix[i][j] = matrix[j][i] = equations_.hessian[k];
      }
    }
  }

  // dξ = −(JᵀJ + αI)⁻¹·Jᵀr (eq. 17, damped), or Marquardt's with α·diag(JᵀJ); false where it has no
  // finite solution. With what solves in line wherever it is called, nvcc takes thrice as long.
  [[gnu::noinline]] SILT_HOST_DEVICE bool Solve(const AlignmentPlan& plan, Twistd* update) const {
    double matrix[6][6], d[6];
    GetMatrix(matrix);
    bool finite = true;
    SILT_UNROLL for (int i = 0; i < 6; ++i) d[i] = equations_.gradient[i];
    if (plan.rotation_only) FixTranslation(matrix, d);
    SILT_UNROLL for (int i = 0; i < 6; ++i) {
      matrix[i][i] += plan.scaled_damping ? damping_ * matrix[i][i] : damping_;
      finite = finite && kernel::IsFinite(d[i]);
      SILT_UNROLL for (int j = 0; j < 6; ++j) finite = finite && kernel::IsFinite(matrix[i][j]);
    }
    if (!finite) return false;
    const kernel::Ldlt6 ldlt(matrix);
    ldlt.Solve(d);
    SILT_UNROLL for (int i = 0; i < 6; ++i) finite = finite && kernel::IsFinite(d[i]);
    *update = {{-d[0], -d[1], -d[2]}, {-d[3], -d[4], -d[5]}};
    return finite && ldlt.ok();
  }

  // The equations of ω alone, whose solution has v = 0.
  SILT_HOST_DEVICE static void FixTranslation(double (&matrix)[6][6], double (&gradient)[6]) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        if (i >= 3 || j >= 3) matrix[i][j] = i == j ? 1 : 0;
      }
      if (i >= 3) gradient[i] = 0;
    }
  }

  // Whether the equations tell the six parameters apart: the pivots of JᵀJ, scaled to a unit
  // diagonal, stay clear of rounding.
  [[gnu::noinline]] SILT_HOST_DEVICE bool DeterminesPose() const {
    double matrix[6][6], scale[6];
    GetMatrix(matrix);
    bool good = true;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) good = good && kernel::IsFinite(matrix[i][j]);
      good = good && matrix[i][i] > 0;
      scale[i] = 1 / std::sqrt(matrix[i][i]);
    }
    if (!good) return false;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) matrix[i][j] = scale[i] * matrix[i][j] * scale[j];
    }
    return kernel::Ldlt6(matrix).LeastPivot() > 1e-7;
  }

  // Sets the norm's bounds and weights from the residuals at the pose; whether they were known well
  // enough already. A level starts with those of the coarser one.
  SILT_HOST_DEVICE bool SetScales(const AlignmentPlan& plan) {
    // Before there are any bounds, the residuals are squared alone: s = 1.
    const NormalEquations::Spread squares{equations_.cost.squares, equations_.cost.pixels};
    const bool near = SetScale(plan, norm_.robust() ? equations_.intensity : squares,
                               kLeastIntensityScale, &norm_.intensity);
    const double least_depth = kLeastInverseDepthScale * double(1 << (level_ - 1));
    const bool all_near = (!norm_.use_depth || SetScale(plan, equations_.inverse_depth, least_depth,
                                                        &norm_.inverse_depth)) &&
                          near;
    LimitIntensities(plan);
    return all_near;
  }

  // A depth camera finds depth from patches of pixels, whose noise is alike: as many pixels as lie
  // in one count as one. Noise of a few times the least scale is rounding, which knows no patches.
  SILT_HOST_DEVICE double DepthVariance(const AlignmentPlan& plan, double sigma,
                                        double least) const {
    constexpr double rounding = 4;
    const double patch_px = plan.depth_patch_px / double(1 << (level_ - 1));
    const double pixels = patch_px > 1 ? patch_px * patch_px : 1;
    const double noise = sigma * sigma - rounding * rounding * least * least;
    return sigma * sigma + (noise > 0 ? (pixels - 1) * noise : 0);
  }

  // σ² = mean(s·r²)/β, see ResidualScale. Without any residuals nothing is known.
  SILT_HOST_DEVICE bool SetScale(const AlignmentPlan& plan, const NormalEquations::Spread& spread,
                                 double least, RobustBounds* bounds) const {
    constexpr double close = 0.1;
    if (spread.count == 0) return true;
    const double share = bounds->scale > 0 ? plan.robust_share : 1;
    const double found = std::sqrt(spread.squares / double(spread.count) / share);
    const double sigma = least < found ? found : least;
    const double scale = plan.robust_scale * sigma;
    if (std::abs(scale - bounds->scale) < close * scale) return true;
    bounds->scale = scale;
    if (!norm_.use_depth) return false;
    const bool of_depth = bounds == &norm_.inverse_depth;
    bounds->weight = 1 / (of_depth ? DepthVariance(plan, sigma, least) : sigma * sigma);
    return false;
  }

  ResidualNorm norm_, kept_;
  ResidualAgreement agreement_;
  double intensity_share_ = 0;  // of the residuals' own weight; 0: as they are
  SE3d pose_, trial_;
  NormalEquations equations_;  // at pose_, but for a level's last iteration
  PhotometricCost cost_;       // at pose_
  double damping_ = 0;
  AlignmentLevel summaries_[kMaxPyramidLevels];
  AlignmentStep step_, last_step_;  // under way, and judged
  int level_ = 0, level_count_ = 0, rounds_ = 0, steps_ = 0;
  bool took_ = false;
  Phase phase_ = Phase::kStart;
  Wanted wanted_ = Wanted::kNothing;
  AlignmentFailure failure_ = AlignmentFailure::kNone;
};

}  // namespace silt::tracker
