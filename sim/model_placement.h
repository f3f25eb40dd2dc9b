// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/mesh.h"
#include "silt/sim/model_import.h"

namespace silt::sim {

// Where a model goes: turned z-up, scaled, mirrored, turned about z, moved.
struct ModelPlacement {
  Mat3d rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // in the model's own axes, before all else
  bool z_up = false;                                  // false: the model's y points up
  std::optional<Vec3d> size;  // in metres: the bounding box becomes exactly this, flat sides apart
  double scale = 1;           // metres per unit, where there is no size
  bool mirror = false;        // in x
  double yaw_rad = 0;         // counter-clockwise from above
  Vec3d at;                   // world, of the centre of the bounding box's bottom face
};

// What becomes of one material of a model.
struct MaterialUse {
  std::uint32_t material = 0;   // of the scene
  bool dropped = false;         // its triangles are left out, though the bounding box has them
  std::optional<Vec2f> tile_m;  // pictures are projected along x, y or z, whichever a face looks to
};

// `uses` is indexed by the model's materials.
void AppendModel(Mesh& mesh, const Model& model, const ModelPlacement& placement,
                 const std::vector<MaterialUse>& uses);

}  // namespace silt::sim
