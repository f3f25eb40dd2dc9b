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

// Power of one axis in a band of frequencies, from Fourier coefficients over T = 200 s.
double BandPower(const HandShake& shake, double low_hz, double high_hz) {
  const double duration_s = 200, step_s = 0.02;
  std::vector<double> samples;
  for (double t = 0; t < duration_s; t += step_s) samples.push_back(shake.Displacement(t).x);
  double power = 0;
  for (double hz = low_hz; hz < high_hz; hz += 1 / duration_s) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      sum += samples[i] * std::polar(1.0, -2 * std::numbers::pi * hz * step_s * double(i));
    }
    power += 2 * std::norm(sum * step_s / duration_s);
  }
  return power;
}

// ∫ 1/f² df over [0.5, 1] is 8/15 of that over [0.5, 8]; the sines' random frequencies blur the
// edge.
TEST(HandShake, StaysInItsBandAndFallsWithTheSquareOfFrequency) {
  const HandShake shake({.position_mm = 1, .low_hz = 0.5, .high_hz = 8, .seed = 2});
  const double per_axis = 1e-6 / 3;
  EXPECT_LT(BandPower(shake, 0.05, 0.45), 0.01 * per_axis);
  EXPECT_NEAR(BandPower(shake, 0.45, 1), 8.0 / 15 * per_axis, 0.1 * per_axis);
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
