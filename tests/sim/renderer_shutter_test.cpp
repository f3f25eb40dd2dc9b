
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_builder.h"
#include "silt/core/parallel.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

// Pictures of moving cameras against what is known by formula.
namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{100, 100, 31.5, 23.5, 64, 48};
constexpr double kSpeed_m_s = 2;

LightingOptions NoLight() {
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 10;
  options.gather_directions = options.bounce_directions = 16;
  return options;
}

// A plane at z = 1, white to the right of x = 0 and black to the left.
std::shared_ptr<const LitScene> Edge() {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{}, Vec3f{1, 1, 1});
  builder.AddQuad({0, -5, 1}, {5, 0, 0}, {0, 10, 0}, white);
  builder.AddQuad({-5, -5, 1}, {5, 0, 0}, {0, 10, 0}, builder.AddMaterial(Vec3f{}));
  return std::make_shared<const LitScene>(builder.scene, NoLight());
}

SE3d Sliding(double time_s) { return SE3d::Exp({{}, {kSpeed_m_s * time_s, 0, 0}}); }
SE3d Approaching(double time_s) { return SE3d::Exp({{}, {0, 0, kSpeed_m_s * time_s}}); }

// Where the edge lies in a row: what is left of it is black.
double EdgeColumn(const Image<Vec3f>& image, int y) {
  double white = 0;
  for (int x = 0; x < image.width(); ++x) white += image(x, y).x;
  return image.width() - 0.5 - white;
}

RenderOptions Options(const Shutter& shutter, PixelPattern pattern) {
  RenderOptions options{.camera = kCamera, .samples_per_pixel = 64};
  options.shutter = shutter;
  options.pattern = pattern;
  return options;
}

// The edge is at column cx − fx·v·t, t being the row's.
TEST(RendererShutter, ARollingShutterSlantsAMovingEdge) {
  const double row_time_s = 1e-3;
  for (const PixelPattern pattern : {PixelPattern::kShared, PixelPattern::kScrambled}) {
    const Renderer renderer(Edge(), Options({0, 1, row_time_s}, pattern));
    const Image<Vec3f> image = renderer.RenderLinear(Sliding, 0.01);
    for (int y = 0; y < kCamera.height; ++y) {
      const double time_s = 0.01 + (y - 23.5) * row_time_s;
      EXPECT_NEAR(EdgeColumn(image, y), 31.5 - 100 * kSpeed_m_s * time_s, 0.05) << y;
    }
  }
}

TEST(RendererShutter, DepthBehindARollingShutterIsThatOfEachRowsTime) {
  const double row_time_s = 1e-3;
  const Renderer renderer(Edge(), Options({0.01, 16, row_time_s}, PixelPattern::kShared));
  const Image<float> depth = renderer.RenderDepth(Approaching, 0.02);
  for (int y = 0; y < kCamera.height; ++y) {
    const double z = 1 - kSpeed_m_s * (0.02 + (y - 23.5) * row_time_s);
    for (const int x : {0, 20, 63}) EXPECT_NEAR(depth(x, y) / z, 1, 1e-6);
  }
  EXPECT_EQ(renderer.RenderGeometry(Approaching, 0.02).depth_m, depth);
  EXPECT_EQ(renderer.Render(Approaching, 0.02, 0).depth_m, depth);
}

// A row's exposure smears the edge over fx·v·T columns, evenly.
TEST(RendererShutter, AnEdgeIsSmearedOverItsWayDuringTheExposure) {
  const double exposure_s = 0.1;  // 20 columns
  for (const PixelPattern pattern : {PixelPattern::kShared, PixelPattern::kScrambled}) {
    const Renderer renderer(Edge(), Options({exposure_s, 64}, pattern));
    const Image<Vec3f> image = renderer.RenderLinear(Sliding, 0);
    for (int x = 0; x < kCamera.width; ++x) {
      const double expected = std::clamp((x - 31.5) / 20 + 0.5, 0.0, 1.0);
      EXPECT_NEAR(image(x, 10).x, expected, 0.035) << x;
    }
  }
}

// The shared pattern shows so many edges as it has instants, the scrambled one a slope with noise.
TEST(RendererShutter, ScrambledInstantsLeaveNoGhosts) {
  const auto steps = [](PixelPattern pattern) {
    const Renderer renderer(Edge(), Options({0.2, 4}, pattern));
    RenderOptions options = Options({0.2, 4}, pattern);
    options.samples_per_pixel = 1;
    const Image<Vec3f> image = Renderer(renderer.lit_scene(), options).RenderLinear(Sliding, 0);
    // Mean over the rows, whose patterns differ: how often it stands still within the smear.
    int still = 0;
    double before = 0;
    for (int x = 14; x < 50; ++x) {
      double mean = 0;
      for (int y = 0; y < image.height(); ++y) mean += image(x, y).x / image.height();
      still += std::abs(mean - before) < 1e-3;
      before = mean;
    }
    return still;
  };
  EXPECT_GT(steps(PixelPattern::kShared), 20);
  EXPECT_LT(steps(PixelPattern::kScrambled), 8);
}

TEST(RendererShutter, ScrambledAndRollingFramesDoNotDependOnTheNumberOfThreads) {
  for (const PixelFilter filter : {PixelFilter::kBox, PixelFilter::kGaussian}) {
    RenderOptions options = Options({0.01, 16, 1e-4}, PixelPattern::kScrambled);
    options.samples_per_pixel = 4;
    options.filter = filter;
    Image<Vec3f> images[3];
    for (const int threads : {1, 2}) {
      SetThreadCount(threads);
      images[threads] = Renderer(Edge(), options).RenderLinear(Sliding, 0.02, 5);
    }
    SetThreadCount(0);
    for (std::size_t i = 0; i < images[1].size(); ++i) {
      ASSERT_EQ(images[1].data()[i].x, images[2].data()[i].x);
    }
  }
}

TEST(RendererShutter, TheSharpPictureIsThatOfTheMiddleOfEachRow) {
  const Renderer blurred(Edge(), Options({0.01, 16, 1e-3}, PixelPattern::kShared));
  const Renderer sharp(Edge(), Options({0, 16, 1e-3}, PixelPattern::kShared));
  const Image<Vec3f> a = blurred.RenderSharp(Sliding, 0.01);
  const Image<Vec3f> b = sharp.RenderLinear(Sliding, 0.01);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a.data()[i].x, b.data()[i].x, 1e-6f);
}

TEST(RendererShutter, AGaussianIsWiderThanTheBox) {
  const auto image = [](PixelFilter filter) {
    RenderOptions options = Options({}, PixelPattern::kShared);
    options.filter = filter;
    return Renderer(Edge(), options).RenderLinear([](double) { return SE3d{}; }, 0);
  };
  // The edge lies between columns 31 and 32.
  const Image<Vec3f> box = image(PixelFilter::kBox), gaussian = image(PixelFilter::kGaussian);
  EXPECT_EQ(box(31, 5).x, 0);
  EXPECT_EQ(box(32, 5).x, 1);
  EXPECT_NEAR(gaussian(32, 5).x, 0.798, 0.03);  // half a pixel is σ/1.2: (Φ(0.833) − Φ(−3))/0.9973
  EXPECT_NEAR(gaussian(31, 5).x, 0.202, 0.03);
}

}  // namespace
}  // namespace silt::sim
