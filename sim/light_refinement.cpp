// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_refinement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "silt/core/parallel.h"
#include "silt/sim/cell_light.h"
#include "silt/sim/denormals.h"
#include "silt/sim/triangle_corners.h"

namespace silt::sim {

namespace {

using Cell = SurfaceGrid::Cell;
using Patch = FineLight::Patch;

// Where things are nearer than this (Ward's harmonic mean) a shadow may lie between samples.
constexpr float kNearM = 0.25f;
// Samples so close together tell enough.
constexpr float kLeastM = 0.012f;
constexpr int kStripsPerBlock = 16, kBlocksPerReport = 1024;

bool IsBlack(const Vec3f& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}  // namespace

LightRefinement::LightRefinement(const Scene& scene, const RayTracer& tracer,
                                 const SurfaceGrid& grid, const LightingOptions& options)
    : scene_(scene),
      grid_(grid),
      tolerance_(options.refine_tolerance),
      direct_(scene, tracer, options.light_points),
      background_(scene, tracer, options.environment_directions),
      look_(scene, tracer, kPacketSize, 0) {}

Vec3f LightRefinement::Direct(const SurfaceSample& at) const {
  return direct_.Irradiance(at.position, at.normal) +
         background_.Irradiance(at.position, at.normal);
}

std::vector<LightRefinement::Strip> LightRefinement::LitStrips() const {
  std::vector<Strip> strips;
  for (std::uint32_t i = 0; i < scene_.mesh.triangles.size(); ++i) {
    const Material& material = scene_.materials[scene_.mesh.triangles[i].material];
    if (IsBlack(material.diffuse)) continue;
    const int rows = grid_.CellRowsOf(i).count;
    for (int row = 0; row < rows; ++row) {
      if (material.two_sided) strips.push_back({i, row, false});
      strips.push_back({i, row, true});
    }
  }
  return strips;
}

bool LightRefinement::IsSuspect(const Cell& cell, bool front, const LightSamples& samples) const {
  if (LengthM(cell) < kLeastM) return false;
  const Vec2f middle = grid_.PointOf({cell, 0.5f, 0.5f});
  const SurfaceLookup around = grid_.Locate(cell.triangle, middle.x, middle.y);
  bool is_near = false, differs = false, is_open = false;
  const std::vector<Vec3f>& direct = samples.direct.side(front);
  const Vec3f& first = direct[around.sample[0]];
  for (const std::uint32_t sample : around.sample) {
    const Gathered& near = samples.near[front][sample];
    is_near |= near.distance_m < kNearM;
    is_open |= !near.closed;
    differs |=
        LightDiffers(direct[sample], first, samples.indirect.side(front)[sample], tolerance_);
  }
  return is_open && (is_near || differs);
}

float LightRefinement::LengthM(const Cell& cell) const {
  const TriangleCorners corners(scene_.mesh, scene_.mesh.triangles[cell.triangle]);
  const auto corner = [&](float along, float up) {
    const Vec2f uv = grid_.PointOf({cell, along, up});
    return corners.Position({1 - uv.x - uv.y, uv.x, uv.y});
  };
  return std::max(Norm(corner(1, 1) - corner(0, 0)), Norm(corner(1, 0) - corner(0, 1)));
}

// A cell is refined if its middle errs, or the middle of one of its borders, which its neighbour
// looks at too: what both show along it then differs by no more than the tolerance, or neither is
// as it was.
void LightRefinement::RefineStrip(const Strip& strip, const LightSamples& samples,
                                  Patches& result) const {
  constexpr int side = FineLight::kSide, half = FineLight::kIntervals / 2;
  constexpr int middle = half * side + half;
  const int intervals = grid_.CellRowsOf(strip.triangle).Intervals(strip.row);
  Patch patch{{strip.triangle, std::uint16_t(strip.row), 0}, strip.front ? 1u : 0u};
  const CellLight::Sources sources{scene_.mesh, grid_,
                                   [this](const SurfaceSample& at) { return Direct(at); }, look_,
                                   tolerance_};
  std::optional<CellLight> light;
  for (int column = 0; column < intervals; ++column) {
    patch.cell.column = std::uint16_t(column);
    if (!IsSuspect(patch.cell, strip.front, samples)) {
      light.reset();
      continue;
    }
    light.emplace(light ? light->Next() : CellLight(sources, patch, samples));
    const int looked_at[] = {middle, middle - half, middle + half, half, half + 2 * half * side};
    if (std::none_of(std::begin(looked_at), std::end(looked_at),
                     [&](int place) { return light->Errs(place); })) {
      continue;
    }
    if (const auto all = light->All()) {
      result.patches.push_back(patch);
      result.irradiance.insert(result.irradiance.end(), all->begin(), all->end());
    }
  }
}

FineLight LightRefinement::Refine(const LightSamples& samples,
                                  const std::function<void(double)>& progress) const {
  const std::vector<Strip> strips = LitStrips();
  const int blocks = int((strips.size() + kStripsPerBlock - 1) / kStripsPerBlock);
  std::vector<Patches> found{std::size_t(blocks)};
  for (int begin = 0; begin < blocks; begin += kBlocksPerReport) {
    const int end = std::min(blocks, begin + kBlocksPerReport);
    ParallelFor(end - begin, [&](int b) {
      const ScopedFlushDenormals flush;
      const std::size_t first = std::size_t(begin + b) * kStripsPerBlock;
      for (std::size_t i = first; i < std::min(strips.size(), first + kStripsPerBlock); ++i) {
        RefineStrip(strips[i], samples, found[std::size_t(begin + b)]);
      }
    });
    progress(double(end) / blocks);
  }
  // Sorted: within a triangle's row, the back's come first and then the front's.
  std::vector<std::pair<Patch, const Vec3f*>> sorted;
  for (const Patches& block : found) {
    for (std::size_t i = 0; i < block.patches.size(); ++i) {
      sorted.push_back({block.patches[i], &block.irradiance[i * FineLight::kPlaces]});
    }
  }
  std::sort(sorted.begin(), sorted.end());
  Patches all;
  for (const auto& [patch, values] : sorted) {
    all.patches.push_back(patch);
    all.irradiance.insert(all.irradiance.end(), values, values + FineLight::kPlaces);
  }
  return {std::move(all.patches), std::move(all.irradiance)};
}

}  // namespace silt::sim
