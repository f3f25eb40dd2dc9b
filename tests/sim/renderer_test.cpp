// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"
#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/path_file.h"

namespace silt::sim {
namespace {

// A size that is no multiple of the tiles.
constexpr PinholeCamera kCamera{120.3, 120, 74.5, 54.5, 150, 110};

LightingOptions Coarse() {
  LightingOptions options;
  options.direct_spacing_m = 0.2f;
  options.indirect_spacing_m = 0.5f;
  return options;
}

PoseAtTime Still(const SE3d& pose) {
  return [pose](double) { return pose; };
}

const SE3d kRoomPose = LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7});

std::shared_ptr<const LitScene> Room() {
  static const auto room = std::make_shared<const LitScene>(RoomWithBoxAndBall(), Coarse());
  return room;
}

TEST(Renderer, FramesDoNotDependOnTheNumberOfThreads) {
  RenderOptions options{.camera = kCamera, .shutter = {.exposure_s = 0.1}};
  options.sensor.noise = HandaNoise{};
  const PoseAtTime moving = [](double t) {
    return kRoomPose * SE3d::Exp({{0.1 * t, 0.2 * t, 0}, {t, 0, 0}});
  };
  Frame frames[3];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    const Renderer renderer(RoomWithBoxAndBall(), options, Coarse());
    frames[threads] = renderer.Render(moving, 0.5, 3);
  }
  SetThreadCount(0);
  EXPECT_EQ(frames[1].rgb, frames[2].rgb);
  EXPECT_EQ(frames[1].depth_m, frames[2].depth_m);
}

// Two surfaces in the same place: whichever is seen, it is the same one in every run.
TEST(Renderer, CoincidentSurfacesDoNotDependOnTheNumberOfThreads) {
  SceneBuilder builder;
  const int black = builder.AddMaterial(Vec3f{}), white = builder.AddMaterial(Vec3f{1, 1, 1});
  for (int i = 0; i < 2000; ++i) {
    const Vec3f corner{float(i % 40) * 0.1f - 2, float(i / 40) * 0.1f - 2, 0};
    builder.AddQuad(corner, {0.1f, 0, 0}, {0, 0.1f, 0}, black);
    builder.AddQuad(corner, {0.1f, 0, 0}, {0, 0.1f, 0}, white);
  }
  builder.scene.ambient = {1, 1, 1};
  Image<Rgb8> pictures[3];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    const Renderer renderer(builder.scene, {.camera = kCamera}, Coarse());
    pictures[threads] = renderer.Render(Still(LookAt({0, -1, 2}, {0, 0, 0})), 0, 0).rgb;
  }
  SetThreadCount(0);
  EXPECT_EQ(pictures[1], pictures[2]);
}

TEST(Renderer, PicturesWithoutNoiseAreTheSameEveryTime) {
  const Renderer renderer(Room(), {.camera = kCamera, .seed = 1});
  const Renderer other(Room(), {.camera = kCamera, .seed = 2});
  const Frame a = renderer.Render(Still(kRoomPose), 0, 0);
  EXPECT_EQ(a.rgb, other.Render(Still(kRoomPose), 7, 9).rgb);
}

// A point of the floor keeps its radiance, whoever looks at it.
TEST(Renderer, SurfacesLookTheSameFromEveryViewpoint) {
  const Renderer renderer(Room(), {.camera = {120, 120, 0, 0, 1, 1}, .samples_per_pixel = 1});
  const auto radiance = [&](const Vec3d& eye, const Vec3d& point) {
    return renderer.RenderLinear(Still(LookAt(eye, point)), 0)(0, 0);
  };
  for (const Vec3d& point : {Vec3d{0.3, -0.8, 0}, Vec3d{-1.2, 0.4, 0}, Vec3d{1.2, -0.5, 0}}) {
    const Vec3f reference = radiance({0.1, -1, 2}, point);
    EXPECT_GT(reference.x, 0.01f);
    for (const Vec3d& eye : {Vec3d{-1.5, -1.5, 0.8}, Vec3d{1.5, -1.8, 1.7}, Vec3d{0, -1.9, 0.3}}) {
      EXPECT_NEAR(radiance(eye, point).x / reference.x, 1, 1e-4f);
      EXPECT_NEAR(radiance(eye, point).z / reference.z, 1, 1e-4f);
    }
  }
}

