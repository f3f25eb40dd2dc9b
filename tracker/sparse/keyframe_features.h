// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/vector.h"
#include "silt/tracker/keyframe.h"
#include "silt/tracker/sparse/descriptor_index.h"
#include "silt/tracker/sparse/feature.h"

namespace silt::tracker {

// What §3.2 needs of a keyframe, computed once.
struct KeyframeFeatures {
  KeyframeFeatures(const Keyframe& keyframe, const PinholeCamera& camera,
                   const FeatureOptions& options, std::uint64_t seed);

  int keyframe_id;
  std::vector<Feature> features;
  std::vector<std::optional<Vec3d>> points;  // χ_r of each, in keyframe coordinates, where measured
  DescriptorIndex index;
};

// The features of the keyframes used last; about half a megabyte each.
class KeyframeFeatureCache {
 public:
  explicit KeyframeFeatureCache(int capacity);

  // Computed where they are not there. Valid until the next call.
  const KeyframeFeatures& Get(const Keyframe& keyframe, const PinholeCamera& camera,
                              const FeatureOptions& options, std::uint64_t seed);
  int size() const { return int(entries_.size()); }

 private:
  std::size_t capacity_;
  std::list<KeyframeFeatures> entries_;  // the last used first
};

}  // namespace silt::tracker
