// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sampling.h"

#include <cmath>
#include <numbers>

#include "silt/core/error.h"

namespace silt::sim {

namespace {

// Radical inverse in base 2 (van der Corput).
double ReversedBits(std::uint32_t k) {
  double value = 0, digit = 0.5;
  for (; k != 0; k >>= 1, digit /= 2) value += (k & 1) * digit;
  return value;
}

}  // namespace

// Direction numbers v ← v ⊕ v/2.
std::uint32_t Sobol2(std::uint32_t k) {
  std::uint32_t direction = 0x80000000u, bits = 0;
  for (; k != 0; k >>= 1, direction ^= direction >> 1) {
    if (k & 1) bits ^= direction;
  }
  return bits;
}

std::vector<Vec2d> SquareSamples(int n) {
  SILT_CHECK(n >= 1);
  std::vector<Vec2d> points;
  Vec2d mean;
  for (int k = 0; k < n; ++k) {
    // The order of x is scrambled so that neither coordinate follows k, which may stand for time.
    const auto scrambled = std::uint32_t(n >= 4 ? k ^ 3 : k);
    points.push_back({ReversedBits(scrambled), Sobol2(std::uint32_t(k)) * 0x1p-32});
    mean = mean + 1.0 / n * points.back();
  }
  for (Vec2d& p : points) p = p - mean + Vec2d{0.5, 0.5};
  return points;
}

std::vector<Vec3f> CosineDirections(int n) {
  std::vector<Vec3f> directions;
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < n; ++k) {
    // Uniform on the disc by Vogel's spiral, lifted to the hemisphere (Malley).
    const double radius_sq = (k + 0.5) / n;
    const double radius = std::sqrt(radius_sq), angle = k * golden_angle;
    directions.push_back(
        Vec3d{radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - radius_sq)}
            .Cast<float>());
  }
  return directions;
}

TangentFrame::TangentFrame(const Vec3f& n) : normal(n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1 / (sign + n.z);
  const float b = n.x * n.y * a;
  tangent = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  bitangent = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace silt::sim