// Within a closed box of albedo ρ whose sides send 1 − ρ by themselves, all is 1.
TEST(Renderer, ABakedWhiteFurnaceIsWhite) {
  for (const float albedo : {0.3f, 0.5f, 0.8f}) {
    SceneBuilder builder;
    const float own = 1 - albedo;
    builder.AddBox({-1, -1, -1}, {1, 1, 1},
                   builder.AddMaterial({albedo, albedo, albedo}, {own, own, own}));
    builder.scene.ambient = {100, 100, 100};  // outside
    const Renderer renderer(builder.scene, {.camera = {20, 20, 19.5, 14.5, 40, 30}}, Coarse());
    for (const Vec3d& towards : {Vec3d{1, 1, 0.3}, Vec3d{-1, 0.2, -1}, Vec3d{0.1, -1, 1}}) {
      for (const Vec3f& value : renderer.RenderLinear(Still(LookAt({0.1, 0, 0}, towards)), 0)) {
        ASSERT_NEAR(value.x, 1, 5e-3f) << albedo;
      }
    }
  }
}

TEST(Renderer, TheBackgroundIsTheAmbient) {
  Scene empty;
  empty.ambient = {0.25f, 0.5f, 2};
  empty.exposure = 0.5;
  const Frame frame = Renderer(empty, {.camera = kCamera}).Render(Still({}), 0, 0);
  const auto code = [](float linear) {
    return std::uint8_t(std::lround(255 * SrgbFromLinear(linear)));
  };
  EXPECT_EQ(frame.rgb(5, 7), (Rgb8{code(0.125f), code(0.25f), 255}));
  EXPECT_EQ(frame.depth_m(5, 7), 0);
}

// A white edge over black through the pixel at x = 0: the share of the pixel that it covers.
TEST(Renderer, PixelsAreTheMeanOverTheirArea) {
  SceneBuilder builder;
  builder.AddQuad({-0.5f, -1, 1}, {0.5f, 0, 0}, {0, 2, 0},
                  builder.AddMaterial(Vec3f{}, Vec3f{1, 1, 1}));
  const PinholeCamera camera{10, 10, 2, 2, 5, 5};
  for (const double share : {0.125, 0.375, 0.625, 0.875}) {
    SE3d pose;
    pose.translation.x = (0.5 - share) / 10;
    const Renderer renderer(builder.scene, {.camera = camera, .samples_per_pixel = 64}, Coarse());
    EXPECT_NEAR(renderer.RenderLinear(Still(pose), 0)(2, 2).x, share, 0.02);
  }
}

TEST(Renderer, DepthIsThatOfTheMiddleOfTheExposure) {
  const PoseAtTime moving = [](double t) { return kRoomPose * SE3d::Exp({{0, t, 0}, {}}); };
  RenderOptions options{.camera = kCamera, .shutter = {.exposure_s = 0.2}};
  options.sensor.noise = HandaNoise{};
  const Renderer renderer(Room(), options);
  const Frame frame = renderer.Render(moving, 0.3, 0);
  EXPECT_EQ(frame.time_s, 0.3);
  EXPECT_EQ(frame.depth_m, renderer.RenderDepth(moving(0.3)));
}

TEST(Renderer, NoiseDependsOnSeedAndFrame) {
  const auto render = [](std::uint64_t seed, int frame) {
    RenderOptions options{.camera = kCamera};
    options.sensor.noise = HandaNoise{};
    options.seed = seed;
    return Renderer(Room(), options).Render(Still(kRoomPose), 0, frame).rgb;
  };
  EXPECT_EQ(render(1, 1), render(1, 1));
  EXPECT_FALSE(render(1, 1) == render(1, 2));
  EXPECT_FALSE(render(1, 1) == render(2, 1));
}

TEST(Renderer, RefusesOptionsThatMakeNoPicture) {
  EXPECT_THROW(Renderer(Room(), {.camera = {1, 1, 0, 0, 0, 0}}), Error);
  EXPECT_THROW(Renderer(Room(), {.camera = kCamera, .samples_per_pixel = 0}), Error);
  EXPECT_THROW(Renderer(Room(), {.camera = kCamera, .shutter = {.exposure_s = -1}}), Error);
  EXPECT_THROW(Renderer(Room(), {.camera = kCamera, .shutter = {.exposure_s = std::nan("")}}),
               Error);
  EXPECT_THROW(Renderer(Room(), {.camera = kCamera, .shutter = {.time_samples = 0}}), Error);
}

