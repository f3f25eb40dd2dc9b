// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "silt/core/random.h"
#include "silt/sim/ggx.h"

namespace silt::sim {
namespace {

constexpr double kPi = std::numbers::pi;

Vec3f Slanted(double cosine, double around = 0.4) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return Vec3d{sine * std::cos(around), sine * std::sin(around), cosine}.Cast<float>();
}

Material Metal(float roughness) {
  Material material;
  material.metallic = 1;
  material.roughness = roughness;
  return material;
}

Material Varnish(float roughness) {
  Material material;
  material.specular = 0.04f;
  material.roughness = roughness;
  return material;
}

// ∫ D G₂ F / (4 cos θ_o) dω by the midpoint rule over half vectors, whose density the integrand
// follows, in double and with its own formulas: dω_i = 4 (o·h) dω_h.
double QuadratureAlbedo(double cosine, double alpha, double f0) {
  const double sine = std::sqrt(1 - cosine * cosine), a2 = alpha * alpha;
  const auto lambda = [&](double c) {
    return 0.5 * (std::sqrt(1 + a2 * (1 - c * c) / (c * c)) - 1);
  };
  constexpr int rings = 1500, spokes = 512;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double t = (i + 0.5) / rings;  // share of the slopes' distribution within
    const double tan_sq = a2 * t / (1 - t), hz = 1 / std::sqrt(1 + tan_sq);
    const double hr = std::sqrt(1 - hz * hz);
    for (int j = 0; j < spokes; ++j) {
      const double hx = hr * std::cos(2 * kPi * (j + 0.5) / spokes);
      const double facing = sine * hx + cosine * hz;
      const double in_z = 2 * facing * hz - cosine;
      if (facing <= 0 || in_z <= 0) continue;
      const double fresnel = f0 + (1 - f0) * std::pow(1 - facing, 5);
      // D h_z dω_h = dt dφ / 2π
      sum += fresnel * facing / (hz * cosine * (1 + lambda(cosine) + lambda(in_z)));
    }
  }
  return sum / (double(rings) * spokes);
}

// Mean weight of the Bsdf's own samples: the reflectance of a white sky.
double SampledAlbedo(const Bsdf& bsdf, const Vec3f& out, int samples) {
  const CounterRandom random(1);
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const auto k = std::uint64_t(3 * i);
    const Vec2f point{float(random.Uniform(k)), float(random.Uniform(k + 1))};
    sum += bsdf.Draw(out, float(random.Uniform(k + 2)), point).weight.x / samples;
  }
  return sum;
}

TEST(Ggx, TheTableIsTheQuadratureOfTheFormulas) {
  for (const double roughness : {0.1, 0.3, 0.55, 0.8, 1.0}) {
    for (const double cosine : {0.1, 0.35, 0.7, 1.0}) {
      const double alpha = roughness * roughness;
      const GgxAlbedo albedo = DirectionalAlbedo(float(cosine), float(alpha));
      EXPECT_NEAR(albedo.scale + albedo.offset, QuadratureAlbedo(cosine, alpha, 1), 5e-3)
          << roughness << ' ' << cosine;
      EXPECT_NEAR(0.04 * albedo.scale + albedo.offset, QuadratureAlbedo(cosine, alpha, 0.04), 3e-3)
          << roughness << ' ' << cosine;
    }
  }
}

TEST(Ggx, ASmoothMetalLosesNothingAndARoughOneDoes) {
  EXPECT_NEAR(DirectionalAlbedo(0.8f, 1e-4f).Of({1, 1, 1}).x, 1, 1e-3);
  EXPECT_LT(DirectionalAlbedo(0.8f, 1).Of({1, 1, 1}).x, 0.75f);
}

