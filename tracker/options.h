// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/tracker/robust_loss.h"

namespace silt::tracker {

// How an intensity between pixels is found: of four pixels, or, not the paper's, of sixteen.
enum class Interpolant { kBilinear, kCatmullRom, kBSpline };

// What is made of an image before it is aligned.
struct PyramidOptions {
  int levels = 4;
  int depth_edge_margin_px = 0;  // pixels nearer to a depth edge at the finest level are left out
  bool inverse_depth = false;    // is compared too
  int finest = 0;  // levels above this one, counted from 0, serve only to be halved: a backend may
                   // keep nothing of them
  Interpolant interpolant = Interpolant::kBilinear;
};

// Algorithm 1. Every Validate() throws silt::Error naming the option, its value and its range.
struct AlignmentOptions {
  // Solves per pyramid level at most, rejected ones included, from the finest level (the paper's
  // level 1) to the coarsest. One entry: no pyramid. 0: the level is skipped.
  std::vector<int> max_iterations = {2, 5, 20, 20};
  double initial_damping = 1e-3;  // α at the start of each level
  double damping_factor = 10;     // α is divided by it after a success, multiplied after a failure
  double min_update_norm = 1e-6;  // ε: a smaller |dξ| (radians and metres) ends the level
  // Not the paper's: ε grows by this factor from each level to the next coarser one; the step that
  // is smaller is taken too, untested; α is Marquardt's, in units of the diagonal of JᵀJ.
  double coarser_update_norm = 1;
  bool take_last_step = false;
  bool scaled_damping = false;
  double min_overlap = 0.1;  // of the measured pixels; a pose that shows fewer has no cost
  // Leaves out the pixels whose points the current camera cannot see because others, nearer, lie in
  // front of them, as far as the keyframe's depth tells. The paper does not say over which pixels
  // eq. 8 runs; over a hidden one, I_c(W) shows another surface.
  bool exclude_hidden = true;
  // The rest is not the paper's. Where the current image has a depth too, that tells what is
  // hidden, and the edges of both depths are left out.
  bool use_current_depth = false;
  int depth_edge_margin_px = 0;
  // The norm of kernel/robust_norm.h: c in multiples of the residuals' own scale, which is
  // estimated at each level, and g in intensity per pixel. 0: squares. Each trial pose is then
  // linearized at once.
  RobustLoss robust_loss = RobustLoss::kGemanMcClure;
  double robust_scale = 0;
  double robust_gradient = 0;
  int scale_rounds = 4;  // estimates of the scales at most, where a coarser level has left some
  // Residuals of the inverse depth beside those of the intensity, each kind in units of its own
  // scale; needs robust_scale and use_current_depth.
  bool depth_residual = false;
  Interpolant interpolant = Interpolant::kBilinear;  // of the current intensity
  // Jacobians of the intensity take this share of the gradient from the keyframe's pixel and the
  // rest from the current image: 0 is the forward compositional step, ½ about that of ESM, and 1
  // about that of the inverse compositional one.
  double reference_gradient = 0;
  // Compares each keyframe's intensity with a gain and an offset of its own, which are found on the
  // way, in closed form at each pose; needs robust_scale.
  bool affine_brightness = false;
  double depth_patch_px = 1;  // at the finest level: noise of depths is alike over so many a side
  // Intensities lose weight where they contradict the depths by more than this χ² of six
  // parameters, see ResidualAgreement: colours that are not registered to depths have nothing wrong
  // that their noise would tell. 0: they keep it, as they have to where depths alone would slip.
  double max_disagreement = 0;
  // That is looked at for keyframes alone whose edge_contrast (see ImageContent) is below this, a
  // sign that colours are not registered to depths. 0: for all.
  double registered_contrast = 0;
  bool rotation_only = false;  // the translation stays as it is
  // By which the covariance is larger than the residuals tell: both images are sampled and their
  // depth is interpolated, which moves a pose without leaving residuals. Measured, not derived:
  // with the presets', ξᵀC⁻¹ξ is 6 in the mean over noisy pairs of both paths of the office.
  double covariance_factor = 1;
  bool keep_log = false;  // one AlignmentStep per solve

