// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "silt/core/vector.h"
#include "silt/tracker/kernel/bilinear.h"
#include "silt/tracker/kernel/scalar.h"
#include "silt/tracker/kernel/warp.h"

namespace silt::tracker::kernel {

// The first of the four pixels around W, and W's distance to it.
template <typename T>
struct ImagePoint {
  T x, y;  // the first that can be taken where W is not in view
  T a, b;  // in [0, 1); a is NaN where W is not in view, which makes the sample invalid
};

template <typename T>
SILT_HOST_DEVICE inline ImagePoint<T> Locate(const WarpedPixel<T>& warped, int width, int height,
                                             int margin = 0) {
  using std::floor;
  const T first(margin);
  const Mask<T> in_view = warped.front && warped.u >= first && warped.v >= first &&
                          warped.u < T(width - 1 - margin) && warped.v < T(height - 1 - margin);
  const T u = Select(in_view, warped.u, first);
  const T v = Select(in_view, warped.v, first);
  const T x = floor(u);
  const T y = floor(v);
  return {x, y, Select(in_view, u - x, T(std::numeric_limits<float>::quiet_NaN())), v - y};
}

// The current image at a warped pixel.
template <typename T>
struct WarpedSample {
  Sample<T> sample;  // I_c(W) and ∇I_c(W)
  Mask<T> valid;     // in front, and all pixels around W inside the image and not NaN
};

template <typename T, typename AnyTaps>
SILT_HOST_DEVICE inline WarpedSample<T> SampleAt(const ImagePoint<T>& point, const AnyTaps& taps) {
  const Sample<T> sample = Interpolate(taps, point.a, point.b);
  return {sample, sample.value == sample.value};
}

template <typename T, typename Sampler>
SILT_HOST_DEVICE inline WarpedSample<T> SampleCurrent(const WarpedPixel<T>& warped,
                                                      const Sampler& sampler) {
  constexpr int margin = decltype(sampler(warped.u, warped.v))::kMargin;
  const ImagePoint<T> point = Locate(warped, sampler.width, sampler.height, margin);
  return SampleAt(point, sampler(point.x, point.y));
}

// r = I_c(W) − I_r (eq. 12) and its derivative by ξ = (ω, v) of exp(ξ)·T_cr at ξ = 0; zeros where
// not valid.
template <typename T>
struct LinearizedResidual {
  T residual;
  T jacobian[6];
  T gradient_squared;  // |∇I_c(W)|²
  Mask<T> valid;
};

// The image must hold at least 2×2 pixels.
template <typename T, typename Sampler>
SILT_HOST_DEVICE inline T Residual(const Warp<T>& warp, const Sampler& sampler,
                                   const ReferencePixel<T>& pixel, Mask<T>* valid) {
  const WarpedSample<T> current = SampleCurrent(WarpPixel(warp, pixel), sampler);
  *valid = current.valid;
  return Select(current.valid, current.sample.value - pixel.intensity, T(0));
}

// The derivative of f(W(μ)) + h(Z) where ∇f(W) is that of `current`, and h'(Z) is `slope_z`, Z
// being the warped point's. Eqs. 13–16: ∇f(W)·∂π/∂X(K·p1)·K·[−[p1]ₓ | I]. With (a, b) = (fx·∂f/∂u,
// fy·∂f/∂v) the part by v is j = (a, b, −(a·X + b·Y)/Z)/Z + (0, 0, h'(Z)), and that by ω is
// −jᵀ[p1]ₓ = (p1 × j)ᵀ.
template <typename T>
SILT_HOST_DEVICE inline LinearizedResidual<T> LinearizeAlongWarp(const Warp<T>& warp,
                                                                 const WarpedPixel<T>& warped,
                                                                 const WarpedSample<T>& current,
                                                                 const T& residual,
                                                                 const T& slope_z) {
  const Mask<T> valid = current.valid;
  const T zero(0);
  const Vec3<T>& p = warped.point;
  const T du = Select(valid, current.sample.du, zero), dv = Select(valid, current.sample.dv, zero);
  const T a = warp.camera.fx * du * warped.inverse_z;
  const T b = warp.camera.fy * dv * warped.inverse_z;
  const Vec3<T> point{Select(valid, p.x, zero), Select(valid, p.y, zero), Select(valid, p.z, zero)};
  const Vec3<T> j{a, b,
                  Select(valid, slope_z, zero) - (a * point.x + b * point.y) * warped.inverse_z};
  const Vec3<T> w = Cross(point, j);
  return {Select(valid, residual, zero), {w.x, w.y, w.z, j.x, j.y, j.z}, du * du + dv * dv, valid};
}

// Of the intensity: eq. 12.
template <typename T>
SILT_HOST_DEVICE inline LinearizedResidual<T> LinearizeIntensity(const Warp<T>& warp,
                                                                 const WarpedPixel<T>& warped,
                                                                 const WarpedSample<T>& current,
                                                                 const T& intensity) {
  return LinearizeAlongWarp(warp, warped, current, current.sample.value - intensity, T(0));
}

template <typename T, typename Sampler>
SILT_HOST_DEVICE inline LinearizedResidual<T> LinearizeIntensity(const Warp<T>& warp,
                                                                 const WarpedPixel<T>& warped,
                                                                 const Sampler& sampler,
                                                                 const T& intensity) {
  return LinearizeIntensity(warp, warped, SampleCurrent(warped, sampler), intensity);
}

// Of the inverse depth: r = 1/Z_c(W) − 1/Z, sampled from an image of 1/Z_c, over which bilinear
// interpolation is exact for planes.
template <typename T>
SILT_HOST_DEVICE inline LinearizedResidual<T> LinearizeInverseDepth(
    const Warp<T>& warp, const WarpedPixel<T>& warped, const WarpedSample<T>& current) {
  return LinearizeAlongWarp(warp, warped, current, current.sample.value - warped.inverse_z,
                            warped.inverse_z * warped.inverse_z);
}

template <typename T, typename Sampler>
SILT_HOST_DEVICE inline LinearizedResidual<T> LinearizeInverseDepth(const Warp<T>& warp,
                                                                    const WarpedPixel<T>& warped,
                                                                    const Sampler& sampler) {
  return LinearizeInverseDepth(warp, warped, SampleCurrent(warped, sampler));
}

template <typename T, typename Sampler>
SILT_HOST_DEVICE inline LinearizedResidual<T> Linearize(const Warp<T>& warp, const Sampler& sampler,
                                                        const ReferencePixel<T>& pixel) {
  return LinearizeIntensity(warp, WarpPixel(warp, pixel), sampler, pixel.intensity);
}

}  // namespace silt::tracker::kernel
