// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/sim/ray_tracer.h"
#include "silt/sim/spherical_rectangle.h"
#include "silt/sim/surface_colors.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

namespace {

double Luminance(const Vec3f& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

Vec3f CrossEdges(const Mesh& mesh, std::uint32_t triangle) {
  const std::uint32_t* v = mesh.triangles[triangle].vertex;
  const Vec3f& a = mesh.positions[v[0]];
  return Cross(mesh.positions[v[1]] - a, mesh.positions[v[2]] - a);
}

}  // namespace

Emitters::Emitters(const Scene& scene)
    : scene_(scene), of_triangle_(scene.mesh.triangles.size(), -1) {
  const std::vector<int> light_of = LightOfTriangle(scene);
  std::vector<int> of_material(scene.materials.size(), -1), of_light(scene.lights.size(), -1);
  for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const std::uint32_t material = scene.mesh.triangles[i].material;
    if (Luminance(scene.materials[material].emission) <= 0) continue;
    const int light = light_of[i];
    int& number = light >= 0 ? of_light[std::size_t(light)] : of_material[material];
    if (number < 0) {
      number = int(emitters_.size());
      emitters_.emplace_back();
      if (light >= 0 && SphericalRectangle::IsPossible(scene.lights[std::size_t(light)])) {
        emitters_.back().rectangle = &scene.lights[std::size_t(light)];
      }
    }
    of_triangle_[i] = number;
    AddTriangle(emitters_[std::size_t(number)], i);
  }
  for (Emitter& emitter : emitters_) Finish(emitter);
  if (scene.environment) {
    background_ = std::numbers::pi * Luminance(scene.environment->mean());
  }
}

void Emitters::AddTriangle(Emitter& emitter, std::uint32_t triangle) const {
  const std::uint32_t* v = scene_.mesh.triangles[triangle].vertex;
  const std::vector<Vec3f>& p = scene_.mesh.positions;
  const Vec3f twice = CrossEdges(scene_.mesh, triangle);
  const float area = 0.5f * Norm(twice);
  emitter.area += area;
  emitter.center += (area / 3) * (p[v[0]] + p[v[1]] + p[v[2]]);
  emitter.normal += 0.5f * twice;
  emitter.triangles.push_back(triangle);
  emitter.area_up_to.push_back(emitter.area);
}

void Emitters::Finish(Emitter& emitter) const {
  const Material& material =
      scene_.materials[scene_.mesh.triangles[emitter.triangles.front()].material];
  double luminance = Luminance(material.emission);
  if (material.texture >= 0) {
    const Texture& texture = scene_.textures[std::size_t(material.texture)];
    luminance *= Luminance(texture.Sample(0, 0, float(texture.level_count())));
  }
  if (!(emitter.area > 0)) return;
  emitter.power = std::max(luminance, 1e-6) * emitter.area;
  emitter.center = float(1 / emitter.area) * emitter.center;
  const float flatness = Norm(emitter.normal) / float(emitter.area);
  emitter.one_sided_plane = flatness > 0.999f && !material.two_sided;
  if (flatness > 0) emitter.normal = Normalized(emitter.normal);
}

// What a patch of the emitter's power would send from its middle, generous where that is only an
// estimate: a part of it may face the receiver though its middle does not.
double Emitters::Weight(std::size_t index, const Receiver& at) const {
  if (index == emitters_.size()) return background_;
  const Emitter& emitter = emitters_[index];
  const Vec3f way = emitter.center - at.position;
  const double distance_sq = Dot(way, way), distance = std::sqrt(distance_sq) + 1e-6;
  const double up = Dot(way, at.normal) / distance;
  const double facing = emitter.one_sided_plane ? -Dot(way, emitter.normal) / distance : 1;
  if (emitter.one_sided_plane && facing <= 0) return 0;  // behind its plane
  const double size_sq = emitter.area / (distance_sq + emitter.area);
  return emitter.power * (std::max(up, 0.0) + 0.3 * size_sq + 0.01) * (facing + 0.05) /
         (distance_sq + emitter.area);
}

double Emitters::TotalWeight(const Receiver& at) const {
  double sum = 0;
  for (std::size_t i = 0; i <= emitters_.size(); ++i) sum += Weight(i, at);
  return sum;
}

double Emitters::Chance(std::size_t emitter, const Receiver& at) const {
  const double weight = Weight(emitter, at);
  if (!(weight > 0)) return 0;
  return at.aims_at_each ? 1 : weight / TotalWeight(at);
}

