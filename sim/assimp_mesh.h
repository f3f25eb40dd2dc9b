// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/mesh.h"

struct aiScene;

namespace silt::sim {

// Appends every mesh of every node, in the root's coordinates; material indices are assimp's.
// Triangles without area, or with a corner that is not finite, are left out. Each triangle is wound
// such that its front is the side its vertex normals point to.
void AppendMeshes(Mesh& mesh, const aiScene& scene);

}  // namespace silt::sim
