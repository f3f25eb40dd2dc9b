// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

// Which pattern a pixel's area and time are covered with. Both are (0, m, 3)-nets of (x, y, time)
// for 2^m samples.
enum class PixelPattern {
  // One for all pixels and frames, centred: what a surface looks like depends on where it falls
  // within a pixel, but neighbours and frames never differ by chance.
  kShared,
  // Of each pixel and frame its own, by Owen's scrambling: what the pattern misses turns into
  // noise.
  kScrambled,
};

// What a sample is weighted with, as a function of its place relative to the pixel's centre: the
// pixel itself, or a Gaussian of σ = 0.6 pixels, cut off at 3σ. Samples are laid where the
// weight is, and count alike.
enum class PixelFilter { kBox, kGaussian };

// One sample of a pixel.
struct PixelSample {
  Vec2d offset;     // in pixels from its centre
  double time = 0;  // in the exposure: in [−½, ½)
};

// The shared pattern of n samples. The means of offsets and times are 0, so that a frame is an
// average about its own pose. Times ascend.
std::vector<PixelSample> SharedSamples(int n, PixelFilter filter);

// Scrambled patterns of n samples.
class ScrambledSamples {
 public:
  ScrambledSamples(int n, PixelFilter filter);

  // Which pattern: by (seed, frame, pixel).
  struct Key {
    std::uint32_t x, y, time;
  };
  static Key KeyOf(std::uint64_t seed, std::uint32_t frame, std::uint32_t pixel);

  // Sample k of [0, n), in the k-th part of the exposure.
  PixelSample At(int k, const Key& key) const;

 private:
  double Offset(std::uint32_t bits) const;

  int n_;
  std::vector<std::uint32_t> reversed_x_, reversed_y_;  // by k: the unscrambled bits, reversed
  std::vector<double> quantiles_;  // of the filter, at the middles of equal parts; empty: a box
};

// The place below which a share of the Gaussian filter lies, in pixels from the centre; share in
// (0, 1).
double GaussianQuantile(double share);

}  // namespace silt::sim
