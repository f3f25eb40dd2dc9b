// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "silt/core/error.h"
#include "silt/tracker/residual_scale.h"
#include "silt/tracker/stopwatch.h"

namespace silt::tracker {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Fewer residuals than this say nothing about six parameters; a level that cannot have them is
// skipped.
constexpr int kMinPixels = 30;

// Residuals are not taken for smaller than these: rounding to 8 bits leaves the first. Depth that
// is exact would outweigh all intensities, and with them what they alone can tell of a camera
// before a plane, while interpolating it over curved surfaces is not exact: 0.1 mm at 1 m, and what
// 16-bit files round to.
constexpr double kLeastIntensityScale = 0.2 / 255, kLeastInverseDepthScale = 1e-4;  // 1/m

Matrix6 SymmetricMatrix(const std::array<double, 21>& upper) {
  Matrix6 h;
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) h(i, j) = h(j, i) = upper[k];
  }
  return h;
}

// The equations of ω alone, whose solution has v = 0.
void FixTranslation(Matrix6* hessian, Vector6* gradient) {
  hessian->topRightCorner<3, 3>().setZero();
  hessian->bottomLeftCorner<3, 3>().setZero();
  hessian->bottomRightCorner<3, 3>().setIdentity();
  gradient->tail<3>().setZero();
}

// dξ = −(JᵀJ + αI)⁻¹·Jᵀr (eq. 17, damped), or nothing where it has no finite solution.
std::optional<Twistd> Solve(const NormalEquations& equations, double damping, bool rotation_only) {
  Vector6 gradient = Eigen::Map<const Vector6>(equations.gradient.data());
  Matrix6 hessian = SymmetricMatrix(equations.hessian);
  if (rotation_only) FixTranslation(&hessian, &gradient);
  const Matrix6 damped = hessian + damping * Matrix6::Identity();
  if (!damped.allFinite() || !gradient.allFinite()) return std::nullopt;
  const Eigen::LDLT<Matrix6> ldlt(damped);
  const Vector6 d = -ldlt.solve(gradient);
  if (ldlt.info() != Eigen::Success || !d.allFinite()) return std::nullopt;
  return Twistd{{d[0], d[1], d[2]}, {d[3], d[4], d[5]}};
}

double UpdateNorm(const Twistd& d) { return std::sqrt(Dot(d.omega, d.omega) + Dot(d.v, d.v)); }

// Whether the equations tell the six parameters apart: the pivots of JᵀJ, scaled to a unit
// diagonal, stay clear of rounding.
bool DeterminesPose(const NormalEquations& equations) {
  const Matrix6 h = SymmetricMatrix(equations.hessian);
  if (!h.allFinite() || h.diagonal().minCoeff() <= 0) return false;
  const Vector6 scale = h.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Matrix6> ldlt(Matrix6(scale.asDiagonal() * h * scale.asDiagonal()));
  return ldlt.vectorD().minCoeff() > 1e-7;
}

class LevenbergMarquardt {
 public:
  LevenbergMarquardt(const Backend& backend, const std::vector<ReferenceView>& references,
                     const CurrentPyramid& current, const AlignmentOptions& options)
      : backend_(backend),
        references_(references),
        current_(current),
        options_(options),
        visible_(references.size()) {
    norm_.intensity.gradient = options.robust_gradient;
    norm_.use_depth = options.depth_residual && current.has_depth();
  }

  AlignmentResult Run(const SE3d& initial) {
    pose_ = initial;
    // From the coarsest level to the finest, each from where the one before it ended.
    for (int level = options_.levels(); level >= 1 && result_.failure.empty(); --level) {
      if (options_.max_iterations[level - 1] > 0 && Measured(level) >= kMinPixels) RunLevel(level);
    }
    if (result_.failure.empty()) CheckEnd();
    if (options_.robust()) {
      result_.intensity_scale = norm_.intensity.scale / options_.robust_scale;
      result_.inverse_depth_scale = norm_.inverse_depth.scale / options_.robust_scale;
    }
    result_.ok = result_.failure.empty();
    if (result_.ok) SetCovariance();
    result_.current_from_reference = result_.ok ? pose_ : initial;
    return std::move(result_);
  }

 private:
  int Measured(int level) const {
    int sum = 0;
    for (const ReferenceView& reference : references_) {
      sum += reference.pyramid.levels()[level - 1].measured_pixels;
    }
    return sum;
  }

