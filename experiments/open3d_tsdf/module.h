// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// What the program and the module with Open3D share: plain data and one C function. Open3D brings
// windows and OpenGL, which a program that tracks neither needs nor finds everywhere; so the module
// is loaded (tsdf_mesh.h) only where a mesh is made.
extern "C" {

struct SiltTsdfFrame {
  const std::uint8_t* rgb;       // 8-bit sRGB, row by row without padding
  const float* depth_m;          // 0: no measurement
  double camera_from_world[16];  // row by row
};

struct SiltTsdfInput {
  int width, height;
  double fx, fy, cx, cy;  // fy > 0
  double voxel_m, truncation_m;
  const SiltTsdfFrame* frames;
  int frame_count;
};

// Called for each vertex, then for each triangle.
struct SiltTsdfSink {
  void* mesh;
  void (*add_vertex)(void* mesh, const double point[3], const double color[3]);  // color: 0 to 1
  void (*add_triangle)(void* mesh, const int vertices[3]);
};

// 0 where Open3D has failed, whatever the sink was told by then.
using SiltTsdfFunction = int (*)(const SiltTsdfInput*, const SiltTsdfSink*);
}

inline constexpr const char* kSiltTsdfSymbol = "SiltTsdf";
