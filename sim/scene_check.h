// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/sim/scene.h"

namespace silt::sim {

// What is wrong with a scene, or looks like it.
struct SceneFinding {
  bool is_error = false;  // else a warning
  std::string message;    // one line that names the instance or the material
};

// All that can be checked without rendering. Errors: a scene that nothing lights, materials that
// reflect more than they receive, vertices or normals that are not finite, instances without a
// triangle. Warnings: what loading warned of (missing textures); triangles without area; normals on
// the wrong side; surfaces that lie on each other where rays can reach them, so that rounding
// decides which is seen; instances that touch nothing, or lie below the floor (z = 0).
std::vector<SceneFinding> CheckScene(const Scene& scene);

}  // namespace silt::sim