  bool EnoughPixels(int level, const PhotometricCost& cost) const {
    return cost.pixels >= kMinPixels &&
           double(cost.pixels) >= options_.min_overlap * Measured(level);
  }

  void RunLevel(int level) {
    FindVisible(level);
    Linearize(level);
    if (options_.robust()) EstimateScale(level);
    if (!CheckStart(level)) return;
    const PinholeCamera& camera = references_.front().pyramid.levels()[level - 1].camera;
    AlignmentLevel summary;
    summary.level = level;
    summary.width = camera.width;
    summary.height = camera.height;
    summary.initial_cost = equations_.cost;
    damping_ = options_.initial_damping;
    cost_ = equations_.cost;
    for (int i = 1; i <= options_.max_iterations[level - 1] && !summary.converged; ++i) {
      summary.iterations = i;
      const std::optional<Twistd> update = TimedSolve();
      if (!update) return Fail("the normal equations have no finite solution");
      summary.converged = Step(level, i, *update);
    }
    summary.final_cost = cost_;
    result_.levels.push_back(summary);
  }

  // One iteration of Algorithm 1; true where |dξ| < ε.
  bool Step(int level, int iteration, const Twistd& update) {
    AlignmentStep step{level, iteration, damping_, UpdateNorm(update), cost_, {}, false};
    const bool converged = step.update_norm < options_.min_update_norm;
    // The step is not taken: only the log asks what it would have led to.
    if (converged && !options_.keep_log) return true;
    const SE3d trial = TimedUpdate(update);
    NormalEquations trial_equations;
    if (options_.robust()) {
      trial_equations = LinearizedAt(level, trial);
      step.trial_cost = trial_equations.cost;
    } else {
      step.trial_cost = TimedCost(level, trial);
    }
    step.accepted =
        !converged && EnoughPixels(level, step.trial_cost) && step.trial_cost.mean() < cost_.mean();
    if (step.accepted) {
      pose_ = trial;
      cost_ = step.trial_cost;
      if (options_.robust()) {
        equations_ = trial_equations;
      } else if (iteration < options_.max_iterations[level - 1]) {
        Linearize(level);
      }
      damping_ /= options_.damping_factor;
    } else {
      damping_ *= options_.damping_factor;
    }
    if (options_.keep_log) result_.log.push_back(step);
    return converged;
  }

  // Where the keyframe's own depth tells: at the first level, whose result serves the finer ones
  // too, and again where the pose is all but known.
  void FindVisible(int level) {
    if (!options_.exclude_hidden) return;
    const Stopwatch watch(&result_.times.residual_ms);
    for (std::size_t i = 0; i < references_.size(); ++i) {
      if (visible_[i] && level > 1 && !current_.has_depth()) continue;
      visible_[i] = backend_.WithoutHidden({references_[i].pyramid, current_}, level - 1,
                                           pose_ * references_[i].anchor_from_reference);
    }
  }

  ImagePair VisiblePair(std::size_t i) const {
    return {visible_[i] ? *visible_[i] : references_[i].pyramid, current_};
  }

  // Sets the norm's bounds and weights from the residuals at the pose. A level starts with those of
  // the coarser one.
  void EstimateScale(int level) {
    constexpr int rounds = 4;
    for (int i = 0; i < rounds; ++i) {
      const bool near = SetScale(IntensitySpread(), kLeastIntensityScale, &norm_.intensity);
      const bool near_too =
          !norm_.use_depth ||
          SetScale(equations_.inverse_depth, kLeastInverseDepthScale, &norm_.inverse_depth);
      if (near && near_too) return;
      Linearize(level);
    }
  }

  // Before there are any bounds, the residuals are squared alone: s = 1.
  NormalEquations::Spread IntensitySpread() const {
    if (norm_.robust()) return equations_.intensity;
    return {equations_.cost.squares, equations_.cost.pixels};
  }

  // Whether the scale was known well enough already. Without any residuals nothing is known.
  bool SetScale(const NormalEquations::Spread& spread, double least, RobustBounds* bounds) const {
    constexpr double close = 0.1;
    if (spread.count == 0) return true;
    const double factor = bounds->scale > 0 ? options_.robust_scale : 0;
    const double mean = spread.squares / double(spread.count);
    const double sigma = std::max(least, ResidualScale(mean, factor));
    const double scale = options_.robust_scale * sigma;
    if (std::abs(scale - bounds->scale) < close * scale) return true;
    bounds->scale = scale;
    if (norm_.use_depth) bounds->weight = 1 / (sigma * sigma);
    return false;
  }

