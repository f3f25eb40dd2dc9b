// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "silt/sim/fine_light.h"
#include "silt/sim/indirect_light.h"
#include "silt/sim/stored_light.h"
#include "silt/sim/triangle_corners.h"

namespace silt::sim {

// What is known at the samples of a grid. `near` by side (front: 1): what each sees about itself.
struct LightSamples {
  const StoredLight& direct;
  const StoredLight& indirect;
  const std::vector<Gathered> (&near)[2];
};

// By more than a share of what there is, in any colour; `besides` is other light, of either.
bool LightDiffers(const Vec3f& a, const Vec3f& b, const Vec3f& besides, float share);

// Light at the places of one side of a cell, see FineLight, found when it is asked for.
class CellLight {
 public:
  struct Sources {
    const Mesh& mesh;
    const SurfaceGrid& grid;
    std::function<Vec3f(const SurfaceSample&)> direct;
    const IndirectLight& look;  // few rays, which tell where nobody can look at a place
    float tolerance;
  };
  // All must outlive this.
  CellLight(const Sources& sources, const FineLight::Patch& patch, const LightSamples& samples);

  // That of the next cell of the same rows begins where this one ends.
  CellLight Next() const;

  // Whether direct light at a place is another one than the samples tell. What nobody sees does not
  // count.
  bool Errs(int place);

  // Of all light, at all places; what nobody sees is like what is seen nearest to it. Nothing where
  // nobody sees any of them.
  std::optional<std::array<Vec3f, FineLight::kPlaces>> All();

 private:
  bool front() const { return patch_.front != 0; }
  Vec2f PointOf(int place) const;
  SurfaceLookup LookupOf(int place) const;
  SurfaceSample SurfaceAt(int place) const;
  const Vec3f& Direct(int place);
  bool IsClosed(int place);
  void Copy(std::size_t to, const CellLight& other, std::size_t from);

  const Sources* sources_;
  FineLight::Patch patch_;
  const LightSamples* samples_;
  TriangleCorners corners_;
  std::array<bool, FineLight::kPlaces> known_{}, looked_{}, closed_{};
  std::array<Vec3f, FineLight::kPlaces> direct_;
};

}  // namespace silt::sim
