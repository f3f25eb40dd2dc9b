// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/keyframe_features.h"

#include <algorithm>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/tracker/sparse/feature_point.h"

namespace silt::tracker {

KeyframeFeatures::KeyframeFeatures(const Keyframe& keyframe, const PinholeCamera& camera,
                                   const FeatureOptions& options, std::uint64_t seed)
    : keyframe_id(keyframe.id),
      features(DetectFeatures(keyframe.intensity, options)),
      // FLANN's draws are a function of the seed and the keyframe, not of the order of calls.
      index(features, CounterRandom(seed, std::uint64_t(keyframe.id)).Bits(0)) {
  points.reserve(features.size());
  for (const Feature& feature : features) {
    points.push_back(FeaturePoint(keyframe.frame.depth_m, camera, feature.pixel));
  }
}

KeyframeFeatureCache::KeyframeFeatureCache(int capacity) : capacity_(std::size_t(capacity)) {
  SILT_CHECK(capacity >= 1);
}

const KeyframeFeatures& KeyframeFeatureCache::Get(const Keyframe& keyframe,
                                                  const PinholeCamera& camera,
                                                  const FeatureOptions& options,
                                                  std::uint64_t seed) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
    return entry.keyframe_id == keyframe.id;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.emplace_front(keyframe, camera, options, seed);
    if (entries_.size() > capacity_) entries_.pop_back();
  }
  return entries_.front();
}

}  // namespace silt::tracker