Emitters::Sample Emitters::Draw(const Receiver& at, float choice, const Vec2f& random) const {
  const double total = TotalWeight(at);
  if (!(total > 0)) return {};
  double rest = choice * total;
  std::size_t chosen = 0;
  double weight = Weight(0, at);
  while (chosen < emitters_.size() && rest >= weight) {
    rest -= weight;
    weight = Weight(++chosen, at);
  }
  if (!(weight > 0)) return {};
  Sample sample = DrawFrom(chosen, at, float(std::clamp(rest / weight, 0.0, 1.0)), random);
  sample.density *= float(weight / total);
  return sample;
}

Emitters::Sample Emitters::DrawFrom(std::size_t emitter, const Receiver& at, float choice,
                                    const Vec2f& random) const {
  if (!(Weight(emitter, at) > 0)) return {};
  if (emitter == emitters_.size()) {
    const Environment::Sample drawn = scene_.environment->Draw(random);
    return {drawn.direction, 1e30f, drawn.radiance, drawn.density};
  }
  return emitters_[emitter].rectangle ? DrawFromRectangle(emitters_[emitter], at, random)
                                      : DrawFromTriangles(emitters_[emitter], at, choice, random);
}

Emitters::Sample Emitters::DrawFromRectangle(const Emitter& emitter, const Receiver& at,
                                             const Vec2f& random) const {
  const RectLight& light = *emitter.rectangle;
  const SphericalRectangle seen(light, at.position);
  const bool is_small = !(seen.solid_angle() > 0);
  const Vec3f way = is_small ? light.center - at.position + (2 * random.x - 1) * light.half_u +
                                   (2 * random.y - 1) * light.half_v
                             : seen.WayTo(random);
  const float distance = Norm(way);
  if (!(distance > 0)) return {};
  const Vec3f direction = (1 / distance) * way;
  const float cosine = -Dot(direction, emitter.normal);
  if (!(cosine > 1e-6f)) return {};
  const double density =
      is_small ? distance * distance / (cosine * emitter.area) : 1 / seen.solid_angle();
  return {direction, distance, light.radiance, float(density)};
}

Emitters::Sample Emitters::DrawFromTriangles(const Emitter& emitter, const Receiver& at,
                                             float choice, const Vec2f& random) const {
  const std::vector<double>& sums = emitter.area_up_to;
  const auto found = std::upper_bound(sums.begin(), sums.end() - 1, choice * emitter.area);
  const std::uint32_t number = emitter.triangles[std::size_t(found - sums.begin())];
  const float root = std::sqrt(random.x);
  const float u = root * (1 - random.y), v = root * random.y;
  const Triangle& triangle = scene_.mesh.triangles[number];
  const std::vector<Vec3f>& p = scene_.mesh.positions;
  const Vec3f point =
      (1 - u - v) * p[triangle.vertex[0]] + u * p[triangle.vertex[1]] + v * p[triangle.vertex[2]];
  const Vec3f way = point - at.position;
  const float distance = Norm(way);
  if (!(distance > 0)) return {};
  const Vec3f direction = (1 / distance) * way;
  const float cosine = -Dot(direction, Normalized(CrossEdges(scene_.mesh, number)));
  const Material& material = scene_.materials[triangle.material];
  if (!(std::abs(cosine) > 1e-6f) || (cosine < 0 && !material.two_sided)) return {};
  Vec3f radiance = material.emission;
  if (material.texture >= 0) {
    const Vec2f uv = TexcoordAt(scene_.mesh, triangle, u, v);
    radiance = radiance * scene_.textures[std::size_t(material.texture)].Sample(uv.x, uv.y, 0);
  }
  const float density = distance * distance / (std::abs(cosine) * float(emitter.area));
  return {direction, distance, radiance, density};
}

float Emitters::Density(const Receiver& from, const Met& met) const {
  const int index = of_triangle_[met.triangle];
  if (index < 0) return 0;
  const double chance = Chance(std::size_t(index), from);
  if (!(chance > 0)) return 0;
  const Emitter& emitter = emitters_[std::size_t(index)];
  if (emitter.rectangle) {
    const double solid_angle = SphericalRectangle(*emitter.rectangle, from.position).solid_angle();
    if (solid_angle > 0) return float(chance / solid_angle);
  }
  const double cosine = std::max(std::abs(met.cosine), 1e-6f);
  return float(chance * met.distance * met.distance / (cosine * emitter.area));
}

float Emitters::BackgroundDensity(const Receiver& from, const Vec3f& direction) const {
  if (!scene_.environment || !(background_ > 0)) return 0;
  return float(Chance(emitters_.size(), from)) * scene_.environment->Density(direction);
}

}  // namespace silt::sim
