// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/environment.h"
#include "silt/sim/material.h"
#include "silt/sim/mesh.h"
#include "silt/sim/texture.h"

namespace silt::sim {

// A rectangle center ± half_u ± half_v that emits to the side half_u × half_v points to. It is part
// of the mesh as well (two triangles of a one-sided material with emission = radiance), so that it
// is seen: a shadow ray towards it ends just before it.
struct RectLight {
  Vec3f center, half_u, half_v;  // world, metres
  Vec3f radiance;                // linear
};

// One object of the scene file: a run of triangles in the mesh.
struct Instance {
  std::string name;
  std::uint32_t first_triangle = 0, triangle_count = 0;
};

// World frame: metres, z up, floor at z = 0.
struct Scene {
  std::string name;
  Mesh mesh;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<RectLight> lights;
  Vec3f ambient;  // linear radiance that arrives from directions that nothing occludes,
  std::shared_ptr<const Environment> environment;  // unless there is this
  double exposure = 1.0;                           // linear radiance × exposure → [0, 1]
  std::vector<Instance> instances;
  std::vector<std::string> warnings;  // one line each: what third-party models lack

  // What a ray brings that meets nothing.
  Vec3f Background(const Vec3f& direction) const {
    return environment ? environment->Radiance(direction) : ambient;
  }
};

// Reads a scene file (its format: scene_file.h) and everything that it names. The result does not
// depend on the number of threads. Throws silt::Error "file:line: what is wrong and the mend".
Scene LoadScene(const std::filesystem::path& file);

}  // namespace silt::sim
