// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

constexpr double kPi = std::numbers::pi;

// A gray gradient with one lamp, 16 × 8 texels.
Environment SkyWithLamp(double yaw_rad = 0) {
  Image<Vec3f> picture(16, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float gray = 0.2f + 0.05f * float(y) + 0.01f * float(x);
      picture(x, y) = {gray, gray, 2 * gray};
    }
  }
  picture(12, 2) = {80, 60, 40};
  return Environment(picture, yaw_rad);
}

Vec3d UniformDirection(const CounterRandom& random, std::uint64_t i) {
  const double z = 1 - 2 * random.Uniform(2 * i), around = 2 * kPi * random.Uniform(2 * i + 1);
  const double ring = std::sqrt(1 - z * z);
  return {ring * std::cos(around), ring * std::sin(around), z};
}

TEST(Environment, TheAxesLieWhereTheHeaderSays) {
  const auto at = [](const Vec3d& d) { return EquirectangularFromDirection(d); };
  EXPECT_NEAR(at({0, 5, 0}).x, 0.5, 1e-12);
  EXPECT_NEAR(at({2, 0, 0}).x, 0.75, 1e-12);
  EXPECT_NEAR(at({-2, 0, 0}).x, 0.25, 1e-12);
  EXPECT_NEAR(at({1, 1, 0}).y, 0.5, 1e-12);
  EXPECT_NEAR(at({0, 0, 3}).y, 0, 1e-12);
  EXPECT_NEAR(at({0, 0, -3}).y, 1, 1e-12);
  const CounterRandom random(1);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Vec3d d = UniformDirection(random, i);
    EXPECT_NEAR(Norm(DirectionFromEquirectangular(at(d)) - d), 0, 1e-12);
  }
}

TEST(Environment, IsThePictureAtTheCentresOfItsTexels) {
  const Environment environment = SkyWithLamp();
  for (const auto& [x, y] : {std::pair{12, 2}, {0, 0}, {15, 7}, {3, 5}}) {
    const Vec3d d = DirectionFromEquirectangular({(x + 0.5) / 16, (y + 0.5) / 8});
    const Vec3f radiance = environment.Radiance((3.0 * d).Cast<float>());
    EXPECT_NEAR(radiance.x, environment.picture()(x, y).x, 1e-3f) << x << ' ' << y;
  }
}

// A quarter turn counter-clockwise takes what lay ahead (+y) to the left (−x).
TEST(Environment, YawTurnsIt) {
  const Environment straight = SkyWithLamp(), turned = SkyWithLamp(kPi / 2);
  const CounterRandom random(2);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Vec3f d = UniformDirection(random, i).Cast<float>();
    EXPECT_NEAR(turned.Radiance({-d.y, d.x, d.z}).x, straight.Radiance(d).x, 1e-3f);
    EXPECT_EQ(turned.Density({-d.y, d.x, d.z}) > 0, true);
  }
}

TEST(Environment, TheDensityIntegratesToOneAndIsThatOfTheDraws) {
  const Environment environment = SkyWithLamp(0.3);
  const CounterRandom random(3);
  constexpr int n = 200'000;
  double integral = 0, drawn_up = 0, density_up = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const Vec3d d = UniformDirection(random, i);
    const double density = 4 * kPi * environment.Density(d.Cast<float>()) / n;
    integral += density;
    if (d.x > 0) density_up += density;
    const Environment::Sample s = environment.Draw(
        {float(random.Uniform(2 * i + 2 * n)), float(random.Uniform(2 * i + 1 + 2 * n))});
    drawn_up += s.direction.x > 0 ? 1.0 / n : 0;
    if (i >= 1000) continue;
    EXPECT_FLOAT_EQ(s.density, environment.Density(s.direction));
    EXPECT_NEAR(s.radiance.x, environment.Radiance(s.direction).x, 1e-2f);
  }
  EXPECT_NEAR(integral, 1, 0.02);
  EXPECT_NEAR(drawn_up, density_up, 0.02);
}

// Irradiance on a slope by importance and by uniform sampling: 4 standard errors of the latter.
TEST(Environment, ImportanceSamplingAgreesWithUniform) {
  const Environment environment = SkyWithLamp();
  const Vec3d normal = Normalized(Vec3d{0.4, -0.2, 0.8});
  const CounterRandom random(4);
  constexpr int n = 200'000;
  double uniform = 0, square = 0, important = 0, important_square = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const Vec3d d = UniformDirection(random, i);
    const double a =
        4 * kPi * std::max(0.0, Dot(d, normal)) * environment.Radiance(d.Cast<float>()).x;
    uniform += a / n;
    square += a * a / n;
    const Environment::Sample s = environment.Draw(
        {float(random.Uniform(2 * i + 2 * n)), float(random.Uniform(2 * i + 1 + 2 * n))});
    const double b =
        std::max(0.0, Dot(s.direction.Cast<double>(), normal)) * s.radiance.x / s.density;
    important += b / n;
    important_square += b * b / n;
  }
  const double sigma = std::sqrt((square - uniform * uniform) / n);
  EXPECT_NEAR(important, uniform, 4 * sigma);
  EXPECT_LT(important_square - important * important, 0.2 * (square - uniform * uniform));
}

TEST(Environment, BlackHasNothingToDraw) {
  const Environment black(Image<Vec3f>(4, 2));
  EXPECT_EQ(black.Draw({0.5f, 0.5f}).density, 0);
  EXPECT_EQ(black.Density({0, 0, 1}), 0);
  EXPECT_EQ(black.mean().x, 0);
}

TEST(Environment, ASkyRunsFromTheGroundToTheZenith) {
  const Environment sky = MakeSky({{1, 2, 3}, {10, 10, 10}, {0.5, 0, 0}});
  EXPECT_NEAR(sky.Radiance({0, 0, 1}).z, 3, 0.01f);
  EXPECT_NEAR(sky.Radiance({1, 0, 0.1f}).z, 8, 0.5f);
  EXPECT_NEAR(sky.Radiance({0, -1, -0.2f}).x, 0.5f, 1e-5f);
  EXPECT_NEAR(sky.mean().x, 0.5 * (0.5 + 10 - 9 * 2 / 3.0), 0.01);  // ∫√c dc = 2/3
}

// Radiance's run-length free form: one texel (r, g, b, e) is (r, g, b)·2^(e − 136).
TEST(Environment, ReadsRadiancePictures) {
  const TempFolder folder;
  const auto file = folder.path() / "sky.hdr";
  std::ofstream out(file, std::ios::binary);
  out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  for (const unsigned byte : {128u, 64u, 32u, 131u, 0u, 0u, 0u, 0u}) out.put(char(byte));
  out.close();
  const Environment environment = LoadEnvironment(file, 2, 0);
  ASSERT_EQ(environment.picture().width(), 2);
  EXPECT_NEAR(environment.picture()(0, 0).x, 8, 0.05);  // 2 · 128 · 2⁻⁵
  EXPECT_NEAR(environment.picture()(0, 0).z, 2, 0.05);
  EXPECT_EQ(environment.picture()(1, 0).y, 0);
}

TEST(Environment, RefusesWhatIsNoPicture) {
  const TempFolder folder;
  const auto file = folder.path() / "sky.hdr";
  EXPECT_THROW(LoadEnvironment(file, 1, 0), Error);
  std::ofstream(file) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000 +X 2000\nshort";
  EXPECT_THROW(LoadEnvironment(file, 1, 0), Error);
}

}  // namespace
}  // namespace silt::sim