// Paths and stored light show the same room: mean radiance to 2 %.
TEST(Renderer, PathsShowWhatBakedLightShows) {
  const RenderOptions options{.camera = {30, 30, 19.5, 14.5, 40, 30}, .samples_per_pixel = 64};
  LightingOptions traced;
  traced.mode = LightMode::kPath;
  const Image<Vec3f> baked =
      Renderer(RoomWithBoxAndBall(), options).RenderLinear(Still(kRoomPose), 0);
  const Image<Vec3f> paths =
      Renderer(RoomWithBoxAndBall(), options, traced).RenderLinear(Still(kRoomPose), 0);
  double a = 0, b = 0;
  for (std::size_t i = 0; i < baked.size(); ++i) {
    a += baked.data()[i].y;
    b += paths.data()[i].y;
  }
  EXPECT_NEAR(a / b, 1, 0.02);
}

// A mirror shows what stands before it, on top of baked light and only where it is asked to.
TEST(Renderer, ReflectionIsAnOption) {
  SceneBuilder builder;
  Material mirror;
  mirror.diffuse = {0.5f, 0.5f, 0.5f};
  mirror.mirror = true;
  builder.AddQuad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, builder.AddMaterial(mirror));
  builder.AddQuad({-9, 2, 0}, {18, 0, 0}, {0, 0, 9}, builder.AddMaterial(Vec3f{}, {0, 3, 0}));
  builder.scene.ambient = {1, 0, 0};
  LightingOptions shiny = Coarse();
  shiny.specular = true;
  const RenderOptions options{.camera = {300, 300, 3.5, 3.5, 8, 8}};
  const PoseAtTime pose =
      Still(LookAt({0, -1, 1}, {0, 0.5, 0}));  // the reflected ray meets the wall
  const Vec3f matt = Renderer(builder.scene, options, Coarse()).RenderLinear(pose, 0)(4, 4);
  const Vec3f seen = Renderer(builder.scene, options, shiny).RenderLinear(pose, 0)(4, 4);
  EXPECT_GT(matt.x, 0.1f);
  EXPECT_NEAR(seen.x, 0, 1e-4f);
  EXPECT_NEAR(seen.y, 1.5f, 1e-3f);
}

// A varnished ground: what baked light and reflection show is what paths find.
TEST(Renderer, VarnishOnBakedLightIsThatOfPaths) {
  Scene scene = RoomWithBoxAndBall();
  for (Material& material : scene.materials) {
    if (Norm(material.emission) == 0) material.specular = 0.04f, material.roughness = 0.4f;
  }
  const RenderOptions options{.camera = {30, 30, 19.5, 14.5, 40, 30}, .samples_per_pixel = 64};
  LightingOptions traced, shiny = Coarse();
  traced.mode = LightMode::kPath;
  shiny.specular = true;
  const Image<Vec3f> baked = Renderer(scene, options, shiny).RenderLinear(Still(kRoomPose), 0);
  const Image<Vec3f> paths = Renderer(scene, options, traced).RenderLinear(Still(kRoomPose), 0);
  double a = 0, b = 0;
  for (std::size_t i = 0; i < baked.size(); ++i) {
    a += baked.data()[i].y;
    b += paths.data()[i].y;
  }
  EXPECT_NEAR(a / b, 1, 0.06);
}

TEST(Renderer, ExposureIsTheScenesOrGivenOrMetered) {
  Scene scene;
  scene.ambient = {0.36f, 0.36f, 0.36f};
  scene.exposure = 2;
  const auto gray = [&](const Exposure& exposure) {
    const RenderOptions options{.camera = kCamera, .exposure = exposure};
    return int(Renderer(scene, options).Render(Still({}), 0, 0).rgb(5, 5).g);
  };
  const auto encoded = [](float linear) { return int(std::lround(255 * SrgbFromLinear(linear))); };
  EXPECT_EQ(gray({}), encoded(0.72f));
  EXPECT_EQ(gray({Exposure::Kind::kGiven, 1}), encoded(0.36f));
  EXPECT_EQ(gray({Exposure::Kind::kPerFrame}), encoded(0.18f));
}

}  // namespace
}  // namespace silt::sim
