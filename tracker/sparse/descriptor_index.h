// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "silt/tracker/sparse/feature.h"
#include "silt/tracker/sparse/feature_match.h"

namespace silt::tracker {

// A keyframe's descriptors, to be looked up: by FLANN's randomised k-d trees where they are
// numbers, one by one where they are bits. The trees depend on the descriptors and the seed alone,
// not on what the thread drew before, and leave the thread's generator as it was.
class DescriptorIndex {
 public:
  DescriptorIndex(const std::vector<Feature>& keyframe, std::uint64_t seed);
  ~DescriptorIndex();
  DescriptorIndex(DescriptorIndex&&) noexcept;
  DescriptorIndex& operator=(DescriptorIndex&&) noexcept;

  // The (approximately) nearest keyframe descriptor of each current one. Where several current
  // features choose the same keyframe feature, the nearest of them keeps it. In order of `current`.
  std::vector<FeatureMatch> Match(const std::vector<Feature>& current) const;

 private:
  struct Descriptors;
  std::unique_ptr<Descriptors> descriptors_;
};

}  // namespace silt::tracker
