// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr Mat3d kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Mat3d kZUpFromYUp{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};

struct Bounds {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void Add(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

// p_world = yaw·mirror·scale·(upright·p_model − base) + at.
class Placer {
 public:
  Placer(const Mesh& model, const ModelPlacement& placement)
      : upright_from_model_((placement.z_up ? kIdentity : kZUpFromYUp) * placement.rotation),
        placement_(placement) {
    Bounds bounds;
    for (const Triangle& t : model.triangles) {
      for (const std::uint32_t v : t.vertex) bounds.Add(Upright(model.positions[v]));
    }
    const Vec3d extent = bounds.high - bounds.low;
    base_ = {bounds.low.x + extent.x / 2, bounds.low.y + extent.y / 2, bounds.low.z};
    scale_ = {placement.scale, placement.scale, placement.scale};
    if (const auto& size = placement.size) {
      scale_ = {Fit(size->x, extent.x), Fit(size->y, extent.y), Fit(size->z, extent.z)};
    }
    if (placement.mirror) scale_.x = -scale_.x;
  }

  bool mirrors() const { return placement_.mirror; }

  // Metres, z up, not turned and moved yet.
  Vec3d Scaled(const Vec3f& p) const { return scale_ * (Upright(p) - base_); }
  Vec3d World(const Vec3f& p) const { return Turned(Scaled(p)) + placement_.at; }
  Vec3d ScaledNormal(const Vec3f& n) const {
    const Vec3d upright = Upright(n);
    return {upright.x / scale_.x, upright.y / scale_.y, upright.z / scale_.z};
  }
  Vec3d WorldNormal(const Vec3f& n) const { return Turned(Normalized(ScaledNormal(n))); }

 private:
  Vec3d Upright(const Vec3f& p) const { return upright_from_model_ * p.Cast<double>(); }
  Vec3d Turned(const Vec3d& p) const {
    const double c = std::cos(placement_.yaw_rad), s = std::sin(placement_.yaw_rad);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  }
  static double Fit(double wanted, double extent) { return extent > 0 ? wanted / extent : 1; }

  Mat3d upright_from_model_;
  const ModelPlacement& placement_;
  Vec3d base_, scale_;
};

// Texture coordinates of a point on a face that looks along ±x, ±y or ±z, the picture upright.
Vec2f Projected(const Vec3d& p, const Vec3d& normal, const Vec2f& tile_m) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  Vec2d at;
  if (z >= x && z >= y) {
    at = {normal.z > 0 ? p.x : -p.x, p.y};
  } else if (x >= y) {
    at = {normal.x > 0 ? p.y : -p.y, p.z};
  } else {
    at = {normal.y > 0 ? -p.x : p.x, p.z};
  }
  return {float(at.x / tile_m.x), float(at.y / tile_m.y)};
}

class ModelAppender {
 public:
  ModelAppender(Mesh& mesh, const Mesh& model, const ModelPlacement& placement)
      : mesh_(mesh),
        model_(model),
        placer_(model, placement),
        copies_(model.positions.size(), kNone) {}

  void Append(const Triangle& from, const MaterialUse& use) {
    Triangle to{{}, use.material};
    const Vec3d normal = FaceNormal(from);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = from.vertex[i];
      if (use.tile_m) {
        to.vertex[i] = Copy(v, Projected(placer_.Scaled(model_.positions[v]), normal, *use.tile_m));
      } else {
        if (copies_[v] == kNone) copies_[v] = Copy(v, model_.texcoords[v]);
        to.vertex[i] = copies_[v];
      }
    }
    if (placer_.mirrors()) std::swap(to.vertex[1], to.vertex[2]);
    mesh_.triangles.push_back(to);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t Copy(std::uint32_t v, const Vec2f& texcoord) {
    mesh_.positions.push_back(placer_.World(model_.positions[v]).Cast<float>());
    mesh_.normals.push_back(placer_.WorldNormal(model_.normals[v]).Cast<float>());
    mesh_.texcoords.push_back(texcoord);
    return std::uint32_t(mesh_.positions.size() - 1);
  }

  // Outward, scaled, not of unit length.
  Vec3d FaceNormal(const Triangle& t) const {
    const Vec3d a = placer_.Scaled(model_.positions[t.vertex[0]]);
    const Vec3d b = placer_.Scaled(model_.positions[t.vertex[1]]);
    const Vec3d c = placer_.Scaled(model_.positions[t.vertex[2]]);
    return placer_.mirrors() ? Cross(c - a, b - a) : Cross(b - a, c - a);
  }

  Mesh& mesh_;
  const Mesh& model_;
  Placer placer_;
  std::vector<std::uint32_t> copies_;  // by the model's vertex
};

}  // namespace

void AppendModel(Mesh& mesh, const Model& model, const ModelPlacement& placement,
                 const std::vector<MaterialUse>& uses) {
  SILT_CHECK(uses.size() == model.materials.size());
  ModelAppender appender(mesh, model.mesh, placement);
  for (const Triangle& t : model.mesh.triangles) {
    if (!uses[t.material].dropped) appender.Append(t, uses[t.material]);
  }
}

}  // namespace silt::sim
