// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/vector.h"

namespace silt::sim {

// Rays travel sixteen at a time, one SIMD register per coordinate.
inline constexpr int kPacketSize = 16;

// Origins and directions in world coordinates. A direction need not be unit: distances are counted
// in its lengths, so that a camera ray whose z is 1 in camera coordinates measures depth along z.
struct alignas(64) RayPacket {
  float origin_x[kPacketSize], origin_y[kPacketSize], origin_z[kPacketSize];
  float direction_x[kPacketSize], direction_y[kPacketSize], direction_z[kPacketSize];
  float near[kPacketSize], far[kPacketSize];
  std::int32_t valid[kPacketSize] = {};  // -1: a ray; 0: none

  static constexpr float kFar = 1e30f;
  struct Segment {
    Vec3f origin, direction;
    float near = 0, far = kFar;
  };
  void Set(int lane, const Segment& ray) {
    origin_x[lane] = ray.origin.x;
    origin_y[lane] = ray.origin.y;
    origin_z[lane] = ray.origin.z;
    direction_x[lane] = ray.direction.x;
    direction_y[lane] = ray.direction.y;
    direction_z[lane] = ray.direction.z;
    near[lane] = ray.near;
    far[lane] = ray.far;
    valid[lane] = -1;
  }
};

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// The nearest hits. The point is (1 − u − v)·p0 + u·p1 + v·p2.
struct alignas(64) HitPacket {
  float distance[kPacketSize];  // in lengths of the direction
  float u[kPacketSize], v[kPacketSize];
  float cosine[kPacketSize];  // of the angle from the ray to the front normal: < 0 hits the front
  std::uint32_t triangle[kPacketSize];  // kNoTriangle: nothing hit
};

}  // namespace silt::sim
