// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/pair_alignment.h"

#include "silt/core/color.h"

namespace silt::experiments {

PairAlignment::PairAlignment(const tracker::Backend& backend, const FramePair& pair, int levels)
    : backend_(backend),
      reference_(backend.MakeReference(GrayFromRgb(pair.reference.rgb), pair.reference.depth_m,
                                       pair.camera, {levels})),
      current_(backend.MakeCurrent(GrayFromRgb(pair.current.rgb), {}, {levels})),
      truth_(pair.current_from_reference) {}

PairAlignment::PairAlignment(const tracker::Backend& backend, const FramePair& pair,
                             const tracker::AlignmentOptions& options)
    : backend_(backend),
      reference_(backend.MakeReference(GrayFromRgb(pair.reference.rgb), pair.reference.depth_m,
                                       pair.camera, options.Pyramids())),
      current_(backend.MakeCurrent(
          GrayFromRgb(pair.current.rgb),
          options.use_current_depth ? pair.current.depth_m : Image<float>{}, options.Pyramids())),
      truth_(pair.current_from_reference) {}

tracker::AlignmentResult PairAlignment::Align(const SE3d& start,
                                              const tracker::AlignmentOptions& options) const {
  return tracker::Align(backend_, {*reference_, *current_}, start, options);
}

std::vector<tracker::AlignmentResult> PairAlignment::AlignAll(
    const std::vector<SE3d>& starts, const tracker::AlignmentOptions& options) const {
  std::vector<tracker::AlignmentStart> all;
  for (const SE3d& start : starts) all.push_back({*reference_, *current_, start});
  return tracker::AlignBatch(backend_, all, options);
}

}  // namespace silt::experiments
