// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/alignment_result.h"

#include <Eigen/Cholesky>

#include "silt/tracker/residual_scale.h"
#include "silt/tracker/sum_layout.h"

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

// C = f·κ·H⁻¹ with κ = tr(H⁻¹·Σg·gᵀ)/6: the variance of the residuals by what the gradients of
// stripes scatter, so that neighbours that err together count for fewer. A robust norm's curvature
// is less than H, which holds weights alone. f is options.covariance_factor.
Covariance6 CovarianceOf(const LevenbergMarquardt& optimizer, const AlignmentOptions& options) {
  const NormalEquations& equations = optimizer.equations();
  const double loss =
      options.robust() ? CurvatureLoss(options.robust_loss, options.robust_scale) : 1;
  const Matrix6 inverse = SymmetricMatrix(equations.hessian).ldlt().solve(Matrix6::Identity());
  // At the pose that is found, the stripes' gradients sum to zero: one of them tells nothing new.
  constexpr double free_share = double(kScatterStripes - 1) / kScatterStripes;
  const double scattered = (inverse * SymmetricMatrix(equations.scatter)).trace() / 6 / free_share;
  const double variance = scattered > 0 ? scattered : ResidualVariance(optimizer, options);
  const double factor = options.covariance_factor * variance * loss * loss;
  Covariance6 covariance;
  for (int i = 0; i < 36; ++i) {
    covariance[i] = factor * 0.5 * (inverse(i / 6, i % 6) + inverse(i % 6, i / 6));
  }
  return covariance;
}

}  // namespace

AlignmentResult ResultOf(const LevenbergMarquardt& optimizer, const AlignmentPlan& plan,
                         const PyramidLevels& levels, const AlignmentOptions& options) {
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

}  // namespace silt::tracker
