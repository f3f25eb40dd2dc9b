// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/direct_light.h"

#include <algorithm>
#include <array>
#include <vector>

#include "silt/core/image.h"
#include "silt/sim/form_factor.h"

namespace silt::sim {

namespace {

// A shadow ray ends this much before the light, which is part of the mesh.
constexpr float kShadowEnd = 1 - 1e-3f;
// An irradiance below which half as many points do: that of a lamp, not of a sky.
constexpr float kFaint = 2;

}  // namespace

struct DirectLight::View {
  const RectLight& light;
  Vec3f facing;  // u × v
  Vec3f origin, normal;

  Vec3f WayTo(float s, float t) const {
    return light.center + s * light.half_u + t * light.half_v - origin;
  }
};

namespace {

// Points of a light that a packet of shadow rays goes to, and what each of them counts.
struct ShadowPacket {
  RayPacket rays;
  std::array<float, kPacketSize> weight{};

  template <typename View>
  void Set(int lane, const View& view, float s, float t) {
    const Vec3f way = view.WayTo(s, t);
    const float cosines = Dot(way, view.normal) * -Dot(way, view.facing), r_sq = Dot(way, way);
    if (!(Dot(way, view.normal) > 0 && cosines > 0)) return;
    weight[std::size_t(lane)] = cosines / (r_sq * r_sq);
    rays.Set(lane, {view.origin, way, 0, kShadowEnd});
  }
};

// The middle of interval i of n in [−1, 1].
float Middle(int i, int n) { return (2 * float(i) + 1) / float(n) - 1; }

}  // namespace

DirectLight::DirectLight(const Scene& scene, const RayTracer& tracer, int points)
    : scene_(scene), tracer_(tracer), points_(points) {}

Vec3f DirectLight::Irradiance(const Vec3f& position, const Vec3f& unit_normal) const {
  Vec3f sum;
  for (const RectLight& light : scene_.lights) {
    const auto open =
        float(RectangleFormFactor(light, position.Cast<double>(), unit_normal.Cast<double>()));
    if (!(open > 0)) continue;
    const View view{light, Cross(light.half_u, light.half_v), position + kRayOffsetM * unit_normal,
                    unit_normal};
    const Vec3f most = open * light.radiance;
    const bool faint = std::max({most.x, most.y, most.z}) < kFaint;
    sum += Visibility(view, faint ? std::max(points_ / 2, 1) : points_) * most;
  }
  return sum;
}

float DirectLight::HiddenShare(const View& view, int points, const Vec2<int>& cell) const {
  ShadowPacket packet;
  for (int i = 0; i < kEdge * kEdge; ++i) {
    packet.Set(i, view, Middle(cell.x * kEdge + i % kEdge, points * kEdge),
               Middle(cell.y * kEdge + i / kEdge, points * kEdge));
  }
  const std::uint32_t occluded = tracer_.Occluded(packet.rays);
  float sum = 0, hidden = 0;
  for (int i = 0; i < kEdge * kEdge; ++i) {
    sum += packet.weight[std::size_t(i)];
    if (occluded >> i & 1) hidden += packet.weight[std::size_t(i)];
  }
  return sum > 0 ? hidden / sum : 0;
}

float DirectLight::Visibility(const View& view, int points) const {
  const int cells = points * points;
  std::vector<float> weight(std::size_t(cells), 0.0f);
  Image<char> hidden(points, points);
  for (int first = 0; first < cells; first += kPacketSize) {
    ShadowPacket packet;
    const int count = std::min(kPacketSize, cells - first);
    for (int i = 0; i < count; ++i) {
      const int x = (first + i) % points, y = (first + i) / points;
      packet.Set(i, view, Middle(x, points), Middle(y, points));
    }
    const std::uint32_t occluded = tracer_.Occluded(packet.rays);
    for (int i = 0; i < count; ++i) {
      weight[std::size_t(first + i)] = packet.weight[std::size_t(i)];
      hidden.data()[first + i] = char(occluded >> i & 1);
    }
  }
  const auto differs = [&](int x, int y, int mine) {
    return hidden.Contains(x, y) && hidden(x, y) != mine;
  };
  double total = 0, dark = 0;
  for (int i = 0; i < cells; ++i) {
    const int x = i % points, y = i / points, mine = hidden(x, y);
    const bool edge = differs(x - 1, y, mine) || differs(x + 1, y, mine) ||
                      differs(x, y - 1, mine) || differs(x, y + 1, mine);
    const double share = edge ? HiddenShare(view, points, {x, y}) : mine;
    total += weight[std::size_t(i)];
    dark += share * weight[std::size_t(i)];
  }
  // Exactly 1 where nothing hides it.
  return total > 0 ? float(1 - dark / total) : 0;
}

}  // namespace silt::sim