// The white furnace: 0.5 %.
TEST(Bsdf, AMetalReflectsTheIntegratedAlbedo) {
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    for (const double cosine : {0.2, 0.6, 0.95}) {
      const Bsdf bsdf(Metal(roughness), {0.9f, 0.5f, 0.1f}, true);
      const double expected = QuadratureAlbedo(cosine, double(roughness) * roughness, 0.9);
      EXPECT_NEAR(SampledAlbedo(bsdf, Slanted(cosine), 200'000) / expected, 1, 5e-3)
          << roughness << ' ' << cosine;
    }
  }
}

TEST(Bsdf, VarnishOnWhiteReflectsAllLight) {
  for (const float roughness : {0.2f, 0.6f}) {
    for (const double cosine : {0.2, 0.6, 0.95}) {
      const Bsdf bsdf(Varnish(roughness), {1, 1, 1}, true);
      EXPECT_NEAR(SampledAlbedo(bsdf, Slanted(cosine), 400'000), 1, 5e-3)
          << roughness << ' ' << cosine;
    }
  }
}

TEST(Bsdf, MattAndMirrorReflectTheirColour) {
  Material mirror;
  mirror.mirror = true;
  const Vec3f color{0.7f, 0.5f, 0.3f};
  const Vec3f out = Slanted(0.5);
  const Bsdf::Sample reflected = Bsdf(mirror, color, true).Draw(out, 0.5f, {0.3f, 0.6f});
  EXPECT_TRUE(reflected.mirrored);
  EXPECT_NEAR(Norm(reflected.in - Vec3f{-out.x, -out.y, out.z}), 0, 1e-6);
  EXPECT_EQ(reflected.weight.z, 0.3f);
  // Matt by nature, or where reflection is off.
  for (const Bsdf& matt : {Bsdf(Material{}, color, true), Bsdf(mirror, color, false)}) {
    EXPECT_EQ(matt.Draw(out, 0.5f, {0.3f, 0.6f}).weight.y, 0.5f);
    EXPECT_NEAR(matt.Evaluate(out, {0, 0, 1}).x, 0.7 / kPi, 1e-6);
    EXPECT_EQ(matt.Evaluate(out, {0, 0.6f, -0.8f}).x, 0);
  }
}

TEST(Bsdf, IsReciprocal) {
  for (const Material& material : {Metal(0.4f), Varnish(0.3f), Material{}}) {
    const Bsdf bsdf(material, {0.8f, 0.6f, 0.4f}, true);
    const Vec3f a = Slanted(0.3, 0.1), b = Slanted(0.8, 2);
    EXPECT_NEAR(bsdf.Evaluate(a, b).x / b.z, bsdf.Evaluate(b, a).x / a.z, 1e-4);
  }
}

// Draw, Density and Evaluate tell of the same distribution: ∫ density = 1 less what falls below the
// surface, and directions drawn into a cone are as many as the density says.
TEST(Bsdf, TheDensityIsThatOfTheDraws) {
  for (const Material& material : {Metal(0.5f), Varnish(0.4f)}) {
    const Bsdf bsdf(material, {0.6f, 0.6f, 0.6f}, true);
    const Vec3f out = Slanted(0.6), axis = Slanted(0.7, 0.4 + kPi);
    const CounterRandom random(2);
    double drawn = 0, integrated = 0;
    constexpr int n = 200'000;
    for (int i = 0; i < n; ++i) {
      const auto k = std::uint64_t(5 * i);
      const Bsdf::Sample s =
          bsdf.Draw(out, float(random.Uniform(k)),
                    {float(random.Uniform(k + 1)), float(random.Uniform(k + 2))});
      if (s.density > 0) {
        EXPECT_NEAR(s.density / bsdf.Density(out, s.in), 1, 1e-5);
        if (Dot(s.in, axis) > 0.9f) drawn += 1.0 / n;
      }
      const Vec3f in = Slanted(random.Uniform(k + 3), 2 * kPi * random.Uniform(k + 4));
      if (Dot(in, axis) > 0.9f) integrated += 2 * kPi * bsdf.Density(out, in) / n;
    }
    EXPECT_NEAR(drawn / integrated, 1, 0.03);
  }
}

TEST(Bsdf, GrazingAndTurnedAwayViewersGetFiniteLight) {
  for (const Material& material : {Metal(0), Metal(1), Varnish(0.1f)}) {
    const Bsdf bsdf(material, {1, 1, 1}, true);
    for (const Vec3f& out : {Slanted(1e-7), Slanted(1), Normalized(Vec3f{0.5f, 0, -0.1f})}) {
      const Bsdf::Sample s = bsdf.Draw(out, 0, {0.999f, 0.25f});
      EXPECT_TRUE(std::isfinite(s.weight.x) && s.weight.x >= 0 && s.weight.x < 30);
      EXPECT_TRUE(std::isfinite(bsdf.Evaluate(out, Slanted(1e-6)).x));
    }
  }
}

TEST(Bsdf, ItsReflectionIsWhatTheGroundDoesNotSend) {
  const Bsdf bsdf(Varnish(0.3f), {0.5f, 0.5f, 0.5f}, true);
  const Vec3f out = Slanted(0.5);
  const double whole = SampledAlbedo(bsdf, out, 200'000);
  const double coat = SampledAlbedo(bsdf.Reflection(), out, 200'000);
  EXPECT_NEAR(whole, coat + bsdf.GroundAlbedo(out).x, 3e-3);
}

}  // namespace
}  // namespace silt::sim
