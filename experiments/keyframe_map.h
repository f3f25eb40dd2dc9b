// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/io/ply_file.h"
#include "silt/core/trajectory.h"
#include "silt/experiments/json.h"
#include "silt/tracker/keyframe.h"

// What a tracker has seen, as in the paper's Fig. 7: the depths of its keyframes put together, the
// keyframes' cameras and the path.
namespace silt::experiments {

// The points of all keyframes in the world, one for each occupied voxel: the mean of those in it,
// each weighted by 1/z², as it is measured the better the nearer it is. Pixels beside depth edges
// are left out. The same for any number of threads.
PlyModel FusedCloud(const std::vector<tracker::Keyframe>& keyframes, const PinholeCamera& camera,
                    double voxel_m);

// Lines: a pyramid for each keyframe's camera (blue), which shows what it sees at `depth_m`, and
// the path through all poses (red).
PlyModel CameraLines(const std::vector<tracker::Keyframe>& keyframes, const PinholeCamera& camera,
                     const Trajectory& trajectory, double depth_m = 0.12);

// Everything that is made of a map.
struct MapInput {
  const std::vector<tracker::Keyframe>& keyframes;
  PinholeCamera camera;
  const Trajectory& trajectory;
  double voxel_m = 0.01;
};

// Writes cloud.ply, cameras.ply, path.txt and figures/map.png into the folder, and mesh.ply where
// tsdf_mesh.h can make one, else a warning. Returns what there is.
Json WriteMap(const std::filesystem::path& folder, const MapInput& input);

}  // namespace silt::experiments
