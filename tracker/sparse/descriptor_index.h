// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "silt/tracker/sparse/feature_match.h"
#include "silt/tracker/sparse/surf.h"

namespace silt::tracker {

// FLANN's randomised k-d trees over a keyframe's descriptors. The trees depend on the descriptors
// and the seed alone, not on what the thread drew before, and leave the thread's generator as it
// was.
class DescriptorIndex {
 public:
  DescriptorIndex(const std::vector<SurfFeature>& keyframe, std::uint64_t seed);
  ~DescriptorIndex();
  DescriptorIndex(DescriptorIndex&&) noexcept;
  DescriptorIndex& operator=(DescriptorIndex&&) noexcept;

  // The (approximately) nearest keyframe descriptor of each current one. Where several current
  // features choose the same keyframe feature, the nearest of them keeps it. In order of `current`.
  std::vector<FeatureMatch> Match(const std::vector<SurfFeature>& current) const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace silt::tracker
