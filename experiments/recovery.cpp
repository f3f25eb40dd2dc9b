// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/recovery.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/formatted.h"
#include "silt/core/pyramid.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/statistics.h"
#include "silt/experiments/tracker_options.h"
#include "silt/tracker/coarse_initializer.h"

namespace silt::experiments {
namespace {

// Solves of the finest level alone, enough to come to rest.
constexpr int kSingleLevelSolves = 100;
// How long such an alignment takes, in those of a whole pyramid, for the time left.
constexpr double kSingleLevelWork = 5;

struct Scheme {
  std::string preset, name;
  int starts = 0;
  tracker::AlignmentOptions alignment = {};

  double Work() const { return starts * (name == kSingleLevelScheme ? kSingleLevelWork : 1); }
};

std::vector<Scheme> Schemes(const RecoveryOptions& options) {
  std::vector<Scheme> schemes;
  for (const std::string& preset : options.presets) {
    const tracker::TrackerOptions tracker = PresetOptions(preset);
    const bool wide = !tracker.always_initialize;
    if (wide) schemes.push_back({preset, kWideScheme, options.starts, tracker.alignment});
    schemes.push_back(
        {preset, kPyramidScheme, wide ? options.comparison : options.starts, tracker.alignment});
    schemes.push_back({preset, kSingleLevelScheme, options.comparison, tracker.alignment});
    schemes.back().alignment.max_iterations = {kSingleLevelSolves};
  }
  std::erase_if(schemes, [](const Scheme& scheme) { return scheme.starts == 0; });
  return schemes;
}

// The pairs made ready for a scheme.
class ReadyPairs {
 public:
  ReadyPairs(const std::vector<FramePair>& pairs, const tracker::Backend& backend,
             const Scheme& scheme)
      : pairs_(pairs),
        backend_(backend),
        scheme_(scheme),
        wide_({std::shared_ptr<void>(), &backend}, tracker::WideStart()) {
    for (const FramePair& pair : pairs) {
      alignments_.emplace_back(backend, pair, scheme.alignment);
      tracker::Keyframe keyframe;
      keyframe.frame = pair.reference;
      keyframe.intensity = GrayFromRgb(pair.reference.rgb);
      keyframes_.push_back(std::move(keyframe));
      currents_.push_back(GrayFromRgb(pair.current.rgb));
    }
  }

  SuccessRate Measure(const RandomStarts& starts) {
    std::vector<SE3d> truths;
    for (const PairAlignment& pair : alignments_) truths.push_back(pair.truth());
    const AlignAllFrom all = [&](std::size_t pair, const std::vector<SE3d>& poses) {
      return alignments_[pair].AlignAll(Widened(pair, poses), scheme_.alignment);
    };
    return MeasureSuccessRate(truths, starts, all);
  }

 private:
  // Where the wide start leads from each of them, all at once.
  std::vector<SE3d> Widened(std::size_t pair, std::vector<SE3d> poses) const {
    if (scheme_.name != kWideScheme) return poses;
    const FramePair& frames = pairs_[pair];
    const tracker::HeldImages held{backend_, alignments_[pair].images()};
    const auto found = wide_.FindFrom(
        {keyframes_[pair], frames.current, currents_[pair], frames.camera, 0, 0, {}, held}, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i] = found[i].value_or(poses[i]);
    return poses;
  }

