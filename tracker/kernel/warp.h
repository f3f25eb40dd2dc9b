// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/core/vector.h"
#include "silt/tracker/kernel/scalar.h"

namespace silt::tracker::kernel {

// Depths are measurements in this open interval, in metres.
inline constexpr float kMinDepth = 0.0f, kMaxDepth = 1e6f;
// A point nearer to the current camera's plane than this is taken to be behind it, in metres.
inline constexpr float kMinPointZ = 1e-3f;

// A pose and a camera, as the warp needs them.
template <typename T>
struct Warp {
  Mat3<T> rotation;  // R_cr
  Vec3<T> translation;
  Pinhole<T> camera;
  T inverse_fx, inverse_fy;

  Warp() = default;
  SILT_HOST_DEVICE Warp(const SE3<T>& current_from_reference, const Pinhole<T>& pinhole)
      : rotation(current_from_reference.rotation.Matrix()),
        translation(current_from_reference.translation),
        camera(pinhole),
        inverse_fx(T(1) / pinhole.fx),
        inverse_fy(T(1) / pinhole.fy) {}

  // The same for another scalar: a double's values for float kernels, a float in every lane.
  template <typename U>
  SILT_HOST_DEVICE explicit Warp(const Warp<U>& other)
      : rotation(other.rotation.template Cast<T>()),
        translation(other.translation.template Cast<T>()),
        camera(other.camera.template Cast<T>()),
        inverse_fx(T(other.inverse_fx)),
        inverse_fy(T(other.inverse_fy)) {}
};

// A pixel of the keyframe.
template <typename T>
struct ReferencePixel {
  T u, v, depth_m, intensity;
};

template <typename T>
struct WarpedPixel {
  Vec3<T> point;  // p1, in the current camera, in metres
  T inverse_z;
  T u, v;         // in the current image; of no meaning where not visible
  Mask<T> front;  // there is a depth, and the point lies in front of the current camera
};

// Eq. 11 and Algorithm 2: W(μ) = K·π(T_cr·D_r(μ)·K⁻¹·μ̂).
template <typename T>
SILT_HOST_DEVICE inline WarpedPixel<T> WarpPixel(const Warp<T>& warp,
                                                 const ReferencePixel<T>& pixel) {
  const T x = (pixel.u - warp.camera.cx) * warp.inverse_fx;
  const T y = (pixel.v - warp.camera.cy) * warp.inverse_fy;
  const Vec3<T>* r = warp.rotation.row;
  // R·(x, y, 1), in an order whose second part is the same along a row.
  const Vec3<T> direction{r[0].x * x + (r[0].y * y + r[0].z), r[1].x * x + (r[1].y * y + r[1].z),
                          r[2].x * x + (r[2].y * y + r[2].z)};
  const Mask<T> measured = pixel.depth_m > T(kMinDepth) && pixel.depth_m < T(kMaxDepth);
  const T depth = Select(measured, pixel.depth_m, T(1));
  const Vec3<T> point = depth * direction + warp.translation;
  const Mask<T> front = measured && point.z > T(kMinPointZ) && point.z < T(kMaxDepth);
  const T inverse_z = T(1) / Select(front, point.z, T(1));
  return {point, inverse_z, warp.camera.fx * (point.x * inverse_z) + warp.camera.cx,
          warp.camera.fy * (point.y * inverse_z) + warp.camera.cy, front};
}

}  // namespace silt::tracker::kernel
