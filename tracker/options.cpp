// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/options.h"

#include <string>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

// Fails for NaN as well.
void CheckRange(const char* option, double value, double low, double high) {
  if (value >= low && value <= high) return;
  const auto text = [](double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  throw Error(std::string(option) + " is " + text(value) + "; give a number from " + text(low) +
              " to " + text(high));
}

}  // namespace

PyramidOptions AlignmentOptions::Pyramids() const {
  PyramidOptions options{levels(), depth_edge_margin_px, depth_residual, 0, interpolant};
  while (options.finest + 1 < levels() && max_iterations[options.finest] == 0) ++options.finest;
  return options;
}

bool AlignmentOptions::DoubtsColours(double edge_contrast) const {
  if (max_disagreement == 0) return false;
  return registered_contrast == 0 || (edge_contrast > 0 && edge_contrast < registered_contrast);
}

void AlignmentOptions::Validate() const {
  CheckRange("alignment.max_iterations (number of pyramid levels)", levels(), 1, 12);
  for (int iterations : max_iterations) {
    CheckRange("alignment.max_iterations", iterations, 0, 100000);
  }
  CheckRange("alignment.initial_damping", initial_damping, 0, 1e12);
  CheckRange("alignment.damping_factor", damping_factor, 1, 1e6);
  CheckRange("alignment.min_update_norm", min_update_norm, 0, 1);
  CheckRange("alignment.coarser_update_norm", coarser_update_norm, 1, 100);
  CheckRange("alignment.min_overlap", min_overlap, 0, 1);
  CheckRange("alignment.depth_edge_margin_px", depth_edge_margin_px, 0, 100);
  // With a bound far below the noise, next to no residual would count.
  if (robust_scale != 0) CheckRange("alignment.robust_scale (0: squares)", robust_scale, 0.1, 1e6);
  CheckRange("alignment.reference_gradient", reference_gradient, 0, 1);
  CheckRange("alignment.robust_gradient", robust_gradient, 0, 1e6);
  CheckRange("alignment.depth_patch_px", depth_patch_px, 1, 100);
  CheckRange("alignment.max_disagreement", max_disagreement, 0, 1e9);
  CheckRange("alignment.registered_contrast", registered_contrast, 0, 1e6);
  CheckRange("alignment.scale_rounds", scale_rounds, 0, 100);
  CheckRange("alignment.covariance_factor", covariance_factor, 1e-6, 1e6);
  if (depth_residual && !(use_current_depth && robust_scale > 0)) {
    throw Error("alignment.depth_residual needs use_current_depth, and robust_scale above 0");
  }
  if (affine_brightness && robust_scale == 0) {
    throw Error("alignment.affine_brightness needs robust_scale above 0");
  }
}

void KeyframeOptions::Validate() const {
  CheckRange("keyframes.max_distance_m", max_distance_m, 0, 1e6);
  CheckRange("keyframes.max_rotation_deg", max_rotation_deg, 0, 540);
  CheckRange("keyframes.min_measured_depth", min_measured_depth, 0, 1);
  CheckRange("keyframes.metres_per_radian", metres_per_radian, 0, 1e3);
  CheckRange("keyframes.joint", joint, 1, 100);
  CheckRange("keyframes.min_overlap", min_overlap, 0, 1);
  CheckRange("keyframes.stale_share", stale_share, 0, 1);
  CheckRange("keyframes.polish_iterations", polish_iterations, 0, 1000);
}

void TrustOptions::Validate() const {
  CheckRange("trust.max_unexplained_variance", max_unexplained_variance, 0, 1e6);
  CheckRange("trust.max_depth_disagreement", max_depth_disagreement, 0, 1e6);
  CheckRange("trust.min_inlier_ratio", min_inlier_ratio, 0, 1);
  CheckRange("trust.max_uncertainty_rad", max_uncertainty_rad, 0, 1e6);
  CheckRange("trust.doubtful_unexplained_variance", doubtful_unexplained_variance, 0, 1e6);
  CheckRange("trust.doubtful_depth_disagreement", doubtful_depth_disagreement, 0, 1e6);
  CheckRange("trust.doubtful_inlier_ratio", doubtful_inlier_ratio, 0, 1);
  CheckRange("trust.doubtful_overlap", doubtful_overlap, 0, 1);
  CheckRange("trust.doubtful_uncertainty_rad", doubtful_uncertainty_rad, 0, 1e6);
}

void TrackerOptions::Validate() const {
  alignment.Validate();
  keyframes.Validate();
  trust.Validate();
  CheckRange("relocalization_candidates", relocalization_candidates, 0, 1000);
}

TrackerOptions PaperPreset() {
  TrackerOptions options;
  options.alignment.covariance_factor = 3.1;
  return options;
}

TrackerOptions PaperAllPixelsPreset() {
  TrackerOptions options = PaperPreset();
  options.alignment.exclude_hidden = false;
  return options;
}

TrackerOptions AccuratePreset() {
  TrackerOptions options;
  options.alignment.max_iterations = {6, 6, 15, 20};
  options.alignment.use_current_depth = true;
  options.alignment.depth_edge_margin_px = 1;
  options.alignment.robust_scale = 2;
  options.alignment.robust_gradient = 8.0 / 255;
  options.alignment.depth_residual = true;
  options.alignment.depth_patch_px = 6;
  options.alignment.max_disagreement = 60;
  options.alignment.registered_contrast = 1.4;
  options.alignment.covariance_factor = 2;
  options.alignment.min_update_norm = 2e-6;
  options.alignment.coarser_update_norm = 4;
  options.alignment.take_last_step = true;
  options.alignment.scaled_damping = true;
  options.keyframes.max_distance_m = 0.2;
  options.keyframes.max_rotation_deg = 540;
  options.keyframes.metres_per_radian = 0.3;
  options.keyframes.joint = 3;
  options.keyframes.trusted_only = true;
  options.keyframes.min_overlap = 0.6;
  options.keyframes.stale_share = 0.3;
  options.alignment.min_overlap = 0.25;
  options.trust.max_unexplained_variance = 0.25;
  options.trust.min_inlier_ratio = 0.5;
  options.trust.max_uncertainty_rad = 0.03;
  options.trust.doubtful_unexplained_variance = 0.13;
  options.relocalization_candidates = 5;
  options.always_initialize = false;
  options.start = Start::kConstantVelocity;
  return options;
}

TrackerOptions FastPreset() {
  TrackerOptions options = AccuratePreset();
  options.alignment.max_iterations = {0, 5, 10, 20};
  options.alignment.robust_scale = 2.5;
  options.alignment.min_update_norm = 5e-5;
  options.alignment.scale_rounds = 2;
  options.alignment.covariance_factor = 2.3;
  options.keyframes.joint = 1;
  options.keyframes.polish_iterations = 4;
  return options;
}

}  // namespace silt::tracker
