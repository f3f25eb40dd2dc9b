// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "silt/core/image.h"
#include "silt/sim/form_factor.h"

namespace silt::sim {

namespace {

// An irradiance below which half as many points do: that of a lamp, not of a sky.
constexpr float kFaint = 2;
// Of the way from a light's border to the middle of a cell, where a rim is looked for first.
constexpr float kBorder = 0.02f;
constexpr int kHalvings = 7;

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
    // The light is part of the mesh.
    rays.Set(lane, {view.origin, way, 0, 1 - kRayOffsetM / std::sqrt(r_sq)});
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

Image<float> DirectLight::RimShares(const View& view, const Image<char>& hidden) const {
  const int points = hidden.width();
  Image<float> shares(points, points, 0.0f);
  for (int first = 0; first < 4 * points; first += kPacketSize) {
    // A lane for each place of the border, and the depth to which it is hidden, of the way from the
    // border to the middle of the cell: within (visible, …] nothing hides it.
    const int count = std::min(kPacketSize, 4 * points - first);
    Vec2<int> cell[kPacketSize];
    float low[kPacketSize] = {}, high[kPacketSize];
    bool is_rim[kPacketSize];
    for (int i = 0; i < count; ++i) {
      const int side = (first + i) / points, along = (first + i) % points;
      const int across = side % 2 == 0 ? 0 : points - 1;
      cell[i] = side < 2 ? Vec2<int>{across, along} : Vec2<int>{along, across};
      is_rim[i] = !hidden(cell[i].x, cell[i].y);
      high[i] = 2 * kBorder;  // so that the first look is at the border
    }
    for (int halving = 0; halving <= kHalvings; ++halving) {
      ShadowPacket packet;
      for (int i = 0; i < count; ++i) {
        if (!is_rim[i]) continue;
        const int side = (first + i) / points;
        const float border = side % 2 == 0 ? -1.0f : 1.0f, depth = 0.5f * (low[i] + high[i]);
        Vec2f at{Middle(cell[i].x, points), Middle(cell[i].y, points)};
        float& across = side < 2 ? at.x : at.y;
        across = border + depth * (across - border);
        packet.Set(i, view, at.x, at.y);
      }
      const std::uint32_t occluded = tracer_.Occluded(packet.rays);
      for (int i = 0; i < count; ++i) {
        const bool is_hidden = occluded >> i & 1;
        if (halving == 0) {
          is_rim[i] = is_rim[i] && is_hidden;
          low[i] = 0, high[i] = 1;
        } else {
          (is_hidden ? low[i] : high[i]) = 0.5f * (low[i] + high[i]);
        }
      }
      if (std::none_of(is_rim, is_rim + count, [](bool rim) { return rim; })) break;
    }
    for (int i = 0; i < count; ++i) {
      if (!is_rim[i]) continue;
      float& share = shares(cell[i].x, cell[i].y);  // corners have two borders
      const float half = 0.25f * (low[i] + high[i]);
      share += half - share * half;
    }
  }
  return shares;
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
  const Image<float> rims = RimShares(view, hidden);
  double total = 0, dark = 0;
  for (int i = 0; i < cells; ++i) {
    const int x = i % points, y = i / points, mine = hidden(x, y);
    const bool edge = differs(x - 1, y, mine) || differs(x + 1, y, mine) ||
                      differs(x, y - 1, mine) || differs(x, y + 1, mine);
    const double share = edge ? HiddenShare(view, points, {x, y}) : mine + rims(x, y);
    total += weight[std::size_t(i)];
    dark += share * weight[std::size_t(i)];
  }
  // Exactly 1 where nothing hides it.
  return total > 0 ? float(1 - dark / total) : 0;
}

}  // namespace silt::sim
