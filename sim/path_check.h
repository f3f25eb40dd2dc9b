// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/sim/camera_path.h"
#include "silt/sim/scene.h"

namespace silt::sim {

struct PathCheckOptions {
  double clearance_m = 0.05;  // from the camera's centre; 0: only crossings are looked for
  double start_s = 0;         // of the stretch that is checked
  double duration_s = 0;      // 0: to the end of the path

  // Throws silt::Error.
  void Validate() const;
};

// A time over which the camera is nearer to an instance than the clearance, or goes through it.
struct PathContact {
  std::string instance;
  double start_s = 0, end_s = 0;
  double nearest_s = 0, distance_m = 0;  // when it is nearest, and how near
  bool crosses = false;                  // it passes through a surface
};

struct PathCheck {
  std::vector<PathContact> contacts;  // in order of their starts
  double step_m = 0;                  // the camera was looked at after every step of this length

  bool Crosses() const;
};

// Looks at the camera's centre at steps of at most an eighth of the clearance (5 mm and 10 ms at
// most), so that distances are true to half a step; crossings are those of the straight lines
// between steps. Cut-outs count as solid.
PathCheck CheckPath(const CameraPath& path, const Scene& scene, const PathCheckOptions& options);

// "at 2.31 s crosses 'cabinet'" or "at 2.31 s (2.10 to 2.50 s) is only 31 mm from 'lamp'".
std::string Describe(const PathContact& contact);

// The instance that a triangle belongs to.
const Instance& InstanceOf(const Scene& scene, std::uint32_t triangle);

}  // namespace silt::sim
