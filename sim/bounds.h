// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "silt/core/vector.h"

namespace silt::sim {

// A box along the world's axes. Starts empty; `Add` grows it.
struct Bounds {
  Vec3f low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

  void Add(const Vec3f& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void Add(const Bounds& other) {
    if (other.IsEmpty()) return;
    Add(other.low);
    Add(other.high);
  }
  Bounds Grown(float margin) const {
    const Vec3f m{margin, margin, margin};
    return {low - m, high + m};
  }
  bool Overlaps(const Bounds& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
           low.z <= o.high.z && o.low.z <= high.z;
  }
  bool IsEmpty() const { return !(low.x <= high.x); }
  Vec3f Size() const { return IsEmpty() ? Vec3f{} : high - low; }

  static constexpr float kFar = std::numeric_limits<float>::max();
};

}  // namespace silt::sim