  int levels() const { return int(max_iterations.size()); }
  bool robust() const { return robust_scale > 0; }
  // Whether max_disagreement is looked at with a keyframe of this edge_contrast, 0: not known.
  bool DoubtsColours(double edge_contrast) const;
  PyramidOptions Pyramids() const;
  void Validate() const;
};

// §3.1.
struct KeyframeOptions {
  double max_distance_m = 0.13;     // from every keyframe; beyond it: a new one
  double max_rotation_deg = 30;     // |rx| + |ry| + |rz| since the last created keyframe
  double min_measured_depth = 0.1;  // of the pixels; a frame with less cannot be a keyframe
  // Not the paper's: a turn counts as so much of a displacement where distances are compared, and a
  // frame is aligned with so many of the nearest keyframes at once, but for those of which it
  // shows less than alignment.min_overlap.
  double metres_per_radian = 0;
  int joint = 1;
  bool trusted_only = false;  // no keyframe is made of a doubtful frame
  // A new one also where the camera sees less than this of each of those nearest keyframes, as a
  // turn on the spot leads to. 0: never for that.
  double min_overlap = 0;
  // A new one also where residuals leave more than this share of what makes a pose doubtful, and
  // more than twice what they left at best with the same keyframe: as light or viewpoint change, it
  // goes stale, and of doubtful frames none can be made. 0: never for that.
  double stale_share = 0;
  // What becomes a keyframe is first aligned again with the one that it was tracked from, at full
  // resolution with so many solves at most: its error would stay. 0: it is not.
  int polish_iterations = 0;

  void Validate() const;
};

// What an alignment must show to be believed, see PoseEvidence.
struct TrustOptions {
  // Lost beyond these. Of the keyframe's variance of intensity, the residuals may keep a share: 0
  // for a perfect match, 2 for two unrelated images.
  double max_unexplained_variance = 0.6;
  double max_depth_disagreement = 0.03;  // of the depths, by the scale of their residuals
  double min_inlier_ratio = 0;
  double max_uncertainty_rad = 1e6;
  // Doubtful beyond these.
  double doubtful_unexplained_variance = 0.4;
  double doubtful_depth_disagreement = 0.02;
  double doubtful_inlier_ratio = 0.8;
  double doubtful_overlap = 0.3;
  double doubtful_uncertainty_rad = 3e-3;

  void Validate() const;
};

// Where an alignment starts if no initializer says so.
enum class Start {
  kKeyframe,          // the pose of the nearest keyframe
  kPrevious,          // that of the last tracked frame
  kConstantVelocity,  // where the motion between the last two tracked frames leads
};

struct TrackerOptions {
  AlignmentOptions alignment;
  KeyframeOptions keyframes;
  TrustOptions trust;
  // The initializer gives every frame its start (§3.2), or serves only to find a lost camera again.
  bool always_initialize = true;
  Start start = Start::kPrevious;
  // Where lost, a frame is compared with so many keyframes, those that look most like it.
  int relocalization_candidates = 0;
  std::uint64_t seed = 0;  // of the initializer's random draws

  void Validate() const;
};

// The paper to the letter; what it leaves open (the interpolant, the domain of eq. 8) is settled in
// the comments of the options and of tracker/kernel.
TrackerOptions PaperPreset();

// Ours: robust alignment with three keyframes at once, clear of depth edges.
TrackerOptions AccuratePreset();
// The same with one keyframe and fewer iterations.
TrackerOptions FastPreset();

// The same as the paper's with eq. 8 over every pixel that lands in the current image, hidden ones
// too.
TrackerOptions PaperAllPixelsPreset();

}  // namespace silt::tracker
