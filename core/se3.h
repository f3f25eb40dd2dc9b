// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/vector.h"

// Rotations and rigid motions, named target_from_source so that products visibly cancel:
//   world_from_camera = world_from_keyframe * keyframe_from_camera.
// Twists are ξ = (ω, v), updates are applied on the left: T ← exp(ξ)·T (Díaz et al., eqs. 4–7).
namespace silt {

namespace se3_detail {

// Σ_k (−θ²)^k / (2k + n)!, the entire function behind sin θ/θ (n = 1), (1 − cos θ)/θ² (n = 2) and
// (θ − sin θ)/θ³ (n = 3). Ten terms are exact to rounding for θ² ≤ 1, and, unlike the closed
// forms, have no cancellation and a finite derivative at θ = 0, which automatic differentiation
// needs.
template <typename T>
SILT_HOST_DEVICE T TrigSeries(const T& theta_sq, int n) {
  T sum(0.0);
  for (int k = 9; k >= 0; --k) {
    sum = T(1.0) - theta_sq / T(double(2 * k + n + 1) * double(2 * k + n + 2)) * sum;
  }
  double factorial = 1.0;
  for (int i = 2; i <= n; ++i) factorial *= i;
  return sum / T(factorial);
}

}  // namespace se3_detail

// Unit quaternion, Hamilton's convention, as in TUM files up to the order of the components.
template <typename T>
struct Quaternion {
  T w{1}, x{0}, y{0}, z{0};

  SILT_HOST_DEVICE Vec3<T> vec() const { return {x, y, z}; }
  SILT_HOST_DEVICE Quaternion Conjugate() const { return {w, -x, -y, -z}; }

  SILT_HOST_DEVICE Quaternion Normalized() const {
    using std::sqrt;
    const T s = T(1.0) / sqrt(w * w + x * x + y * y + z * z);
    return {s * w, s * x, s * y, s * z};
  }

  SILT_HOST_DEVICE Mat3<T> Matrix() const {
    const T two(2.0), one(1.0);
    return {{{one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)},
             {two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)},
             {two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)}}};
  }

  // Rotation by |ω| radians about ω.
  SILT_HOST_DEVICE static Quaternion Exp(const Vec3<T>& omega) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T theta_sq = Dot(omega, omega);
    const T quarter = theta_sq / T(4.0);
    if (quarter < T(1.0)) {
      const T s = se3_detail::TrigSeries(quarter, 1) / T(2.0);
      const T c = T(1.0) - quarter * se3_detail::TrigSeries(quarter, 2);
      return {c, s * omega.x, s * omega.y, s * omega.z};
    }
    const T theta = sqrt(theta_sq);
    const T s = sin(theta / T(2.0)) / theta;
    return {cos(theta / T(2.0)), s * omega.x, s * omega.y, s * omega.z};
  }

  // The ω of smallest norm with Exp(ω) = ±q; |ω| ≤ π.
  SILT_HOST_DEVICE Vec3<T> Log() const {
    using std::atan2;
    using std::sqrt;
    const T n_sq = Dot(vec(), vec());
    const T sign = w < T(0.0) ? T(-1.0) : T(1.0);
    if (n_sq < T(1e-4)) {
      // θ/sin(θ/2) = 2·asin(n)/n, as a series in n².
      const T s = T(2.0) *
                  (T(1.0) + n_sq / T(6.0) *
                                (T(1.0) + n_sq * T(9.0 / 20.0) * (T(1.0) + n_sq * T(25.0 / 42.0))));
      return (sign * s) * vec();
    }
    const T n = sqrt(n_sq);
    return (T(2.0) * atan2(n, sign * w) / n * sign) * vec();
  }
};

