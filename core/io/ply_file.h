// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt {

// Coloured points, and what joins them, by index: triangles of a mesh, edges of a line drawing.
struct PlyModel {
  std::vector<Vec3f> points;  // metres
  std::vector<Rgb8> colors;   // one for each point
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> edges;
};

// Binary PLY, little endian, as MeshLab, CloudCompare and Open3D read it; written whole or not at
// all. Throws silt::Error.
void WritePly(const std::filesystem::path& file, const PlyModel& model);

}  // namespace silt
