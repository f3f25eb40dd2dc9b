// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "silt/sim/ray_packet.h"

namespace silt::sim {

// Whether the surface is there at the point (u, v) of a triangle.
using HitFilter = std::function<bool(std::uint32_t triangle, float u, float v)>;

// Triangles by their vertices, and the numbers by which hits name them.
struct TriangleSet {
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::uint32_t> numbers;
  HitFilter filter;  // empty: solid
};

// All that silt knows of Embree, of versions 3 and 4: a set of triangles and packets of rays.
class EmbreeAdapter {
 public:
  // Throws silt::Error where Embree refuses.
  EmbreeAdapter(const std::vector<Vec3f>& positions, std::vector<TriangleSet> sets);
  ~EmbreeAdapter();

  // `coherent`: the rays start close together and point in similar directions.
  void Intersect(const RayPacket& rays, bool coherent, HitPacket& hits) const;
  // Bit i: something lies on ray i.
  std::uint32_t Occluded(const RayPacket& rays) const;

  // For comparison: the processor time of this thread, in seconds, that Embree alone takes for the
  // nearest hits of coherent packets that lie ready in its own layout.
  double TimeIntersect(const std::vector<RayPacket>& packets) const;

  // "3.13.5", for `silt info`.
  static const char* Version();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace silt::sim
