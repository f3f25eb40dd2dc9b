// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr float kShareOfDistance = 0.25f, kCaution = 1.5f;
constexpr float kRadiusInWidths = 1.5f;
// Light found where things are this near (Ward's harmonic mean) is lent no farther than this share
// of it: not from under a board to what lies beside it.
constexpr float kReachInDistance = 0.5f;
constexpr float kSameNormal = 0.06f;  // 1 − cos of the angle at which the weight is 0: 20°
constexpr float kSheetM = 1e-3f;      // what is so close is one sheet
constexpr float kRidge = 0.02f;       // of the squared radius
constexpr int kBlock = 1024;

template <typename Body>
void ForBlocks(std::size_t n, const Body& body) {
  ParallelFor(int((n + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t first = std::size_t(block) * kBlock;
    for (std::size_t i = first; i < std::min(n, first + kBlock); ++i) body(i);
  });
}

// 1 where both face alike, down to 0; 0 where they lie on different surfaces: one that bends by an
// angle between two points leaves its tangent plane by at most the angle times their distance.
float Likeness(const SurfaceSample& a, const SurfaceSample& b) {
  const Vec3f way = b.position - a.position;
  const float bend = std::max(0.0f, 1 - Dot(a.normal, b.normal));
  if (std::abs(Dot(way, a.normal)) > kSheetM + std::sqrt(2 * bend) * Norm(way)) return 0;
  return std::max(0.0f, 1 - bend / kSameNormal);
}

// Of values at places about a point, the value there of the plane that fits them best, weighted:
// Σ w·(1 − tilt·d)·value / Σ w·(1 − tilt·d) with the ways d to the places and
// tilt = (Σ w·d·dᵀ)⁻¹ Σ w·d. A mean alone errs where all places lie on one side, at a rim.
class LinearFit {
 public:
  void Add(float weight, const Vec3f& way) {
    total_ += weight;
    sum_ += weight * way;
    xx_ += weight * way.x * way.x, yy_ += weight * way.y * way.y, zz_ += weight * way.z * way.z;
    xy_ += weight * way.x * way.y, yz_ += weight * way.y * way.z, zx_ += weight * way.z * way.x;
  }

  // With variance added in all directions, since the places lie in a plane or a line.
  Vec3f Tilt(float variance) const {
    const float ridge = variance * total_;
    const Vec3f a{xx_ + ridge, xy_, zx_}, b{xy_, yy_ + ridge, yz_}, c{zx_, yz_, zz_ + ridge};
    const float determinant = Dot(a, Cross(b, c));
    if (!(determinant > 0)) return {};
    return (1 / determinant) * (sum_.x * Cross(b, c) + sum_.y * Cross(c, a) + sum_.z * Cross(a, b));
  }

 private:
  Vec3f sum_;
  float total_ = 0, xx_ = 0, yy_ = 0, zz_ = 0, xy_ = 0, yz_ = 0, zx_ = 0;
};

}  // namespace

std::vector<float> GatherWidths(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& coarse,
                                const std::vector<float>& leader_distance_m, float finest_m,
                                float widest_m) {
  std::vector<float> widths(samples.size(), finest_m);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t leader = coarse.leader_of[i];
    const float away = Norm(samples[coarse.leaders[leader]].position - samples[i].position);
    const float width = kShareOfDistance * (leader_distance_m[leader] - kCaution * away);
    while (widths[i] * 2 <= std::min(width, widest_m)) widths[i] *= 2;
  }
  return widths;
}

void NarrowBy(const std::vector<Gathered>& near, float finest_m, std::vector<float>& width_m) {
  for (std::size_t i = 0; i < near.size(); ++i) {
    const float most = kShareOfDistance * near[i].distance_m;
    while (width_m[i] > finest_m && width_m[i] > most) width_m[i] /= 2;
  }
}

std::vector<Vec3f> Interpolated(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& clusters, const std::vector<float>& width_m,
                                const std::vector<Gathered>& gathered) {
  std::map<float, std::unique_ptr<SampleNeighbours>> neighbours;
  for (const std::uint32_t leader : clusters.leaders) {
    auto& of_width = neighbours[width_m[leader]];
    if (of_width) continue;
    of_width = std::make_unique<SampleNeighbours>(samples, clusters.leaders,
                                                  kRadiusInWidths * width_m[leader]);
  }
  std::vector<Vec3f> result(samples.size());
  ForBlocks(samples.size(), [&](std::size_t i) {
    const SurfaceSample& mine = samples[i];
    const float radius = kRadiusInWidths * width_m[i];
    const auto for_each = [&](const auto& visit) {
      neighbours.at(width_m[i])->Visit(mine.position, radius, [&](std::uint32_t j, float away_m) {
        const float reach = std::min(radius, kReachInDistance * gathered[j].distance_m);
        if (gathered[j].buried || away_m >= reach) return;
        const SurfaceSample& other = samples[clusters.leaders[j]];
        const float weight = (1 - away_m / reach) * Likeness(mine, other);
        if (weight > 0) visit(weight, other.position - mine.position, gathered[j].irradiance);
      });
    };
    LinearFit fit;
    for_each([&](float weight, const Vec3f& way, const Vec3f&) { fit.Add(weight, way); });
    const Vec3f tilt = fit.Tilt(kRidge * radius * radius);
    Vec3f sum;
    float total = 0;
    for_each([&](float weight, const Vec3f& way, const Vec3f& irradiance) {
      const float share = weight * std::max(0.0f, 1 - Dot(tilt, way));
      sum += share * irradiance;
      total += share;
    });
    const bool alone = !(total > 1e-3f) || gathered[clusters.leader_of[i]].buried;
    result[i] = alone ? gathered[clusters.leader_of[i]].irradiance : (1 / total) * sum;
  });
  return result;
}

void FillBuried(const std::vector<SurfaceSample>& samples, const std::vector<bool>& buried,
                float radius_m, std::vector<Vec3f>& irradiance) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (!buried[i]) open.push_back(i);
  }
  const SampleNeighbours neighbours(samples, open, radius_m);
  const std::vector<Vec3f> before = irradiance;
  ForBlocks(samples.size(), [&](std::size_t i) {
    if (!buried[i]) return;
    Vec3f sum;
    float total = 0;
    neighbours.Visit(samples[i].position, radius_m, [&](std::uint32_t j, float away_m) {
      const float closeness = 1 / (away_m + 1e-4f);
      const float weight =
          closeness * closeness * closeness * closeness * Likeness(samples[i], samples[open[j]]);
      sum += weight * before[open[j]];
      total += weight;
    });
    if (total > 0) irradiance[i] = (1 / total) * sum;
  });
}

}  // namespace silt::sim
