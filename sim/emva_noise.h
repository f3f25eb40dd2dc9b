// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/noise_key.h"

namespace silt::sim {

// The linear camera of the EMVA standard 1288, release 3.1 (sections 2 to 4): μ_p photons reach a
// pixel, each becomes an electron with probability η, an amplifier makes K digital numbers (DN) of
// an electron, and a converter rounds them:
//   μ_e = η·μ_p,   μ_y = K·(μ_e + μ_d) + black,   σ_y² = K²·(σ_d0² + μ_d + μ_e) + 1/12,
// with dark electrons μ_d = dark current × exposure time; electrons are Poisson distributed. Fixed
// over the frames, a pixel's sensitivity differs by PRNU·N(0, 1) and its dark level by DSNU·N(0, 1)
// electrons. Here μ_p = I·photons_at_white for a signal I = radiance × exposure, and the signal
// that comes back is (y − black − K·μ_d) / (y_max − black), black removed as cameras do. Every
// colour is taken for a pixel of its own.
//
// Quantum efficiency, well and read noise default to a Sony IMX174 as Point Grey measured it by the
// standard at 525 nm.
struct EmvaNoise {
  double quantum_efficiency = 0.77;  // η, in (0, 1]
  double full_well_e = 32691;        // saturation capacity μ_e.sat
  double read_noise_e = 6.83;        // σ_d0
  double dark_current_e_per_s = 0;
  double exposure_s = 0.01;     // that dark electrons gather in
  double photons_at_white = 0;  // of a signal of 1; 0: as many as fill the well
  double gain_dn_per_e = 0;     // K; 0: such that a signal of 1, or a full well if less, is y_max
  int bits = 12;                // y_max = 2^bits − 1
  double black_dn = 64;
  double prnu = 0;    // share of the signal
  double dsnu_e = 0;  // electrons

  void Validate() const;  // throws silt::Error

  double PhotonsAtWhite() const;
  double Gain() const;  // K, DN/e-
  double DarkElectrons() const { return dark_current_e_per_s * exposure_s; }
  double MaxDn() const { return double((1 << bits) - 1); }
  // Temporal variance of the signal that comes back for a true one, away from clipping, without
  // fixed patterns.
  double Variance(double signal) const;
};

// Replaces a signal by what such a camera measures of it. A pixel's noise is a function of
// (seed, frame, pixel, channel) alone, its fixed pattern of (seed, pixel, channel).
void AddNoise(const EmvaNoise& model, const NoiseKey& key, Image<Vec3f>& signal);

}  // namespace silt::sim
