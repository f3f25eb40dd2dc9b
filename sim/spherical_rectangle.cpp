// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace silt::sim {

namespace {

// Of a smaller one, differences of angles are too rough.
constexpr double kSmallest = 1e-5;
constexpr double kEdgeOn = 1e-6;  // metres between viewpoint and plane

// Angle at the corner between two faces of the pyramid over the rectangle.
double InnerAngle(const Vec3d& face, const Vec3d& next) {
  return std::acos(std::clamp(-Dot(face, next), -1.0, 1.0));
}

}  // namespace

bool SphericalRectangle::IsPossible(const RectLight& r) {
  return std::abs(Dot(r.half_u, r.half_v)) <= 1e-4f * Norm(r.half_u) * Norm(r.half_v);
}

SphericalRectangle::SphericalRectangle(const RectLight& r, const Vec3f& viewpoint) {
  const Vec3d u = r.half_u.Cast<double>(), v = r.half_v.Cast<double>();
  const double half_x = Norm(u), half_y = Norm(v);
  x_ = Normalized(u);
  y_ = Normalized(v);
  z_ = Cross(x_, y_);
  const Vec3d way = r.center.Cast<double>() - viewpoint.Cast<double>();
  z0_ = Dot(way, z_);
  if (z0_ > 0) z_ = -z_, z0_ = -z0_;
  x0_ = Dot(way, x_) - half_x, x1_ = Dot(way, x_) + half_x;
  y0_ = Dot(way, y_) - half_y, y1_ = Dot(way, y_) + half_y;
  if (z0_ > -kEdgeOn) return;
  // The pyramid's faces through the sides y0, x1, y1, x0.
  const Vec3d n0 = Normalized(Vec3d{0, z0_, -y0_}), n1 = Normalized(Vec3d{-z0_, 0, x1_}),
              n2 = Normalized(Vec3d{0, -z0_, y1_}), n3 = Normalized(Vec3d{z0_, 0, -x0_});
  b0_ = n0.z, b1_ = n2.z;
  k_ = 2 * std::numbers::pi - InnerAngle(n2, n3) - InnerAngle(n3, n0);
  const double solid_angle = InnerAngle(n0, n1) + InnerAngle(n1, n2) - k_;
  if (solid_angle >= kSmallest) solid_angle_ = solid_angle;
}

Vec3f SphericalRectangle::WayTo(const Vec2f& square) const {
  // The share of the area to the left gives x, then y evenly in the sine of its height.
  const double angle = double(square.x) * solid_angle_ + k_;
  const double f = (std::cos(angle) * b0_ - b1_) / std::sin(angle);
  const double cosine = std::clamp((f > 0 ? 1 : -1) / std::sqrt(f * f + b0_ * b0_), -1.0, 1.0);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 1e-24));
  const double x = std::clamp(-cosine * z0_ / sine, x0_, x1_);
  const double d_sq = x * x + z0_ * z0_;
  const double h0 = y0_ / std::sqrt(d_sq + y0_ * y0_), h1 = y1_ / std::sqrt(d_sq + y1_ * y1_);
  const double h = h0 + double(square.y) * (h1 - h0);
  const double y =
      std::clamp(h * std::sqrt(d_sq) / std::sqrt(std::max(1 - h * h, 1e-12)), y0_, y1_);
  return (x * x_ + y * y_ + z0_ * z_).Cast<float>();
}

}  // namespace silt::sim
