// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/pixel_samples.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

namespace {

std::uint32_t Reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// Owen's scrambling of a number whose bits are given in reverse order: each bit is flipped or not
// depending on the bits above it (Laine and Karras 2011, constants of Burley 2020).
std::uint32_t OwenScrambled(std::uint32_t reversed, std::uint32_t seed) {
  std::uint32_t x = reversed + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return Reversed(x);
}

// Of the shortest wave that pixels can tell, two of them long, this Gaussian leaves
// exp(−2π²σ²/4) = 17 %, the box 64 %: frames warped onto each other agree the better for it (silt
// experiment photo-consistency).
constexpr double kSigma = 0.6, kCutoff = 1.8;  // of the Gaussian, in pixels
constexpr int kQuantiles = 1 << 12;

}  // namespace

// By bisection of Φ, to rounding.
double GaussianQuantile(double share) {
  SILT_CHECK(share > 0 && share < 1);
  const auto below = [](double x) { return 0.5 * std::erfc(-x / (kSigma * std::sqrt(2.0))); };
  const double first = below(-kCutoff), all = 1 - 2 * first;
  double low = -kCutoff, high = kCutoff;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (below(middle) - first < share * all ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<PixelSample> SharedSamples(int n, PixelFilter filter) {
  std::vector<PixelSample> samples;
  Vec2d mean;
  const std::vector<Vec2d> places = SquareSamples(n);
  for (int k = 0; k < n; ++k) {
    Vec2d offset = places[std::size_t(k)] - Vec2d{0.5, 0.5};
    if (filter == PixelFilter::kGaussian) {
      const auto quantile = [n](double x) {
        return GaussianQuantile(std::clamp(x + 0.5, 0.5 / n, 1 - 0.5 / n));
      };
      offset = {quantile(offset.x), quantile(offset.y)};
    }
    samples.push_back({offset, (k + 0.5) / n - 0.5});
    mean = mean + 1.0 / n * offset;
  }
  for (PixelSample& sample : samples) sample.offset = sample.offset - mean;
  return samples;
}

ScrambledSamples::ScrambledSamples(int n, PixelFilter filter) : n_(n) {
  SILT_CHECK(n >= 1);
  for (int k = 0; k < n; ++k) {
    reversed_x_.push_back(std::uint32_t(k));  // of the radical inverse
    reversed_y_.push_back(Reversed(Sobol2(std::uint32_t(k))));
  }
  if (filter == PixelFilter::kBox) return;
  for (int i = 0; i < kQuantiles; ++i)
    quantiles_.push_back(GaussianQuantile((i + 0.5) / kQuantiles));
}

ScrambledSamples::Key ScrambledSamples::KeyOf(std::uint64_t seed, std::uint32_t frame,
                                              std::uint32_t pixel) {
  const CounterRandom random(seed, (std::uint64_t(frame) << 32) | pixel);
  const std::uint64_t xy = random.Bits(0);
  return {std::uint32_t(xy), std::uint32_t(xy >> 32), std::uint32_t(random.Bits(1))};
}

double ScrambledSamples::Offset(std::uint32_t bits) const {
  if (quantiles_.empty()) return bits * 0x1p-32 - 0.5;
  return quantiles_[bits >> 20];
}

PixelSample ScrambledSamples::At(int k, const Key& key) const {
  const auto i = std::size_t(k);
  // Time keeps its order, so that rays of neighbours are traced at similar times; within its part
  // of the exposure it is random.
  const std::uint32_t jitter = OwenScrambled(std::uint32_t(k), key.time);
  return {
      {Offset(OwenScrambled(reversed_x_[i], key.x)), Offset(OwenScrambled(reversed_y_[i], key.y))},
      (k + jitter * 0x1p-32) / n_ - 0.5};
}

}  // namespace silt::sim
