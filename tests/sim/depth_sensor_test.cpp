// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/depth_sensor.h"

#include <gtest/gtest.h>

#include "depth_scene.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

GeometryBuffers Slope() {
  return Geometry([](int x, int y) { return 1 + 0.004 * x + 0.002 * y; }, 0.5);
}

TEST(DepthSensor, PerfectIsTheTruth) {
  const GeometryBuffers truth = Slope();
  EXPECT_EQ(Measured({}, truth), truth.depth_m);
}

TEST(DepthSensor, APngHoldsFiveThousandthsOfAMetreUpTo13M) {
  GeometryBuffers truth = Slope();
  truth.depth_m(0, 0) = 1.00014f;
  truth.depth_m(1, 0) = 1.00006f;
  truth.depth_m(2, 0) = 13.107f;
  truth.depth_m(3, 0) = 13.2f;
  truth.depth_m(4, 0) = 0;
  const Image<float> stored = Measured({.model = "png16"}, truth);
  EXPECT_FLOAT_EQ(stored(0, 0), 1.0002f);
  EXPECT_FLOAT_EQ(stored(1, 0), 1);
  EXPECT_FLOAT_EQ(stored(2, 0), 13.107f);
  EXPECT_EQ(stored(3, 0), 0);
  EXPECT_EQ(stored(4, 0), 0);
}

TEST(DepthSensor, NoiseDependsOnSeedAndFrameAndNotOnThreads) {
  const GeometryBuffers truth = Slope();
  for (const std::string& model : DepthSensorModels()) {
    if (model == "perfect" || model == "png16") continue;
    const DepthSensorOptions options{model, DepthDropouts::Kinect()};
    SetThreadCount(1);
    const Image<float> one = Measured(options, truth, {3, 4});
    SetThreadCount(0);
    EXPECT_EQ(one, Measured(options, truth, {3, 4})) << model;
    EXPECT_FALSE(one == Measured(options, truth, {3, 5})) << model;
    EXPECT_FALSE(one == Measured(options, truth, {4, 4})) << model;
  }
}

TEST(DepthSensor, RefusesAModelThatThereIsNot) {
  EXPECT_THROW(MakeDepthSensor({"lidar", {}}), Error);
  EXPECT_THROW(MakeDepthSensor({"kinect", {.grazing_deg = -1}}), Error);
}

TEST(DepthView, BetweenPixelsDepthIsBilinear) {
  GeometryBuffers truth = Geometry([](int x, int y) { return 2 + 0.01 * x + 0.02 * y; });
  truth.depth_m(20, 20) = 0;
  const DepthView view{kDepthCamera, nullptr, truth};
  EXPECT_FLOAT_EQ(view.BilinearDepth(10.25, 30.5), 2 + 0.1025f + 0.61f);
  EXPECT_FLOAT_EQ(view.BilinearDepth(-3, 300), 2 + 0.02f * 255);
  EXPECT_EQ(view.BilinearDepth(19.5, 20), 0);
  EXPECT_FLOAT_EQ(view.BilinearDepth(19, 20), 2 + 0.19f + 0.4f);
  EXPECT_EQ(view.SurfaceDepth(19.6, 20), 0);
  EXPECT_FLOAT_EQ(view.SurfaceDepth(19.4, 20), 2 + 0.19f + 0.4f);
}

// A wall across the axis is met at the angle of the ray, which a lens bends.
TEST(DepthView, IncidenceIsThatOfTheRayThroughTheLens) {
  const PinholeCamera camera{200, 210, 127.5, 127.5, kWidth, kHeight};
  const LensDistortion lens{-0.1, 0.02, 0.001, 0.002, 0};
  const LensMap map(camera, lens);
  const GeometryBuffers truth = Wall(2);
  const Vec2d straight{(10 - 127.5) / 200, (30 - 127.5) / 210};
  const auto cosine = [](const Vec2d& p) { return 1 / std::sqrt(1 + p.x * p.x + p.y * p.y); };
  const DepthView pinhole{camera, nullptr, truth}, bent{camera, &map, truth};
  EXPECT_NEAR(pinhole.CosIncidence(10, 30), cosine(straight), 1e-7);
  EXPECT_NEAR(bent.CosIncidence(10, 30), cosine(lens.Undistort(straight)), 1e-7);
  EXPECT_GT(std::abs(bent.CosIncidence(10, 30) - pinhole.CosIncidence(10, 30)), 0.01);
}

}  // namespace
}  // namespace silt::sim
