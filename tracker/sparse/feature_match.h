// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// Two features taken for the same point of the scene, by their indices in the two images' lists.
struct FeatureMatch {
  int keyframe = 0;
  int current = 0;
  float distance = 0;  // Euclidean, between the descriptors; in [0, 2]

  bool operator==(const FeatureMatch&) const = default;
};

}  // namespace silt::tracker
