// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/light_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/experiments/case_runner.h"

namespace silt::experiments {
namespace {

// A picture of 8-bit steps, made linear.
Image<Vec3f> OfSteps(double steps, double noise = 0, std::uint64_t seed = 0) {
  Image<Vec3f> image(40, 30);
  const CounterRandom random(seed);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const auto value = LinearFromSrgb(float((steps + noise * random.Normal(i)) / 255));
    image.data()[i] = {value, value, value};
  }
  return image;
}

TEST(LightComparison, CountsInStepsOfTheEncodedPicture) {
  const LightDifference d = Compare({OfSteps(130)}, {{{OfSteps(127), OfSteps(127)}}}, 1);
  EXPECT_NEAR(d.mean, 3, 1e-3);
  EXPECT_NEAR(d.percentile_99, 3, 1e-3);
  EXPECT_NEAR(d.bias, 3, 1e-3);
  EXPECT_NEAR(d.rms, 3, 0.1);
  EXPECT_NEAR(d.reference_noise, 0, 1e-3);
  EXPECT_NEAR(RmsDifference({OfSteps(130)}, {OfSteps(127)}, 1), 3, 1e-3);
  EXPECT_NEAR(Compare({OfSteps(250)}, {{{OfSteps(260), OfSteps(260)}}}, 4).mean, 0, 1e-6);  // white
}

// Halves with 4 steps of noise each: the mean of both has 2.8, none of which is blamed on the bake.
TEST(LightComparison, TellsTheReferencesNoiseApart) {
  const LightDifference d =
      Compare({OfSteps(130)}, {{{OfSteps(128, 4, 1), OfSteps(128, 4, 2)}}}, 1);
  EXPECT_NEAR(d.reference_noise, 4 / std::sqrt(2.0), 0.3);
  EXPECT_NEAR(d.rms, 2, 0.3);
  EXPECT_GT(d.mean, 2.2);
}

TEST(LightComparison, DifferencesAreDrawnAboutGray) {
  const Rgb8 pixel = DifferencePicture(OfSteps(130), OfSteps(128), 1)(3, 3);
  EXPECT_NEAR(pixel.r, 128 + 16, 1);
  EXPECT_NEAR(DifferencePicture(OfSteps(100), OfSteps(200), 1)(3, 3).g, 0, 0);
}

// A black board, lower than the middle of the picture by so many pixels, before a white background:
// what it covers of the pixels at its edge is known to half an interval of the grid of places.
TEST(LightComparison, BakedPixelsAreMeansOverTheirSquares) {
  constexpr int width = 64;
  const PinholeCamera camera = IclNuimCameraOfWidth(width);
  for (const float edge : {0.28f, 0.53f, 0.81f}) {
    sim::Scene scene;
    scene.materials.push_back({});
    scene.materials[0].diffuse = {};
    scene.ambient = {1, 1, 1};
    const float y = (edge + 0.5f - float(camera.height % 2) / 2) / float(camera.fy);
    for (const Vec3f& p : {Vec3f{-9, y, 1}, {9, y, 1}, {9, 9, 1}, {-9, 9, 1}}) {
      scene.mesh.positions.push_back(p);
      scene.mesh.normals.push_back({0, 0, -1});
      scene.mesh.texcoords.push_back({});
    }
    scene.mesh.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    sim::LightingOptions coarse;
    coarse.direct_spacing_m = 10;
    const auto lit = std::make_shared<const sim::LitScene>(std::move(scene), coarse);
    const Image<Vec3f> picture = RenderBaked(lit, {"", SE3d{}}, width);
    double white = 0;
    for (int row = 0; row < picture.height(); ++row) white += picture(width / 2, row).x;
    const double expected = camera.cy + 0.5 + double(y) * camera.fy;
    EXPECT_NEAR(white, expected, 0.51 / 32) << edge;
  }
}

TEST(LightComparison, ViewsAreSharedByThePaths) {
  const std::vector<LightView> views = ViewsAlong("office", {"desk", "tour"}, 5);
  ASSERT_EQ(views.size(), 5u);
  EXPECT_EQ(views[0].name, "desk_0");
  EXPECT_EQ(views[4].name, "tour_2");
  EXPECT_THROW(ViewsAlong("office", {"nowhere"}, 2), Error);
}

}  // namespace
}  // namespace silt::experiments
