// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "silt/core/camera.h"
#include "silt/core/image.h"

namespace silt::tracker {

// The point of the scene at a sub-pixel place, in camera coordinates: the inverse depths of the
// four pixels around it are interpolated bilinearly, which is exact on a plane. Nothing where one
// of the four is not measured or where they differ by more than `same_surface` (relative): a
// feature on the edge between two surfaces belongs to neither for sure.
std::optional<Vec3d> FeaturePoint(const Image<float>& depth_m, const PinholeCamera& camera,
                                  const Vec2d& pixel, double same_surface = 0.05);

}  // namespace silt::tracker
