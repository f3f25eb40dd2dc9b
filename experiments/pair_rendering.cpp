// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/pair_rendering.h"

#include "silt/core/error.h"

namespace silt::experiments {

FramePair RenderPair(const World& world, const sim::RenderOptions& options, double reference_s,
                     double current_s) {
  for (const double time_s : {reference_s, current_s}) {
    if (time_s >= 0 && time_s <= world.path.duration_s()) continue;
    throw Error(world.path_file.string() + ": has no frame at " + std::to_string(time_s) +
                " s; it lasts " + std::to_string(world.path.duration_s()) + " s");
  }
  const SE3d current_from_world = world.path.WorldFromCamera(current_s).Inverse();
  return {options.camera, RenderAt(world, options, reference_s),
          RenderAt(world, options, current_s),
          current_from_world * world.path.WorldFromCamera(reference_s)};
}

}  // namespace silt::experiments
