// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/host_device.h"

// Small plain vectors and matrices. They carry no Eigen so that the same source serves float,
// double, ceres::Jet, SIMD batches and device code; larger algebra belongs to Eigen.
namespace silt {

template <typename T>
struct Vec2 {
  T x{}, y{};
};

template <typename T>
struct Vec3 {
  T x{}, y{}, z{};

  template <typename U>
  SILT_HOST_DEVICE constexpr Vec3<U> Cast() const {
    return {U(x), U(y), U(z)};
  }
};

using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;
using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;

template <typename T>
SILT_HOST_DEVICE constexpr Vec2<T> operator+(const Vec2<T>& a, const Vec2<T>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec2<T> operator-(const Vec2<T>& a, const Vec2<T>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec2<T> operator*(const T& s, const Vec2<T>& a) {
  return {s * a.x, s * a.y};
}

template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T>& operator+=(Vec3<T>& a, const Vec3<T>& b) {
  return a = a + b;
}
// Component by component: colours times albedo.
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator*(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <typename T>
SILT_HOST_DEVICE constexpr T Dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> Cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T>
SILT_HOST_DEVICE T Norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(Dot(a, a));
}
// A vector of length zero has no direction: the result is then not finite.
template <typename T>
SILT_HOST_DEVICE Vec3<T> Normalized(const Vec3<T>& a) {
  return (T(1) / Norm(a)) * a;
}

// 3×3, row by row.
template <typename T>
struct Mat3 {
  Vec3<T> row[3];

  template <typename U>
  SILT_HOST_DEVICE constexpr Mat3<U> Cast() const {
    return {{row[0].template Cast<U>(), row[1].template Cast<U>(), row[2].template Cast<U>()}};
  }
};

using Mat3d = Mat3<double>;

template <typename T>
SILT_HOST_DEVICE constexpr Vec3<T> operator*(const Mat3<T>& m, const Vec3<T>& v) {
  return {Dot(m.row[0], v), Dot(m.row[1], v), Dot(m.row[2], v)};
}
template <typename T>
SILT_HOST_DEVICE constexpr Mat3<T> Transposed(const Mat3<T>& m) {
  return {{{m.row[0].x, m.row[1].x, m.row[2].x},
           {m.row[0].y, m.row[1].y, m.row[2].y},
           {m.row[0].z, m.row[1].z, m.row[2].z}}};
}
template <typename T>
SILT_HOST_DEVICE constexpr Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b) {
  const Mat3<T> bt = Transposed(b);
  return {{bt * a.row[0], bt * a.row[1], bt * a.row[2]}};
}

}  // namespace silt
