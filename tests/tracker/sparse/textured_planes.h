// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/keyframe.h"

// An analytic scene: a textured wall at z = 2 m and, before its left part, a slanted board at about
// 1.2 m. What a camera sees of it is computed ray by ray, without interpolation.
namespace silt::tracker {

struct View {
  Image<float> intensity;  // in [0, 1]
  Image<float> depth_m;
};

View ViewOfPlanes(const PinholeCamera& camera, const SE3d& world_from_camera);

// The view as a keyframe.
Keyframe KeyframeOf(const View& view, int id = 0);

// A smooth random pattern in [0, 1] with structure at 12, 5 and 2 cm, as the planes wear it.
double Texture(double x_m, double y_m, std::uint64_t seed);

}  // namespace silt::tracker
