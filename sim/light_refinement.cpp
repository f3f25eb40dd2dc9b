// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "silt/core/parallel.h"
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

// By more than a share of what there is, in any colour.
bool Differ(const Vec3f& a, const Vec3f& b, const Vec3f& besides, float share) {
  for (int c = 0; c < 3; ++c) {
    const float x = (&a.x)[c], y = (&b.x)[c];
    if (std::abs(x - y) > share * (std::max(x, y) + (&besides.x)[c])) return true;
  }
  return false;
}

// In place of what nobody sees: the mean of what is seen in the same patch, the nearest above all.
void FillClosed(const std::array<bool, FineLight::kPlaces>& closed, Vec3f* values) {
  constexpr int side = FineLight::kSide;
  for (int i = 0; i < FineLight::kPlaces; ++i) {
    if (!closed[std::size_t(i)]) continue;
    Vec3f sum;
    float total = 0;
    for (int k = 0; k < FineLight::kPlaces; ++k) {
      if (closed[std::size_t(k)]) continue;
      const int dx = k % side - i % side, dy = k / side - i / side;
      const float weight = 1 / float((dx * dx + dy * dy) * (dx * dx + dy * dy));
      sum += weight * values[k];
      total += weight;
    }
    values[i] = (1 / total) * sum;
  }
}

}  // namespace

LightRefinement::LightRefinement(const Scene& scene, const RayTracer& tracer,
                                 const SurfaceGrid& grid, const LightingOptions& options)
    : scene_(scene),
      grid_(grid),
      tolerance_(options.refine_tolerance),
      direct_(scene, tracer, options.light_points),
      background_(scene, tracer, options.environment_directions),
      look_(scene, tracer, kPacketSize, 0) {}

class LightRefinement::CellLight {
 public:
  CellLight(const LightRefinement& of, const Patch& patch, const Samples& samples)
      : of_(of),
        patch_(patch),
        samples_(samples),
        corners_(of.scene_.mesh, of.scene_.mesh.triangles[patch.cell.triangle]) {}

  // That of the next cell of the same rows begins where this one ends.
  CellLight Next() const {
    CellLight next = *this;
    ++next.patch_.cell.column;
    next.known_.fill(false), next.looked_.fill(false);
    for (int i = 0; i < FineLight::kPlaces; i += FineLight::kSide) {
      next.Copy(std::size_t(i), *this, std::size_t(i + FineLight::kIntervals));
    }
    return next;
  }

  // Whether direct light at a place is another one than the samples tell. What nobody sees does not
  // count.
  bool Errs(int place) {
    const SurfaceLookup lookup = LookupOf(place);
    const Vec3f stored = samples_.direct.At(lookup, front());
    const Vec3f besides = samples_.indirect.At(lookup, front());
    return Differ(Direct(place), stored, besides, of_.tolerance_) && !IsClosed(place);
  }

  // Of all light, at all places. Nothing where nobody sees any of them.
  std::optional<std::array<Vec3f, FineLight::kPlaces>> All() {
    for (int i = 0; i < FineLight::kPlaces; ++i) IsClosed(i);
    if (std::all_of(closed_.begin(), closed_.end(), [](bool closed) { return closed; })) return {};
    std::array<Vec3f, FineLight::kPlaces> all;
    for (int i = 0; i < FineLight::kPlaces; ++i) {
      if (closed_[std::size_t(i)]) continue;
      all[std::size_t(i)] = Direct(i) + samples_.indirect.At(LookupOf(i), front());
    }
    FillClosed(closed_, all.data());
    return all;
  }

 private:
  bool front() const { return patch_.front != 0; }

  Vec2f PointOf(int place) const {
    return of_.grid_.PointOf({patch_.cell, float(place % FineLight::kSide) / FineLight::kIntervals,
                              float(place / FineLight::kSide) / FineLight::kIntervals});
  }
  SurfaceLookup LookupOf(int place) const {
    const Vec2f uv = PointOf(place);
    return of_.grid_.Locate(patch_.cell.triangle, uv.x, uv.y);
  }
  SurfaceSample SurfaceAt(int place) const {
    const Vec2f uv = PointOf(place);
    const Vec3f weight{1 - uv.x - uv.y, uv.x, uv.y};
    const Vec3f normal = corners_.Normal(weight);
    return {corners_.Position(weight) + corners_.Inward(weight), front() ? normal : -normal};
  }

  const Vec3f& Direct(int place) {
    Vec3f& direct = direct_[std::size_t(place)];
    if (!std::exchange(known_[std::size_t(place)], true)) {
      const SurfaceSample at = SurfaceAt(place);
      direct = of_.direct_.Irradiance(at.position, at.normal) +
               of_.background_.Irradiance(at.position, at.normal);
    }
    return direct;
  }
  bool IsClosed(int place) {
    bool& closed = closed_[std::size_t(place)];
    if (!std::exchange(looked_[std::size_t(place)], true)) {
      const SurfaceSample at = SurfaceAt(place);
      const auto dark = [](const TriangleHit&, const Vec3f&) { return Vec3f{}; };
      const std::uint64_t number = std::uint64_t(patch_.cell.triangle) * FineLight::kPlaces;
      closed = of_.look_.Gather(at.position, at.normal, number + std::uint64_t(place), dark).closed;
    }
    return closed;
  }
  void Copy(std::size_t to, const CellLight& other, std::size_t from) {
    known_[to] = other.known_[from], direct_[to] = other.direct_[from];
    looked_[to] = other.looked_[from], closed_[to] = other.closed_[from];
  }

  const LightRefinement& of_;
  Patch patch_;
  const Samples& samples_;
  TriangleCorners corners_;
  std::array<bool, FineLight::kPlaces> known_{}, looked_{}, closed_{};
  std::array<Vec3f, FineLight::kPlaces> direct_;
};

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

bool LightRefinement::IsSuspect(const Cell& cell, bool front, const Samples& samples) const {
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
    differs |= Differ(direct[sample], first, samples.indirect.side(front)[sample], tolerance_);
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
void LightRefinement::RefineStrip(const Strip& strip, const Samples& samples,
                                  Patches& result) const {
  constexpr int side = FineLight::kSide, half = FineLight::kIntervals / 2;
  constexpr int middle = half * side + half;
  const int intervals = grid_.CellRowsOf(strip.triangle).Intervals(strip.row);
  Patch patch{{strip.triangle, std::uint16_t(strip.row), 0}, strip.front ? 1u : 0u};
  std::optional<CellLight> light;
  for (int column = 0; column < intervals; ++column) {
    patch.cell.column = std::uint16_t(column);
    if (!IsSuspect(patch.cell, strip.front, samples)) {
      light.reset();
      continue;
    }
    light.emplace(light ? light->Next() : CellLight(*this, patch, samples));
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

FineLight LightRefinement::Refine(const Samples& samples,
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
