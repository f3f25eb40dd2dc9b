// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shading.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "silt/core/parallel.h"
#include "silt/sim/lit_scene.h"

namespace silt::sim {

namespace {

// Cones that meet a surface at a smaller cosine leave long footprints.
constexpr float kRoundCosine = 0.5f;
constexpr int kMostProbes = 8;

// Within 0.01, exact and smooth enough at powers of two: for the choice of a mip level.
float QuickLog2(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto exponent = float(int(bits >> 23) - 127);
  const auto m = std::bit_cast<float>((bits & 0x007fffffu) | 0x3f800000u);  // in [1, 2)
  return exponent + ((-1 / 3.0f) * m + 2) * m - 5 / 3.0f;
}

// But for its texture.
Float4 RadianceOf(const Material& material, const Vec3f& irradiance) {
  return Float4From(material.emission +
                    std::numbers::inv_pi_v<float> * (material.diffuse * irradiance));
}

template <typename Body>
void ForBlocks(std::size_t n, const Body& body) {
  constexpr std::size_t kBlock = 4096;
  ParallelFor(int((n + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t begin = std::size_t(block) * kBlock;
    for (std::size_t i = begin; i < std::min(n, begin + kBlock); ++i) body(i);
  });
}

}  // namespace

float Log2TexelsPerMetre(const Mesh& mesh, const Triangle& triangle, const Texture& texture) {
  const std::uint32_t* v = triangle.vertex;
  const std::vector<Vec3f>& p = mesh.positions;
  const std::vector<Vec2f>& t = mesh.texcoords;
  const Vec2f e = t[v[1]] - t[v[0]], f = t[v[2]] - t[v[0]];
  const float texels =
      std::abs(e.x * f.y - e.y * f.x) * float(texture.width()) * float(texture.height());
  const float area = Norm(Cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]));
  return texels > 0 && area > 0 ? 0.5f * std::log2(texels / area) : 0;
}

Shading::Shading(const Scene& scene, const Irradiance& irradiance) : textures_(scene.textures) {
  records_.resize(scene.mesh.triangles.size());
  ForBlocks(records_.size(),
            [&](std::size_t i) { records_[i] = TriangleRecord(scene, scene.mesh.triangles[i]); });
  StoreLight(scene, irradiance.at_samples(), LayRows(irradiance.grid()));
  StoreFineLight(scene, irradiance.fine());
}

Shading::Record Shading::TriangleRecord(const Scene& scene, const Triangle& triangle) const {
  Record record;
  record.texture = scene.materials[triangle.material].texture;
  if (record.texture < 0) return record;
  const Mesh& mesh = scene.mesh;
  const Texture& texture = textures_[std::size_t(record.texture)];
  record.log2_texels_per_metre = Log2TexelsPerMetre(mesh, triangle, texture);
  const std::uint32_t* v = triangle.vertex;
  record.texcoord = mesh.texcoords[v[0]];
  record.along_u = mesh.texcoords[v[1]] - record.texcoord;
  record.along_v = mesh.texcoords[v[2]] - record.texcoord;
  const Vec3f e = mesh.positions[v[1]] - mesh.positions[v[0]];
  const Vec3f f = mesh.positions[v[2]] - mesh.positions[v[0]];
  const Vec3f n = Cross(e, f);
  if (!(Dot(n, n) > 0)) return record;
  // ∇u and ∇v on the triangle: each perpendicular to the edge on which the other one runs.
  const Vec3f grad_u = (1 / Dot(n, n)) * Cross(f, n), grad_v = (1 / Dot(n, n)) * Cross(n, e);
  record.right = record.along_u.x * grad_u + record.along_v.x * grad_v;
  record.up = record.along_u.y * grad_u + record.along_v.y * grad_v;
  return record;
}

std::vector<Shading::LightPoint> Shading::LayRows(const SurfaceGrid& grid) {
  std::vector<LightPoint> points;
  for (std::uint32_t i = 0; i < records_.size(); ++i) {
    Record& record = records_[i];
    const SurfaceGrid::TriangleRows rows = grid.CellRowsOf(i);
    record.rows = std::uint16_t(rows.count);
    record.apex = std::uint16_t(rows.apex);
    record.first_row = std::uint32_t(row_begin_.size());
    for (int row = 0; row <= rows.count; ++row) {
      row_begin_.push_back(std::uint32_t(points.size()));
      const int intervals = rows.Intervals(row);
      for (int column = 0; column <= intervals; ++column) {
        points.push_back({i, grid.SampleAt(i, row, column)});
      }
    }
    row_begin_.push_back(std::uint32_t(points.size()));
  }
  return points;
}

void Shading::StoreLight(const Scene& scene, const StoredLight& light,
                         const std::vector<LightPoint>& points) {
  // One more than there are: values are read in pairs.
  front_.resize(points.size() + 1);
  back_.resize(points.size() + 1);
  ForBlocks(points.size(), [&](std::size_t k) {
    const LightPoint& p = points[k];
    const Material& material = scene.materials[scene.mesh.triangles[p.triangle].material];
    front_[k] = RadianceOf(material, light.front[p.sample]);
    if (material.two_sided) back_[k] = RadianceOf(material, light.back[p.sample]);
  });
}

