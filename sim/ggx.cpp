// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/ggx.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "silt/sim/sampling.h"

namespace silt::sim {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kCosines = 32, kRoughnesses = 32, kPoints = 1024;

float Power5(float x) { return x * x * x * x * x; }

GgxAlbedo Integrate(float cosine, float alpha, const std::vector<Vec2d>& points) {
  const Ggx facets(alpha);
  const float c = std::max(cosine, 1e-3f);
  const Vec3f out{std::sqrt(std::max(0.0f, 1 - c * c)), 0, c};
  GgxAlbedo sum{0, 0};
  for (const Vec2d& p : points) {
    const Vec3f half = facets.DrawVisible(out, {float(p.x), float(p.y)});
    const float facing = Dot(out, half);
    const Vec3f in = (2 * facing) * half - out;
    if (in.z <= 0) continue;
    const float share = facets.Shadowing(out, in) / facets.Masking(out);
    const float grazing = Power5(1 - facing);
    sum.scale += share * (1 - grazing);
    sum.offset += share * grazing;
  }
  return {sum.scale / float(points.size()), sum.offset / float(points.size())};
}

// Rows of equal roughness √α; within them, equal steps of the cosine.
struct AlbedoTable {
  GgxAlbedo at[kRoughnesses][kCosines];
  GgxAlbedo mean[kRoughnesses];

  AlbedoTable() {
    const std::vector<Vec2d> points = SquareSamples(kPoints);
    for (int r = 0; r < kRoughnesses; ++r) {
      const float roughness = float(r) / (kRoughnesses - 1);
      GgxAlbedo sum{0, 0};
      for (int c = 0; c < kCosines; ++c) {
        const float cosine = float(c) / (kCosines - 1);
        at[r][c] = Integrate(cosine, roughness * roughness, points);
        const float weight = 2 * cosine / (kCosines - 1) * (c == kCosines - 1 ? 0.5f : 1.0f);
        sum = {sum.scale + weight * at[r][c].scale, sum.offset + weight * at[r][c].offset};
      }
      mean[r] = sum;
    }
  }
};

const AlbedoTable& Table() {
  static const AlbedoTable table;
  return table;
}

struct Place {
  int low;
  float share;  // of low + 1
  Place(float x, int count) {
    const float at = std::clamp(x, 0.0f, 1.0f) * float(count - 1);
    low = std::min(int(at), count - 2);
    share = at - float(low);
  }
};

GgxAlbedo Mix(const GgxAlbedo& a, const GgxAlbedo& b, float share) {
  return {a.scale + share * (b.scale - a.scale), a.offset + share * (b.offset - a.offset)};
}

}  // namespace

Ggx::Ggx(float alpha) : alpha_(std::max(alpha, kSmoothest)) {}

float Ggx::Distribution(const Vec3f& half) const {
  // In terms of the sine, which keeps its digits near the normal.
  const float a2 = alpha_ * alpha_, sine_sq = half.x * half.x + half.y * half.y;
  const float t = half.z * half.z * a2 + sine_sq;
  return half.z > 0 ? a2 / (kPi * t * t) : 0;
}

float Ggx::Lambda(const Vec3f& w) const {
  const float sine_sq = w.x * w.x + w.y * w.y, cosine_sq = w.z * w.z;
  return 0.5f * (std::sqrt(1 + alpha_ * alpha_ * sine_sq / cosine_sq) - 1);
}

Vec3f Ggx::DrawVisible(const Vec3f& out, const Vec2f& random) const {
  // Stretched to a half sphere, whose projection towards `out` is two half discs.
  const Vec3f v = Normalized(Vec3f{alpha_ * out.x, alpha_ * out.y, out.z});
  const float length_sq = v.x * v.x + v.y * v.y;
  const Vec3f t1 =
      length_sq > 0 ? (1 / std::sqrt(length_sq)) * Vec3f{-v.y, v.x, 0} : Vec3f{1, 0, 0};
  const Vec3f t2 = Cross(v, t1);
  const float radius = std::sqrt(random.x), angle = 2 * kPi * random.y;
  const float p1 = radius * std::cos(angle);
  const float share = 0.5f * (1 + v.z);
  const float p2 =
      (1 - share) * std::sqrt(std::max(0.0f, 1 - p1 * p1)) + share * radius * std::sin(angle);
  const float p3 = std::sqrt(std::max(0.0f, 1 - p1 * p1 - p2 * p2));
  const Vec3f h = p1 * t1 + p2 * t2 + p3 * v;
  return Normalized(Vec3f{alpha_ * h.x, alpha_ * h.y, std::max(1e-6f, h.z)});
}

Vec3f Schlick(const Vec3f& at_normal, float cosine) {
  const float grazing = Power5(std::clamp(1 - cosine, 0.0f, 1.0f));
  return (1 - grazing) * at_normal + Vec3f{grazing, grazing, grazing};
}

GgxAlbedo DirectionalAlbedo(float cosine, float alpha) {
  const Place c(cosine, kCosines), r(std::sqrt(alpha), kRoughnesses);
  const auto& rows = Table().at;
  return Mix(Mix(rows[r.low][c.low], rows[r.low][c.low + 1], c.share),
             Mix(rows[r.low + 1][c.low], rows[r.low + 1][c.low + 1], c.share), r.share);
}

GgxAlbedo MeanAlbedo(float alpha) {
  const Place r(std::sqrt(alpha), kRoughnesses);
  return Mix(Table().mean[r.low], Table().mean[r.low + 1], r.share);
}

}  // namespace silt::sim
