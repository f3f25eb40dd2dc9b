// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/depth_dropouts.h"

#include <gtest/gtest.h>

#include "depth_scene.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr double kDegree = M_PI / 180;

int Missing(const Image<float>& depth_m) {
  return int(std::count(depth_m.begin(), depth_m.end(), 0.0f));
}

TEST(DepthDropouts, NoneUnlessAskedFor) {
  EXPECT_TRUE(DepthDropouts{}.AreNone());
  EXPECT_FALSE(DepthDropouts::Kinect().AreNone());
  EXPECT_EQ(Missing(Measured({"perfect", {}}, Wall(2, 89.9 * kDegree))), 0);
}

TEST(DepthDropouts, GrazingRaysMeasureNothing) {
  const DepthSensorOptions options{"perfect", {.grazing_deg = 75}};
  EXPECT_EQ(Missing(Measured(options, Wall(2, 74.9 * kDegree))), 0);
  EXPECT_EQ(Missing(Measured(options, Wall(2, 75.1 * kDegree))), kCount);
}

TEST(DepthDropouts, EdgesMeasureNothingOnEitherSide) {
  const GeometryBuffers truth = Geometry([](int x, int) { return x < 128 ? 1.0 : 1.06; });
  for (const int width : {1, 3}) {
    const Image<float> measured =
        Measured({"perfect", {.edge_share = 0.05, .edge_px = width}}, truth);
    EXPECT_EQ(Missing(measured), 2 * width * kHeight);
    EXPECT_EQ(measured(128 - width, 5), 0);
    EXPECT_EQ(measured(127 + width, 5), 0);
  }
  EXPECT_EQ(Missing(Measured({"perfect", {.edge_share = 0.07}}, truth)), 0);
}

// A board 1 m away before a wall at 2 m hides fx·b·(1/1 − 1/2) columns of it from a projector to
// the right, and they lie to its left.
TEST(DepthDropouts, TheProjectorsShadowFallsToTheLeft) {
  const GeometryBuffers truth =
      Geometry([](int x, int) { return x >= 120 && x < 180 ? 1.0 : 2.0; });
  const PinholeCamera camera{500, 500, 127.5, 127.5, kWidth, kHeight};
  const auto sensor = MakeDepthSensor({"perfect", {.shadow_baseline_m = 0.075}});
  const Image<float> measured = sensor->Measure({camera, nullptr, truth}, {});
  const int hidden = 18;  // 500·0.075/2 = 18.75: of the columns 101.25 to 120
  EXPECT_EQ(Missing(measured), hidden * kHeight);
  EXPECT_EQ(measured(119, 7), 0);
  EXPECT_EQ(measured(102, 7), 0);
  EXPECT_GT(measured(101, 7), 0);
}

TEST(DepthDropouts, RefusesWhatMakesNoSense) {
  for (const DepthDropouts& bad :
       {DepthDropouts{.grazing_deg = 0}, DepthDropouts{.grazing_deg = 91},
        DepthDropouts{.edge_share = -1}, DepthDropouts{.edge_px = 0}, DepthDropouts{.edge_px = 17},
        DepthDropouts{.shadow_baseline_m = -1}, DepthDropouts{.shadow_baseline_m = std::nan("")}}) {
    EXPECT_THROW(bad.Validate(), Error);
  }
}

}  // namespace
}  // namespace silt::sim
