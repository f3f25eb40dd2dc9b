// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/lens.h"
#include "silt/core/se3.h"
#include "silt/sim/exposure_rays.h"
#include "silt/sim/lens_map.h"
#include "silt/sim/ray_tracer.h"

namespace silt::sim {

// What becomes of a pixel's point in the other picture.
enum class FlowState : std::uint8_t {
  kSeen = 0,       // it is seen there
  kOutside = 85,   // beyond the border; behind the camera or a lens's domain, without flow
  kHidden = 170,   // something else lies more than kHiddenBy_m in front of it
  kNothing = 255,  // the pixel sees nothing
};

inline constexpr float kHiddenBy_m = 1e-3f;
// Marks pixels without flow, as in Middlebury's .flo files.
inline constexpr float kNoFlow = 1e10f;

struct FlowField {
  Image<Vec2f> flow_px;       // from a pixel's centre to where its point is in the other picture
  Image<std::uint8_t> state;  // FlowState
};

// The poses (world_from_camera) of a picture's rows in the middle of their exposures: one for all,
// or, behind a rolling shutter, one for each row.
using RowPoses = std::vector<SE3d>;
RowPoses PosesOfRows(const Shutter& shutter, int height, const PoseAtTime& world_from_camera,
                     double time_s);

// Optical flow of a scene at rest, from one picture of a camera to another: the point at the centre
// of each pixel, of the given depth along z (0: none), is projected by the other pose, in double; a
// ray from the other camera to the point tells whether it is hidden. Behind a rolling shutter the
// other pose is that of the very row in which the point is seen.
class OpticalFlow {
 public:
  // The tracer must outlive this. Throws silt::Error where the lens has no inverse in the picture.
  OpticalFlow(const RayTracer& tracer, const PinholeCamera& camera,
              const LensDistortion& lens = {});

  FlowField Between(const Image<float>& depth_m, const SE3d& world_from_this,
                    const SE3d& world_from_other) const {
    return Between(depth_m, RowPoses{world_from_this}, RowPoses{world_from_other});
  }
  FlowField Between(const Image<float>& depth_m, const RowPoses& from, const RowPoses& to) const;

 private:
  struct Sight {
    Vec2d pixel;
    Vec3d eye;  // where the camera is then, in world coordinates
  };
  // Where the camera sees a point before it, in its own coordinates; nothing where it does not.
  std::optional<Vec2d> Project(const Vec3d& point) const;
  // Where and from where a point of the world is seen.
  std::optional<Sight> See(const Vec3d& world, const RowPoses& camera_from_world) const;

  const RayTracer& tracer_;
  PinholeCamera camera_;
  LensDistortion lens_;
  std::optional<LensMap> lens_map_;  // nothing without distortion
};

}  // namespace silt::sim
