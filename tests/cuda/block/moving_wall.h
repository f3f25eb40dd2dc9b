// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/frame.h"
#include "wavy_wall.h"

// A tracker's frames of the wall without a board, 5 cm and 1° apart.
namespace silt::cuda {

inline SE3d WallPose(int index) {
  const double s = index;
  return SE3d::Exp({{0.004 * s, 0.017 * s, 0}, {0.05 * s, 0.004 * s, 0.005 * s}});
}

inline Frame WallFrame(int index) {
  Pictures pictures = Scene(WallPose(index).Inverse(), false);
  Frame frame{0.1 * index, Image<Rgb8>(kCamera.width, kCamera.height), {}};
  for (std::size_t i = 0; i < pictures.intensity.size(); ++i) {
    const float value = 255 * pictures.intensity.data()[i];
    const auto level = std::uint8_t(value + 0.5f);
    frame.rgb.data()[i] = {level, level, level};
  }
  frame.depth_m = pictures.depth_m;
  return frame;
}

}  // namespace silt::cuda
