// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace silt::sim {
namespace {

std::uint32_t AddVertex(Mesh& mesh, const Vec3d& position, const Vec3d& normal, Vec2f texcoord) {
  mesh.positions.push_back(position.Cast<float>());
  mesh.normals.push_back(normal.Cast<float>());
  mesh.texcoords.push_back(texcoord);
  return std::uint32_t(mesh.positions.size() - 1);
}

// How many pictures go along a length that need not close.
float Repeats(double length, double tile) { return float(length / tile); }

// How many go around, a whole number so that the last meets the first.
float ClosedRepeats(double length, double tile) {
  return float(std::max(1.0, std::round(length / tile)));
}

Vec3d Direction(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

Vec3d Turned(const Vec3d& p, const Vec3d& x_axis) {
  return {x_axis.x * p.x - x_axis.y * p.y, x_axis.y * p.x + x_axis.x * p.y, p.z};
}

// A disc about `center`, seen from the side of `normal` (±z); the picture is as wide as the disc.
void AppendDisc(Mesh& mesh, const Vec3d& center, const Vec3d& normal, const Cylinder& of) {
  const Vec2f tile = of.cover.tile_m.value_or(Vec2f{float(2 * of.radius), float(2 * of.radius)});
  const auto texcoord = [&](const Vec3d& at) {
    return Vec2f{0.5f + Repeats(normal.z * at.x, tile.x), 0.5f + Repeats(at.y, tile.y)};
  };
  const std::uint32_t middle = AddVertex(mesh, center, normal, texcoord({}));
  for (int i = 0; i < of.segments; ++i) {
    const Vec3d at = of.radius * Direction(2 * std::numbers::pi * i / of.segments);
    AddVertex(mesh, center + at, normal, texcoord(at));
  }
  for (int i = 0; i < of.segments; ++i) {
    std::uint32_t a = middle + 1 + std::uint32_t(i);
    std::uint32_t b = middle + 1 + std::uint32_t((i + 1) % of.segments);
    if (normal.z < 0) std::swap(a, b);
    mesh.triangles.push_back({{middle, a, b}, of.cover.material});
  }
}

// Two rows of segments + 1 vertices each, the lower one starting at `lower`.
void AppendBand(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, int segments,
                std::uint32_t material) {
  for (std::uint32_t i = 0; i < std::uint32_t(segments); ++i) {
    mesh.triangles.push_back({{lower + i, lower + i + 1, upper + i + 1}, material});
    mesh.triangles.push_back({{lower + i, upper + i + 1, upper + i}, material});
  }
}

}  // namespace

void AppendQuad(Mesh& mesh, const Vec3d& corner, const Vec3d& u, const Vec3d& v,
                const Cover& cover) {
  const Vec3d normal = Normalized(Cross(u, v));
  Vec2f end{1, 1};
  if (cover.tile_m) end = {Repeats(Norm(u), cover.tile_m->x), Repeats(Norm(v), cover.tile_m->y)};
  const std::uint32_t a = AddVertex(mesh, corner, normal, {0, 0});
  const std::uint32_t b = AddVertex(mesh, corner + u, normal, {end.x, 0});
  const std::uint32_t c = AddVertex(mesh, corner + u + v, normal, end);
  const std::uint32_t d = AddVertex(mesh, corner + v, normal, {0, end.y});
  mesh.triangles.push_back({{a, b, c}, cover.material});
  mesh.triangles.push_back({{a, c, d}, cover.material});
}

void AppendBox(Mesh& mesh, const Box& box) {
  const Vec3d x_axis = Direction(box.yaw_rad);
  const Vec3d x = Turned({box.size.x, 0, 0}, x_axis), y = Turned({0, box.size.y, 0}, x_axis);
  const Vec3d z{0, 0, box.size.z};
  const Vec3d low = box.at - 0.5 * x - 0.5 * y;  // corner at −x, −y, bottom
  AppendQuad(mesh, low + z, x, y, box.faces[0]);
  AppendQuad(mesh, low + y, x, -y, box.faces[1]);
  AppendQuad(mesh, low, x, z, box.faces[2]);
  AppendQuad(mesh, low + x + y, -x, z, box.faces[3]);
  AppendQuad(mesh, low + y, -y, z, box.faces[4]);
  AppendQuad(mesh, low + x, y, z, box.faces[5]);
}

void AppendSphere(Mesh& mesh, const Sphere& sphere) {
  const int rings = std::max(2, sphere.segments / 2);
  const double around = 2 * std::numbers::pi * sphere.radius;
  Vec2f end{1, 1};
  if (const auto& tile = sphere.cover.tile_m) {
    end = {ClosedRepeats(around, tile->x), Repeats(around / 2, tile->y)};
  }
  const auto first = std::uint32_t(mesh.positions.size());
  const auto row = std::uint32_t(sphere.segments + 1);
  for (int ring = 0; ring <= rings; ++ring) {
    const double latitude = std::numbers::pi * (double(ring) / rings - 0.5);
    for (int i = 0; i <= sphere.segments; ++i) {
      const double longitude = 2 * std::numbers::pi * (i % sphere.segments) / sphere.segments;
      const Vec3d normal =
          std::cos(latitude) * Direction(longitude) + Vec3d{0, 0, std::sin(latitude)};
      AddVertex(mesh, sphere.center + sphere.radius * normal, normal,
                {end.x * float(i) / float(sphere.segments), end.y * float(ring) / float(rings)});
    }
  }
  // At the poles one triangle of each pair has no area.
  for (int ring = 0; ring < rings; ++ring) {
    const std::uint32_t lower = first + std::uint32_t(ring) * row, upper = lower + row;
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      if (ring > 0) {
        mesh.triangles.push_back(
            {{lower + i, lower + i + 1, upper + i + 1}, sphere.cover.material});
      }
      if (ring + 1 < rings) {
        mesh.triangles.push_back({{lower + i, upper + i + 1, upper + i}, sphere.cover.material});
      }
    }
  }
}

void AppendCylinder(Mesh& mesh, const Cylinder& cylinder) {
  const int segments = cylinder.segments;
  Vec2f end{1, 1};
  if (const auto& tile = cylinder.cover.tile_m) {
    end = {ClosedRepeats(2 * std::numbers::pi * cylinder.radius, tile->x),
           Repeats(cylinder.height, tile->y)};
  }
  const auto first = std::uint32_t(mesh.positions.size());
  const Vec3d top{0, 0, cylinder.height};
  for (const bool upper : {false, true}) {
    for (int i = 0; i <= segments; ++i) {
      const Vec3d normal = Direction(2 * std::numbers::pi * (i % segments) / segments);
      const Vec3d base = cylinder.at + cylinder.radius * normal;
      AddVertex(mesh, upper ? base + top : base, normal,
                {end.x * float(i) / float(segments), upper ? end.y : 0.0f});
    }
  }
  AppendBand(mesh, first, first + std::uint32_t(segments + 1), segments, cylinder.cover.material);
  AppendDisc(mesh, cylinder.at, {0, 0, -1}, cylinder);
  AppendDisc(mesh, cylinder.at + top, {0, 0, 1}, cylinder);
}

}  // namespace silt::sim