  const std::vector<FramePair>& pairs_;
  const tracker::Backend& backend_;
  const Scheme& scheme_;
  tracker::CoarseInitializer wide_;
  std::vector<PairAlignment> alignments_;
  std::vector<tracker::Keyframe> keyframes_;
  std::vector<Image<float>> currents_;
};

Statistics DepthsOf(const FramePair& pair) {
  std::vector<double> depths;
  for (const float z : pair.reference.depth_m) {
    if (IsMeasured(z)) depths.push_back(double(z));
  }
  return depths.empty() ? Statistics{} : Summarize(std::move(depths));
}

}  // namespace

std::string RecoverySet::Name() const {
  return Formatted("%s %.0f cm and %.0f deg", up_to ? "up to" : "at", 100 * bound.distance_m,
                   bound.angle_deg);
}

std::vector<Recovery> MeasureRecovery(const std::vector<FramePair>& pairs,
                                      const tracker::Backend& backend,
                                      const RecoveryOptions& options) {
  const std::vector<Scheme> schemes = Schemes(options);
  double total = 0;
  for (const Scheme& scheme : schemes) total += scheme.Work();
  Progress progress(total * double(std::size(kRecoverySets)));
  std::vector<Recovery> recoveries;
  for (const Scheme& scheme : schemes) {
    ReadyPairs ready(pairs, backend, scheme);
    const int count = std::max(1, scheme.starts / int(pairs.size()));
    for (const RecoverySet& set : kRecoverySets) {
      ThrowIfInterrupted();
      recoveries.push_back({scheme.preset, scheme.name, set,
                            ready.Measure({set.bound, count, options.seed, set.up_to})});
      progress.Advance(scheme.Work(), scheme.preset + " from " + set.Name());
    }
  }
  return recoveries;
}

Json RecoveryRows(const std::vector<Recovery>& recoveries) {
  Json rows = Json::array();
  for (const Recovery& recovery : recoveries) {
    Json row{{"preset", recovery.preset},
             {"scheme", recovery.scheme},
             {"set", recovery.set.Name()},
             {"distance_m", recovery.set.bound.distance_m},
             {"angle_deg", recovery.set.bound.angle_deg},
             {"up_to", recovery.set.up_to},
             {"aim", recovery.set.aim}};
    row.update(ToJson(recovery.success));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json PairRows(const std::vector<FramePair>& pairs) {
  Json rows = Json::array();
  for (const FramePair& pair : pairs) {
    const Statistics depth = DepthsOf(pair);
    const PoseDifference motion = Difference(pair.current_from_reference, SE3d{});
    rows.push_back({{"reference_time_s", pair.reference.time_s},
                    {"current_time_s", pair.current.time_s},
                    {"motion_m", motion.distance_m},
                    {"motion_deg", motion.angle_deg},
                    {"min_depth_m", depth.min},
                    {"median_depth_m", depth.median},
                    {"max_depth_m", depth.max}});
  }
  return rows;
}

std::string FormatRecovery(const std::vector<Recovery>& recoveries,
                           const std::vector<FramePair>& pairs) {
  std::string text =
      "Refinement alone, without features, from random starts between frames with these depths:\n";
  text += "  reference s  motion cm, deg  depth m: min, median, max\n";
  for (const FramePair& pair : pairs) {
    const Statistics depth = DepthsOf(pair);
    const PoseDifference motion = Difference(pair.current_from_reference, SE3d{});
    text +=
        Formatted("  %11.2f  %8.2f %6.2f  %12.3f %7.3f %7.3f\n", pair.reference.time_s,
                  100 * motion.distance_m, motion.angle_deg, depth.min, depth.median, depth.max);
  }
  text += Formatted("Recovered to %.0f mm and %.1f deg (95 %% interval):\n",
                    1e3 * kRecovered.distance_m, kRecovered.angle_deg);
  for (const Recovery& recovery : recoveries) {
    const SuccessRate& s = recovery.success;
    const Interval interval = WilsonInterval(s.recovered, s.starts);
    text +=
        Formatted("  %-9s %-12s %-22s %5d of %-5d %5.1f %% (%.1f to %.1f)\n",
                  recovery.preset.c_str(), recovery.scheme.c_str(), recovery.set.Name().c_str(),
                  s.recovered, s.starts, 100 * s.rate(), 100 * interval.low, 100 * interval.high);
  }
  return text;
}

}  // namespace silt::experiments
