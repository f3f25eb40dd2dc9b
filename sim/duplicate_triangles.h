// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "silt/sim/mesh.h"

namespace silt::sim {

// Removes all but one of the triangles with the same three corners, whichever way they face: models
// for renderers that cull back faces hold every sheet twice, and rays cannot tell the two apart.
// The first stays, but the first that `is_visible` if any is.
void RemoveDuplicateTriangles(Mesh& mesh, const std::function<bool(const Triangle&)>& is_visible);

}  // namespace silt::sim
