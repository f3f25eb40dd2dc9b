// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

struct HandShakeOptions {
  double position_mm = 0;   // root mean square length of the displacement
  double rotation_deg = 0;  // root mean square angle
  double low_hz = 0.5;      // the band: 0 < low < high
  double high_hz = 8;
  std::uint64_t seed = 0;

  // Throws silt::Error, one line that names the offending value.
  void Validate() const;
};

// The unrest of a hand: band-limited noise, a pure and infinitely smooth function of time. Each of
// the six axes is a sum of kSines sinusoids with seeded phases and frequencies, one drawn from each
// of kSines bands that are even in log f. Its power spectral density falls as 1/f² between low_hz
// and high_hz (velocity is white there) and is zero elsewhere. The axes are independent and have
// equal power.
class HandShake {
 public:
  static constexpr int kSines = 24;

  HandShake() = default;  // a steady hand
  explicit HandShake(const HandShakeOptions& options);

  // Displacement in world coordinates, in metres.
  template <typename T>
  Vec3<T> Displacement(const T& time_s) const {
    return Sum(0, time_s);
  }
  // Rotation vector about the camera's own axes, in radians.
  template <typename T>
  Vec3<T> Rotation(const T& time_s) const {
    return Sum(3, time_s);
  }

 private:
  struct Sine {
    double amplitude, rate_rad_s, phase;
  };

  // The axes `first` to `first` + 2.
  template <typename T>
  Vec3<T> Sum(int first, const T& time_s) const {
    using std::sin;
    if (sines_.empty()) return {T(0.0), T(0.0), T(0.0)};
    T axis[3] = {T(0.0), T(0.0), T(0.0)};
    for (int i = 0; i < 3 * kSines; ++i) {
      const Sine& s = sines_[first * kSines + i];
      const T angle = T(s.rate_rad_s) * time_s + T(s.phase);
      axis[i / kSines] = axis[i / kSines] + T(s.amplitude) * sin(angle);
    }
    return {axis[0], axis[1], axis[2]};
  }

  std::vector<Sine> sines_;  // kSines for each axis: three of displacement, three of rotation
};

}  // namespace silt::sim