template <typename T>
SILT_HOST_DEVICE Quaternion<T> operator*(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

// q·v·q⁻¹ for a unit quaternion.
template <typename T>
SILT_HOST_DEVICE Vec3<T> operator*(const Quaternion<T>& q, const Vec3<T>& v) {
  const Vec3<T> u = T(2.0) * Cross(q.vec(), v);
  return v + q.w * u + Cross(q.vec(), u);
}

// Nearest unit quaternion to a rotation matrix (w ≥ 0), by Shepperd's stable choice of pivot.
SILT_HOST_DEVICE inline Quaternion<double> QuaternionFromMatrix(const Mat3d& m) {
  const double xx = m.row[0].x, yy = m.row[1].y, zz = m.row[2].z;
  const double yz = m.row[2].y - m.row[1].z, zx = m.row[0].z - m.row[2].x,
               xy = m.row[1].x - m.row[0].y;
  const double sxy = m.row[0].y + m.row[1].x, sxz = m.row[0].z + m.row[2].x,
               syz = m.row[1].z + m.row[2].y;
  const double w4 = 1 + xx + yy + zz, x4 = 1 + xx - yy - zz, y4 = 1 - xx + yy - zz,
               z4 = 1 - xx - yy + zz;
  Quaternion<double> q{w4, yz, zx, xy};
  if (x4 > w4 && x4 >= y4 && x4 >= z4) {
    q = {yz, x4, sxy, sxz};
  } else if (y4 > w4 && y4 >= z4) {
    q = {zx, sxy, y4, syz};
  } else if (z4 > w4) {
    q = {xy, sxz, syz, z4};
  }
  if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
  return q.Normalized();
}

// ξ = (ω, v): ω in radians, v in metres (the translation seen through the exponential map).
template <typename T>
struct Twist {
  Vec3<T> omega, v;
};

template <typename T>
SILT_HOST_DEVICE Twist<T> operator*(const T& s, const Twist<T>& a) {
  return {s * a.omega, s * a.v};
}

// A rigid motion: p_target = rotation·p_source + translation, in metres.
template <typename T>
struct SE3 {
  Quaternion<T> rotation;
  Vec3<T> translation;

  SILT_HOST_DEVICE SE3 Inverse() const {
    const Quaternion<T> r = rotation.Conjugate();
    return {r, -(r * translation)};
  }

  template <typename U>
  SILT_HOST_DEVICE SE3<U> Cast() const {
    return {{U(rotation.w), U(rotation.x), U(rotation.y), U(rotation.z)},
            translation.template Cast<U>()};
  }

  // exp([ξ]ₓ), eq. 4: rotation exp(ω), translation V(ω)·v with
  // V = I + (1 − cos θ)/θ²·[ω]ₓ + (θ − sin θ)/θ³·[ω]ₓ².
  SILT_HOST_DEVICE static SE3 Exp(const Twist<T>& xi) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T theta_sq = Dot(xi.omega, xi.omega);
    T b, c;
    if (theta_sq < T(1.0)) {
      b = se3_detail::TrigSeries(theta_sq, 2);
      c = se3_detail::TrigSeries(theta_sq, 3);
    } else {
      const T theta = sqrt(theta_sq);
      b = (T(1.0) - cos(theta)) / theta_sq;
      c = (theta - sin(theta)) / (theta_sq * theta);
    }
    const Vec3<T> wv = Cross(xi.omega, xi.v);
    return {Quaternion<T>::Exp(xi.omega), xi.v + b * wv + c * Cross(xi.omega, wv)};
  }

  // The inverse of Exp for rotations below π: v = V⁻¹·t with
  // V⁻¹ = I − ½[ω]ₓ + k·[ω]ₓ², k = (1 − (θ/2)·cot(θ/2))/θ².
  SILT_HOST_DEVICE Twist<T> Log() const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Vec3<T> omega = rotation.Log();
    const T theta_sq = Dot(omega, omega);
    T k;
    if (theta_sq < T(0.25)) {
      const T s = theta_sq;
      k = T(1.0 / 12) +
          s * (T(1.0 / 720) + s * (T(1.0 / 30240) + s * (T(1.0 / 1209600) +
                                                         s * (T(1.0 / 47900160) +
                                                              s * (T(691.0 / 1307674368000.0) +
                                                                   s * T(1.0 / 74724249600.0))))));
    } else {
      const T half = sqrt(theta_sq) / T(2.0);
      k = (T(1.0) - half * cos(half) / sin(half)) / theta_sq;
    }
    const Vec3<T> wt = Cross(omega, translation);
    return {omega, translation - T(0.5) * wt + k * Cross(omega, wt)};
  }
};

using Quaterniond = Quaternion<double>;
using Twistd = Twist<double>;
using SE3d = SE3<double>;

template <typename T>
SILT_HOST_DEVICE SE3<T> operator*(const SE3<T>& a, const SE3<T>& b) {
  return {(a.rotation * b.rotation).Normalized(), a.rotation * b.translation + a.translation};
}
template <typename T>
SILT_HOST_DEVICE Vec3<T> operator*(const SE3<T>& a, const Vec3<T>& p) {
  return a.rotation * p + a.translation;
}

// Angle of the rotation, in radians, in [0, π].
SILT_HOST_DEVICE inline double RotationAngle(const Quaterniond& q) { return Norm(q.Log()); }

}  // namespace silt
