// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/se3.h"

// POV-Ray's axes, as ICL-NUIM publishes poses in, are left-handed: world y up; camera x right, y
// up, z forward; hence its fy = −480. silt's are right-handed: world z up; camera y down, fy > 0.
// With S, which exchanges y and z, and D = diag(1, −1, 1):
//   R_pov = S·R·D,   p_pov = S·p.
// The rows of an image run downwards in both: the pictures are the same.
namespace silt {

// world_from_camera in ICL-NUIM's axes from that in silt's, and back.
SE3d IclFromSilt(const SE3d& world_from_camera);
SE3d SiltFromIcl(const SE3d& world_from_camera);

// What a camera file of ICL-NUIM (scene_00_0000.txt) tells.
struct IclCamera {
  SE3d world_from_camera;  // in silt's axes, metres
  // Width and height of the image at distance 1: the image's width/fx and height/fy. The file has
  // them as |cam_right|/|cam_dir| and |cam_up|/|cam_dir|.
  double width = 640 / 481.2, height = 1;
};

std::string FormatIclCamera(const IclCamera& camera);
// `name` stands for the file in errors. Throws silt::Error.
IclCamera ParseIclCamera(const std::string& text, const std::string& name);

}  // namespace silt
