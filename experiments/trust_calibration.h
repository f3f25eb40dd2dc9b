// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/json.h"
#include "silt/experiments/pair_alignment.h"
#include "silt/experiments/pose_difference.h"
#include "silt/experiments/tracker_setup.h"

// Whether a pose's covariance and status say how wrong it is.
namespace silt::experiments {

// Two frames of a path: `jump` where they are any two, else they follow each other closely.
struct TrustPair {
  double reference_s = 0, current_s = 0;
  bool jump = false;
};

// `count` pairs at most half a second apart, spread evenly over the path, and as many jumps.
std::vector<TrustPair> TrustPairs(double path_duration_s, int count, std::uint64_t seed);

// What a tracker whose only keyframe is the pair's first frame says of the second.
struct TrustSample {
  std::string images, preset;  // "sharp", "noisy" or "blurred"
  TrustPair pair;
  tracker::TrackingStatus status = tracker::TrackingStatus::kLost;
  std::string message;
  tracker::PoseEvidence evidence;
  PoseDifference error;          // of the pose, where not lost
  std::optional<double> square;  // ξᵀC⁻¹ξ of the error, where not lost

  // Beyond 5 cm or 2°: no alignment that came to its end is so far off.
  bool wild() const { return !error.Within({0.05, 2}); }
  Json ToJson() const;
};

TrustSample MeasureTrust(const FramePair& frames, const TrackerSetup& setup);

// One preset on one kind of images.
struct TrustSummary {
  std::string images, preset;
  // Frames that follow closely, by status; and of those that are tracked:
  int tracked = 0, doubtful = 0, lost = 0;
  double mean_square = 0;              // ξᵀC⁻¹ξ, the normalized error squared; 6 is right
  double median_square = 0;            // 5.35 is right
  double band_low = 0, band_high = 0;  // in which the mean of 99 % of right covariances lies
  // Jumps, by status, and how many of each status are wild.
  int jumps_tracked = 0, jumps_doubtful = 0, jumps_lost = 0, wild_tracked = 0, wild_doubtful = 0;

  bool calibrated() const { return mean_square >= band_low && mean_square <= band_high; }
  // By which the covariance has to be multiplied for the mean, or the median, to be right.
  double factor() const { return mean_square / 6; }
  double median_factor() const { return median_square / 5.348; }
  Json ToJson() const;
};

// In the order of their first sample.
std::vector<TrustSummary> SummarizeTrust(const std::vector<TrustSample>& samples);
std::string FormatTrust(const std::vector<TrustSummary>& summaries);

// Bounds of the mean of `count` values of χ² with 6 degrees of freedom, within which it lies with a
// probability of 99 %.
struct Band {
  double low = 0, high = 0;
};
Band MeanChiSquare6Band(int count);

}  // namespace silt::experiments
