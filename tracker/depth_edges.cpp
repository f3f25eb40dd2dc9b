// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/depth_edges.h"

#include "silt/tracker/cpu_preparation.h"

namespace silt::tracker {

Image<float> WithoutDepthEdges(const Image<float>& depth_m, int margin_px) {
  if (margin_px <= 0 || depth_m.empty()) return depth_m;
  CpuPreparation::Wanted wanted;
  wanted.depth = true;
  return *CpuPreparation(BestSimdLevel())
              .AwayFromEdges({{&depth_m, nullptr, margin_px}}, wanted)
              .front()
              .depth_m;
}

}  // namespace silt::tracker
