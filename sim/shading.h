// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/sim/float4.h"
#include "silt/sim/huge_pages.h"
#include "silt/sim/irradiance.h"
#include "silt/sim/scene.h"

namespace silt::sim {

class LitScene;

struct SurfaceHit {
  std::uint32_t triangle;
  float u, v;
  float cosine;       // of the angle from the ray to the front normal
  float footprint_m;  // width of the ray's cone at the hit, across the ray
  Vec3f direction;    // of the ray, of any length
};

// What every surface of a lit scene sends towards the viewer: emission + albedo/π · irradiance on
// the side that is seen. It depends on where the viewer stands only through the blur of textures.
//
// Memory takes longer than the arithmetic. All that a hit needs is therefore laid out for it once,
// a cache line for the triangle and its light in rows, and hits are served in three rounds, each of
// which asks for the memory of the next.
class Shading {
 public:
  Shading(const Scene& scene, const Irradiance& irradiance);
  Shading(const Shading&) = delete;  // refers to the textures of this very scene
  Shading& operator=(const Shading&) = delete;

  // Round 1.
  void Prefetch(std::uint32_t triangle) const { __builtin_prefetch(&records_[triangle]); }

  // Where the radiance of a hit is read.
  struct Place {
    const Float4 *near, *far;  // two neighbours each in the two rows next to the hit
    const Float4* patches;     // of the fine light; near[0][3] tells which, from 1 on, if any
    float near_share, far_share, between_rows;
    const Texture* texture;  // null: none
    int probes;              // of the texture, evenly along the footprint
    float lod;               // of each
    Vec2f first, step;       // their coordinates
    Texture::Place probe;    // the first

    Float4 Read() const {
      const Float4 light = near[0][3] == 0 ? Lerp(Lerp(near[0], near[1], near_share),
                                                  Lerp(far[0], far[1], far_share), between_rows)
                                           : FineLightHere();
      if (texture == nullptr) return light;
      return light * (probes == 1 ? probe.Read() : MeanOfProbes());
    }

   private:
    Float4 FineLightHere() const;
    Float4 MeanOfProbes() const;
  };
  // Round 2, which writes the place where it is to stay, see MipLevel::Find; Place::Read is
  // round 3.
  void Find(const SurfaceHit& hit, Place& place) const;

 private:
  // One cache line.
  struct alignas(64) Record {
    std::int32_t texture = -1;         // −1: none
    float log2_texels_per_metre = 0;   // the geometric mean of both directions
    Vec2f texcoord, along_u, along_v;  // of the point (u, v): texcoord + u·along_u + v·along_v
    Vec3f right, up;                   // gradients of the texture coordinates, per metre
    // Light is kept in rows parallel to an edge, the corner `apex` being row `rows`.
    std::uint16_t rows = 1, apex = 0;
    std::uint32_t first_row = 0;  // index into row_begin_
  };

  Record TriangleRecord(const Scene& scene, const Triangle& triangle) const;
  // Makes the rows of all triangles, and tells whose light each of their values is.
  struct LightPoint {
    std::uint32_t triangle, sample;
  };
  std::vector<LightPoint> LayRows(const SurfaceGrid& grid);
  void StoreLight(const Scene& scene, const StoredLight& light,
                  const std::vector<LightPoint>& points);
  void StoreFineLight(const Scene& scene, const FineLight& fine);
  void FindTexture(const Record& record, const SurfaceHit& hit, Place& place) const;
  void FindLight(const Record& record, const SurfaceHit& hit, Place& place) const;

  const std::vector<Texture>& textures_;
  HugePageVector<Record> records_;           // by triangle
  HugePageVector<std::uint32_t> row_begin_;  // index of each row's first value, and of the next
  // Radiance but for the texture; the fourth number is that of the patch of the cell that the value
  // begins, plus one, or 0.
  HugePageVector<Float4> front_, back_;
  HugePageVector<Float4> patches_;  // FineLight::kPlaces for each
};

// log2 of √(texels / area in m²) on a triangle, the geometric mean of both directions; 0 where
// there are none.
float Log2TexelsPerMetre(const Mesh& mesh, const Triangle& triangle, const Texture& texture);

// The radiance of one hit.
Vec3f Shade(const LitScene& lit, const SurfaceHit& hit);

}  // namespace silt::sim
