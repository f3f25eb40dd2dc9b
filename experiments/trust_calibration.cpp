// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/trust_calibration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/experiments/statistics.h"

namespace silt::experiments {
namespace {

using tracker::TrackingStatus;

constexpr double kLongestGap_s = 0.5;

// NaN, which JSON writes as null, where there is none.
double OrNan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

void CountStatus(TrackingStatus status, int* tracked, int* doubtful, int* lost) {
  ++*(status == TrackingStatus::kTracked    ? tracked
      : status == TrackingStatus::kDoubtful ? doubtful
                                            : lost);
}

TrustSummary Summarized(const std::vector<const TrustSample*>& samples) {
  TrustSummary s{samples.front()->images, samples.front()->preset};
  std::vector<double> squares;
  for (const TrustSample* sample : samples) {
    const bool tracked = sample->status == TrackingStatus::kTracked;
    if (sample->pair.jump) {
      CountStatus(sample->status, &s.jumps_tracked, &s.jumps_doubtful, &s.jumps_lost);
    } else {
      CountStatus(sample->status, &s.tracked, &s.doubtful, &s.lost);
      if (tracked) squares.push_back(sample->square.value_or(HUGE_VAL));
    }
    if (sample->status == TrackingStatus::kLost || !sample->wild()) continue;
    ++(tracked ? s.wild_tracked : s.wild_doubtful);
  }
  if (squares.empty()) return s;
  for (const double square : squares) s.mean_square += square / double(squares.size());
  s.median_square = Median(squares);
  const Band band = MeanChiSquare6Band(int(squares.size()));
  s.band_low = band.low;
  s.band_high = band.high;
  return s;
}

}  // namespace

std::vector<TrustPair> TrustPairs(double path_duration_s, int count, std::uint64_t seed) {
  if (!(path_duration_s > 2 * kLongestGap_s)) {
    throw Error("trust: the path must last more than 1 s");
  }
  const CounterRandom random(seed, 0x7457);
  std::vector<TrustPair> pairs;
  for (int i = 0; i < count; ++i) {
    const double start_s = (i + 0.5) / count * (path_duration_s - kLongestGap_s);
    const double gap_s = kLongestGap_s * (0.05 + 0.95 * random.Uniform(2 * std::uint64_t(i)));
    pairs.push_back({start_s, start_s + gap_s, false});
    const double other_s = path_duration_s * random.Uniform(2 * std::uint64_t(i) + 1);
    pairs.push_back({start_s, other_s, true});
  }
  return pairs;
}

TrustSample MeasureTrust(const FramePair& frames, const TrackerSetup& setup) {
  TrustSample sample;
  sample.preset = setup.preset;
  tracker::KeyframeTracker tracker = MakeTracker(frames.camera, setup, SE3d{});
  tracker.Track(frames.reference);
  const tracker::TrackedFrame tracked = tracker.Track(frames.current);
  sample.status = tracked.status;
  sample.message = tracked.message;
  sample.evidence = tracked.evidence;
  if (tracked.status == TrackingStatus::kLost) return sample;
  const SE3d error = tracked.world_from_camera.Inverse() * frames.current_from_reference.Inverse();
  sample.error = Difference(frames.current_from_reference, tracked.world_from_camera.Inverse());
  sample.square = tracker::NormalizedSquare(error.Log(), tracked.covariance);
  return sample;
}

std::vector<TrustSummary> SummarizeTrust(const std::vector<TrustSample>& samples) {
  std::vector<std::vector<const TrustSample*>> groups;
  for (const TrustSample& sample : samples) {
    const auto same = [&](const auto& group) {
      return group.front()->images == sample.images && group.front()->preset == sample.preset;
    };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) {
      groups.push_back({&sample});
    } else {
      group->push_back(&sample);
    }
  }
  std::vector<TrustSummary> summaries;
  for (const auto& group : groups) summaries.push_back(Summarized(group));
  return summaries;
}

Band MeanChiSquare6Band(int count) {
  // Wilson and Hilferty: (χ²/k)^⅓ is normal with mean 1 − 2/(9k) and variance 2/(9k).
  const double spread = 2 / (9 * 6.0 * count), quantile = 2.5758;
  const auto at = [&](double z) { return 6 * std::pow(1 - spread + z * std::sqrt(spread), 3); };
  return {at(-quantile), at(quantile)};
}

Json TrustSample::ToJson() const {
  return {{"images", images},
          {"preset", preset},
          {"reference_s", pair.reference_s},
          {"current_s", pair.current_s},
          {"jump", pair.jump},
          {"status", tracker::Name(status)},
          {"distance_m", error.distance_m},
          {"angle_deg", error.angle_deg},
          {"normalized_square", OrNan(square)},
          {"overlap", evidence.overlap},
          {"unexplained_variance", evidence.unexplained_variance},
          {"depth_disagreement", evidence.depth_disagreement},
          {"inlier_ratio", evidence.inlier_ratio},
          {"uncertainty_rad", evidence.uncertainty_rad},
          {"message", message}};
}

Json TrustSummary::ToJson() const {
  return {{"images", images},
          {"preset", preset},
          {"tracked", tracked},
          {"doubtful", doubtful},
          {"lost", lost},
          {"mean_normalized_square", mean_square},
          {"band_low", band_low},
          {"band_high", band_high},
          {"within_band", calibrated()},
          {"covariance_factor", factor()},
          {"median_normalized_square", median_square},
          {"median_factor", median_factor()},
          {"jumps_tracked", jumps_tracked},
          {"jumps_doubtful", jumps_doubtful},
          {"jumps_lost", jumps_lost},
          {"wild_tracked", wild_tracked},
          {"wild_doubtful", wild_doubtful}};
}

std::string FormatTrust(const std::vector<TrustSummary>& summaries) {
  std::string text =
      "images   preset            tracked doubtful lost | mean NEES   99 % band        factor  (of "
      "medians) | jumps: tracked doubtful lost, wild tracked doubtful\n";
  char line[240];
  for (const TrustSummary& s : summaries) {
    std::snprintf(
        line, sizeof line,
        "%-8s %-17s %7d %8d %4d | %9.3g  %5.2f to %5.2f %-3s %7.3g %13.3g | %14d %8d %4d %13d "
        "%8d\n",
        s.images.c_str(), s.preset.c_str(), s.tracked, s.doubtful, s.lost, s.mean_square,
        s.band_low, s.band_high, s.calibrated() ? "in" : "out", s.factor(), s.median_factor(),
        s.jumps_tracked, s.jumps_doubtful, s.jumps_lost, s.wild_tracked, s.wild_doubtful);
    text += line;
  }
  return text;
}

}  // namespace silt::experiments
