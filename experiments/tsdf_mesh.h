// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/io/ply_file.h"
#include "silt/tracker/keyframe.h"

namespace silt::experiments {

// The surface in the keyframes' depths: truncated signed distances, averaged in the voxels of a
// grid by Open3D, and their zero as coloured triangles, in the world. Pixels beside depth edges are
// left out. Nothing where this build or this machine has no Open3D.
std::optional<PlyModel> TsdfMesh(const std::vector<tracker::Keyframe>& keyframes,
                                 const PinholeCamera& camera, double voxel_m);

}  // namespace silt::experiments