  std::optional<Twistd> TimedSolve() {
    const Stopwatch watch(&result_.times.update_ms);
    return Solve(equations_, damping_, options_.rotation_only);
  }

  SE3d TimedUpdate(const Twistd& update) {
    const Stopwatch watch(&result_.times.update_ms);
    return SE3d::Exp(update) * pose_;
  }

  PhotometricCost TimedCost(int level, const SE3d& pose) {
    const Stopwatch watch(&result_.times.residual_ms);
    PhotometricCost cost;
    for (std::size_t i = 0; i < references_.size(); ++i) {
      cost += backend_.Cost(VisiblePair(i), level - 1, pose * references_[i].anchor_from_reference);
    }
    return cost;
  }

  NormalEquations LinearizedAt(int level, const SE3d& pose) {
    const Stopwatch watch(&result_.times.jacobian_ms);
    NormalEquations sum;
    for (std::size_t i = 0; i < references_.size(); ++i) {
      sum += backend_.Linearize(VisiblePair(i), level - 1,
                                pose * references_[i].anchor_from_reference, norm_);
    }
    return sum;
  }

  void Linearize(int level) { equations_ = LinearizedAt(level, pose_); }

  void Fail(const std::string& why) { result_.failure = why; }

  bool CheckStart(int level) {
    if (EnoughPixels(level, equations_.cost)) return true;
    Fail("the images share " + std::to_string(equations_.cost.pixels) + " of " +
         std::to_string(Measured(level)) + " measured pixels at level " + std::to_string(level));
    return false;
  }

  void CheckEnd() {
    if (result_.levels.empty()) return Fail("no pyramid level has enough measured pixels");
    if (!options_.rotation_only && !DeterminesPose(equations_))
      Fail("the images' texture does not determine a pose");
  }

  // Of a residual that knows nothing of its neighbours. Depth residuals come with weights in these
  // units already.
  double ResidualVariance() const {
    if (norm_.use_depth) return 1;
    return options_.robust() ? result_.intensity_scale * result_.intensity_scale
                             : equations_.cost.mean_square();
  }

  // C = κ·H⁻¹ with κ = tr(H⁻¹·Σg·gᵀ)/6: the variance of the residuals by what the gradients of
  // tiles scatter, so that neighbours that err together count for fewer. A robust norm's curvature
  // is less than H, which holds weights alone.
  void SetCovariance() {
    const double loss = options_.robust() ? CurvatureLoss(options_.robust_scale) : 1;
    const Matrix6 inverse = SymmetricMatrix(equations_.hessian).ldlt().solve(Matrix6::Identity());
    const double scattered = (inverse * SymmetricMatrix(equations_.scatter)).trace() / 6;
    const double variance = scattered > 0 ? scattered : ResidualVariance();
    for (int i = 0; i < 36; ++i) {
      result_.covariance[i] =
          variance * loss * loss * 0.5 * (inverse(i / 6, i % 6) + inverse(i % 6, i / 6));
    }
  }

  const Backend& backend_;
  const std::vector<ReferenceView>& references_;
  const CurrentPyramid& current_;
  const AlignmentOptions& options_;
  std::vector<std::unique_ptr<ReferencePyramid>> visible_;  // the references, less hidden pixels
  ResidualNorm norm_;
  SE3d pose_;
  NormalEquations equations_;  // at pose_, but for a level's last iteration
  PhotometricCost cost_;       // at pose_
  double damping_ = 0;
  AlignmentResult result_;
};

}  // namespace

AlignmentResult Align(const Backend& backend, const std::vector<ReferenceView>& references,
                      const CurrentPyramid& current, const SE3d& initial,
                      const AlignmentOptions& options) {
  SILT_CHECK(!references.empty());
  for (const ReferenceView& reference : references) {
    SILT_CHECK(int(reference.pyramid.levels().size()) >= options.levels());
  }
  return LevenbergMarquardt(backend, references, current, options).Run(initial);
}

AlignmentResult Align(const Backend& backend, const ImagePair& pair, const SE3d& initial,
                      const AlignmentOptions& options) {
  return Align(backend, {{pair.reference, {}}}, pair.current, initial, options);
}

}  // namespace silt::tracker
