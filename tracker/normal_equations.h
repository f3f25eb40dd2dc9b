// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "silt/core/host_device.h"
#include "silt/tracker/residual_norm.h"

namespace silt::tracker {

// Cost over the pixels that a pose lets both images see. Intensities are in [0, 1].
struct PhotometricCost {
  double sum = 0;           // ½ Σ r², the paper's cost (eq. 8), or Σρ of another norm
  std::int64_t pixels = 0;  // how many residuals there are
  double squares = 0;       // Σ r², whatever the norm

  // The cost by which poses are compared: a sum also falls by losing pixels.
  SILT_HOST_DEVICE double mean() const { return pixels > 0 ? sum / double(pixels) : 0; }
  SILT_HOST_DEVICE double mean_square() const { return pixels > 0 ? squares / double(pixels) : 0; }
  bool operator==(const PhotometricCost&) const = default;

  SILT_HOST_DEVICE PhotometricCost& operator+=(const PhotometricCost& other) {
    sum += other.sum;
    pixels += other.pixels;
    squares += other.squares;
    return *this;
  }
};

// Whether pictures are more alike at one pose than at another, by the mean r² of what they share.
SILT_HOST_DEVICE inline bool IsMoreAlike(const PhotometricCost& at,
                                         const PhotometricCost& at_other) {
  return at.pixels > 0 && (at_other.pixels == 0 || at.mean_square() < at_other.mean_square());
}

// Sums over pixels for eq. 17; parameters in the order ξ = (ω, v). With a norm that is not ½r²,
// each pixel has its weight.
struct NormalEquations {
  std::array<double, 21> hessian{};  // JᵀJ, its upper triangle row by row
  std::array<double, 6> gradient{};  // Jᵀr
  // Σg·gᵀ over stripes of the image, g being a stripe's part of the gradient; its upper triangle.
  // It tells how far residuals that lie beside each other err together. Zeros of a backend whose
  // sums are of no stripes.
  std::array<double, 21> scatter{};
  PhotometricCost cost;
  // Of a robust norm, for the scale of either kind of residuals: Σs·r² and their number.
  struct Spread {
    double squares = 0;
    std::int64_t count = 0;
    bool operator==(const Spread&) const = default;
    SILT_HOST_DEVICE Spread& operator+=(const Spread& other) {
      squares += other.squares;
      count += other.count;
      return *this;
    }
  };
  Spread intensity, inverse_depth;
  // Of one reference: what fits its residuals better than the norm's, where that is asked for.
  Brightness brightness;
  bool operator==(const NormalEquations&) const = default;

  SILT_HOST_DEVICE NormalEquations& operator+=(const NormalEquations& other) {
    for (std::size_t i = 0; i < hessian.size(); ++i) hessian[i] += other.hessian[i];
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += other.gradient[i];
    for (std::size_t i = 0; i < scatter.size(); ++i) scatter[i] += other.scatter[i];
    cost += other.cost;
    intensity += other.intensity;
    inverse_depth += other.inverse_depth;
    return *this;
  }
};

}  // namespace silt::tracker
