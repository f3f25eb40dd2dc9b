// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"

// The inside of a box, 4 × 3 × 5 m, painted with a smooth pattern in space: images, depths and
// poses that are exact without any renderer.
namespace silt::tracker {

inline constexpr PinholeCamera kSmallCamera{120.3, 120, 79.5, 59.5, 160, 120};

struct View {
  Image<float> intensity, depth_m;
};

inline float RoomPattern(const Vec3d& p) {
  const double s = std::sin(4.1 * p.x + 0.3) * std::sin(3.7 * p.y - 0.2) +
                   std::sin(2.9 * p.z + 1.1 * p.x) + 0.6 * std::sin(7.3 * p.x - 6.1 * p.y) +
                   0.6 * std::sin(5.7 * p.y + 6.7 * p.z);
  return float(0.5 + 0.14 * s);
}

// The same under fine detail, of waves some eight pixels long, in which a start farther away than
// half of one is lost.
inline float DetailedPattern(const Vec3d& p) {
  const double waves = std::sin(40 * p.x) + std::sin(43 * p.y) + std::sin(38 * p.z);
  return float(0.5 + 0.3 * (RoomPattern(p) - 0.5) + 0.13 * waves);
}

// Distance along the ray, in units of `direction`, to the walls around the origin.
inline double DistanceToWall(const Vec3d& origin, const Vec3d& direction) {
  const double half[3] = {2, 1.5, 2.5};
  const double o[3] = {origin.x, origin.y, origin.z};
  const double d[3] = {direction.x, direction.y, direction.z};
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (d[i] != 0) nearest = std::min(nearest, (std::copysign(half[i], d[i]) - o[i]) / d[i]);
  }
  return nearest;
}

// A board that hangs in the room, 1 × 0.7 m, parallel to the wall behind it.
inline constexpr Vec3d kBoardCorner{-0.5, -0.4, 1.2};

// Distance along the ray, in units of `direction`, to the board; infinite beside it.
inline double DistanceToBoard(const Vec3d& origin, const Vec3d& direction) {
  const double s = (kBoardCorner.z - origin.z) / direction.z;
  const Vec3d p = origin + s * direction - kBoardCorner;
  const bool hit = s > 0 && p.x > 0 && p.x < 1 && p.y > 0 && p.y < 0.7;
  return hit ? s : std::numeric_limits<double>::infinity();
}

struct Hit {
  double depth_m;
  float intensity;
};

using Pattern = float (*)(const Vec3d&);

// What the ray through (x, y) meets: the room in its pattern, its walls paler and the board darker.
inline Hit BoardOrWall(const SE3d& room_from_camera, const PinholeCamera& camera, Pattern paint,
                       double x, double y) {
  const Vec3d direction = room_from_camera.rotation * camera.Unproject(x, y, 1.0);
  const double wall = DistanceToWall(room_from_camera.translation, direction);
  const double board = DistanceToBoard(room_from_camera.translation, direction);
  const double z = std::min(wall, board);
  const float pattern = paint(room_from_camera.translation + z * direction);
  return {z, board < wall ? 0.4f * pattern : 0.3f + 0.7f * pattern};
}

// The intensity is the mean over the pixel's area, as the edges of the board need it.
inline View RenderRoomWithBoard(const SE3d& room_from_camera,
                                const PinholeCamera& camera = kSmallCamera,
                                Pattern paint = DetailedPattern) {
  View view{Image<float>(camera.width, camera.height), Image<float>(camera.width, camera.height)};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      view.depth_m(x, y) = float(BoardOrWall(room_from_camera, camera, paint, x, y).depth_m);
      for (int i = 0; i < 16; ++i) {
        const double dx = (i % 4 - 1.5) / 4, dy = (i / 4 - 1.5) / 4;
        view.intensity(x, y) +=
            BoardOrWall(room_from_camera, camera, paint, x + dx, y + dy).intensity / 16;
      }
    }
  }
  return view;
}

inline View RenderRoom(const SE3d& room_from_camera, const PinholeCamera& camera = kSmallCamera,
                       Pattern pattern = RoomPattern) {
  View view{Image<float>(camera.width, camera.height), Image<float>(camera.width, camera.height)};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vec3d ray = camera.Unproject(x, y, 1.0);  // z = 1: its multiple is the depth
      const Vec3d direction = room_from_camera.rotation * ray;
      const double z = DistanceToWall(room_from_camera.translation, direction);
      view.depth_m(x, y) = float(z);
      view.intensity(x, y) = pattern(room_from_camera.translation + z * direction);
    }
  }
  return view;
}

// The same as a range camera delivers it: gray in 8 bits.
inline Frame RoomFrame(const SE3d& room_from_camera, double time_s = 0,
                       const PinholeCamera& camera = kSmallCamera) {
  View view = RenderRoom(room_from_camera, camera);
  Frame frame{time_s, Image<Rgb8>(camera.width, camera.height), {}};
  for (std::size_t i = 0; i < view.intensity.size(); ++i) {
    const auto gray = std::uint8_t(std::lround(255 * view.intensity.data()[i]));
    frame.rgb.data()[i] = {gray, gray, gray};
  }
  frame.depth_m = std::move(view.depth_m);
  return frame;
}

// |translation| in metres and angle in radians between two poses.
inline double Distance(const SE3d& a, const SE3d& b) { return Norm(a.translation - b.translation); }
inline double Angle(const SE3d& a, const SE3d& b) {
  return RotationAngle(a.rotation.Conjugate() * b.rotation);
}

}  // namespace silt::tracker
