// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/hand_shake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <functional>
#include <numbers>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr HandShakeOptions kShake{.position_mm = 2, .rotation_deg = 0.3, .seed = 5};

// Mean over so many seconds that the slowest sine turns hundreds of times.
double MeanSquare(const std::function<Vec3d(double)>& f) {
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Vec3d v = f(0.053 * i);
    sum += Dot(v, v);
  }
  return sum / n;
}

TEST(HandShake, HasTheRootMeanSquareThatIsAskedFor) {
  const HandShake shake(kShake);
  EXPECT_NEAR(std::sqrt(MeanSquare([&](double t) { return shake.Displacement(t); })), 2e-3, 2e-5);
  const double rotation = std::sqrt(MeanSquare([&](double t) { return shake.Rotation(t); }));
  EXPECT_NEAR(rotation * 180 / std::numbers::pi, 0.3, 3e-3);
}

// Power of each axis of a shake in octaves from low_hz up, and (last) outside of the whole band:
// from Fourier coefficients over 64 s.
std::vector<double> OctavePowers(const std::function<Vec3d(double)>& shake, double low_hz,
                                 int octaves) {
  const double duration_s = 64, step_s = 1 / 40.0;
  const int samples = int(duration_s / step_s);
  std::vector<Vec3d> values;
  for (int i = 0; i < samples; ++i) values.push_back(shake(i * step_s));
  std::vector<double> power(std::size_t(octaves) + 1);
  for (int k = 1; k < samples / 2; ++k) {
    const double hz = k / duration_s;
    const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * hz * step_s);
    std::complex<double> phase = 1, x = 0, y = 0, z = 0;
    for (const Vec3d& v : values) {
      x += v.x * phase;
      y += v.y * phase;
      z += v.z * phase;
      phase *= turn;
    }
    const double octave = std::floor(std::log2(hz / low_hz));
    const bool inside = octave >= 0 && octave < octaves;
    power[std::size_t(inside ? int(octave) : octaves)] +=
        2 * (std::norm(x) + std::norm(y) + std::norm(z)) / (double(samples) * samples);
  }
  return power;
}

// A density of 1/f² has half the power in each octave that it has in the one below. Averaged over
// seeds, since 6 sines an octave are few; both for displacements and rotations.
TEST(HandShake, SpectrumFallsWithTheSquareOfFrequencyWithinItsBand) {
  constexpr int kOctaves = 4, kSeeds = 12;
  std::vector<double> power(kOctaves + 1);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const HandShake shake({.position_mm = 1,
                           .rotation_deg = 0.1,
                           .low_hz = 0.5,
                           .high_hz = 8,
                           .seed = std::uint64_t(seed)});
    const bool turns = seed % 2 == 1;
    const std::vector<double> one = OctavePowers(
        [&](double t) { return turns ? shake.Rotation(t) : shake.Displacement(t); }, 0.5, kOctaves);
    const double rms = turns ? 0.1 * std::numbers::pi / 180 : 1e-3;
    for (std::size_t i = 0; i < one.size(); ++i) power[i] += one[i] / (rms * rms * kSeeds);
  }
  EXPECT_NEAR(power[0], 8.0 / 15, 0.02);
  EXPECT_NEAR(power[1], 4.0 / 15, 0.02);
  EXPECT_NEAR(power[2], 2.0 / 15, 0.01);
  EXPECT_NEAR(power[3], 1.0 / 15, 0.01);
  EXPECT_LT(power[kOctaves], 0.03);  // what the window of 64 s smears over the edges
}

TEST(HandShake, IsAPureFunctionOfSeedAndTime) {
  const HandShake a(kShake), b(kShake);
  HandShakeOptions other = kShake;
  other.seed = 6;
  for (const double t : {0.0, 1.5, 29.0, 1.5}) {
    EXPECT_EQ(a.Displacement(t).x, b.Displacement(t).x);
    EXPECT_EQ(a.Rotation(t).z, b.Rotation(t).z);
    EXPECT_NE(a.Displacement(t).x, HandShake(other).Displacement(t).x);
  }
}

TEST(HandShake, AxesAreIndependent) {
  const HandShake shake(kShake);
  const double xy = MeanSquare([&](double t) {
    const Vec3d d = shake.Displacement(t);
    return Vec3d{d.x + d.y, 0, 0};
  });
  EXPECT_NEAR(xy, 2 * 4e-6 / 3, 0.02 * 4e-6);
}

TEST(HandShake, ASteadyHandDoesNotMove) {
  EXPECT_EQ(Norm(HandShake().Displacement(1.0)), 0);
  EXPECT_EQ(Norm(HandShake(HandShakeOptions{}).Rotation(1.0)), 0);
}

TEST(HandShake, RefusesOptionsOutOfRange) {
  const auto refuses = [](HandShakeOptions options, const std::string& name) {
    try {
      HandShake{options};
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
  };
  refuses({.position_mm = -1}, "position_mm");
  refuses({.rotation_deg = std::nan("")}, "rotation_deg");
  refuses({.low_hz = 0}, "low_hz");
  refuses({.low_hz = 5, .high_hz = 5}, "low_hz");
  refuses({.high_hz = 1e9}, "high_hz");
}

}  // namespace
}  // namespace silt::sim