void Shading::StoreFineLight(const Scene& scene, const FineLight& fine) {
  patches_.resize(fine.irradiance().size());
  ForBlocks(fine.patches().size(), [&](std::size_t i) {
    const FineLight::Patch& patch = fine.patches()[i];
    const Record& record = records_[patch.cell.triangle];
    const std::uint32_t row = row_begin_[record.first_row + patch.cell.row];
    (patch.front ? front_ : back_)[row + patch.cell.column][3] = float(i + 1);
    const Material& material = scene.materials[scene.mesh.triangles[patch.cell.triangle].material];
    const std::size_t first = i * FineLight::kPlaces;
    for (std::size_t k = first; k < first + FineLight::kPlaces; ++k) {
      patches_[k] = RadianceOf(material, fine.irradiance()[k]);
    }
  });
}

void Shading::FindLight(const Record& record, const SurfaceHit& hit, Place& place) const {
  const float weight[3] = {1 - hit.u - hit.v, hit.u, hit.v};
  constexpr int kNext[] = {1, 2, 0, 1};
  const float base = weight[kNext[record.apex]], next = weight[kNext[record.apex + 1]];
  const float along = base + next > 0 ? std::clamp(next / (base + next), 0.0f, 1.0f) : 0.0f;
  const float height = std::clamp(weight[record.apex], 0.0f, 1.0f) * float(record.rows);
  const int row = std::min(int(height), int(record.rows) - 1);
  const std::uint32_t* begin = &row_begin_[record.first_row + std::uint32_t(row)];
  const Float4* light = hit.cosine < 0 ? front_.data() : back_.data();
  const auto in_row = [&](std::uint32_t from, std::uint32_t to, float& share) {
    const auto intervals = int(to - from) - 1;  // 0 at the apex
    const float x = along * float(intervals);
    const int column = std::max(0, std::min(int(x), intervals - 1));
    share = x - float(column);
    __builtin_prefetch(light + from + column);
    return light + from + column;
  };
  place.near = in_row(begin[0], begin[1], place.near_share);
  place.far = in_row(begin[1], begin[2], place.far_share);
  place.between_rows = height - float(row);
  place.patches = patches_.data();
}

// A cone of width w meets the surface in an ellipse, w wide and w/cos long. One probe of its mean
// width √(w·w/cos) is enough while it is at most twice as long as wide; else several lie along it.
void Shading::FindTexture(const Record& record, const SurfaceHit& hit, Place& place) const {
  place.texture = &textures_[std::size_t(record.texture)];
  place.first = record.texcoord + hit.u * record.along_u + hit.v * record.along_v;
  const float cosine = std::max(std::abs(hit.cosine), 1e-3f), w = hit.footprint_m;
  place.probes = 1;
  if (cosine < kRoundCosine) {
    place.probes = std::min(int(std::ceil(kRoundCosine / cosine)), kMostProbes);
    // Along the projection of the ray onto the surface, of length sin for a unit direction.
    const float sine = std::sqrt(1 - cosine * cosine);
    const float length = w / (cosine * sine * Norm(hit.direction) * float(place.probes));
    place.step = {length * Dot(record.right, hit.direction),
                  length * Dot(record.up, hit.direction)};
    place.first = place.first - (0.5f * float(place.probes - 1)) * place.step;
  }
  place.lod =
      record.log2_texels_per_metre + 0.5f * QuickLog2(w * w / (cosine * float(place.probes)));
  place.texture->Find(place.first.x, place.first.y, place.lod, place.probe);
  place.probe.Prefetch();
}

Float4 Shading::Place::FineLightHere() const {
  const FineLight::Corner corner = FineLight::CornerOf(near_share, between_rows);
  const Float4* row =
      patches + (std::size_t(near[0][3]) - 1) * FineLight::kPlaces + std::size_t(corner.first);
  const Float4* next = row + FineLight::kSide;
  return Lerp(Lerp(row[0], row[1], corner.along), Lerp(next[0], next[1], corner.along), corner.up);
}

Float4 Shading::Place::MeanOfProbes() const {
  Float4 sum = probe.Read();
  for (int i = 1; i < probes; ++i) {
    const Vec2f at = first + float(i) * step;
    Texture::Place next;
    texture->Find(at.x, at.y, lod, next);
    sum += next.Read();
  }
  return (1 / float(probes)) * sum;
}

void Shading::Find(const SurfaceHit& hit, Place& place) const {
  const Record& record = records_[hit.triangle];
  FindLight(record, hit, place);
  place.texture = nullptr;
  if (record.texture >= 0) FindTexture(record, hit, place);
}

Vec3f Shade(const LitScene& lit, const SurfaceHit& hit) {
  Shading::Place place;
  lit.shading().Find(hit, place);
  return Vec3From(place.Read());
}

}  // namespace silt::sim
