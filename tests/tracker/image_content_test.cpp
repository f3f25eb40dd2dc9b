// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_content.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analytic_room.h"
#include "silt/core/random.h"

namespace silt::tracker {
namespace {

TEST(ImageContent, IsThatOfWhatIsMeasured) {
  Image<float> intensity(2, 1), depth_m(2, 1);
  intensity(0, 0) = 0.2f;
  intensity(1, 0) = 0.6f;
  depth_m(1, 0) = 4;
  const ImageContent content = ContentOf(intensity, depth_m);
  EXPECT_EQ(content.measured_share, 0.5);
  EXPECT_NEAR(content.variance, 0.04, 1e-7);
  EXPECT_NEAR(content.mean_inverse_depth, 0.25, 1e-7);
  EXPECT_EQ(content.edge_contrast, 0);
}

// Posts before a wall, as wide as the gaps, each of a brightness of its own and all of it mottled,
// as finely as 640 pixels show it: the intensities as a camera sees them whose picture is `zoom`
// times as large as that of the depths, about the middle.
View Posts(int width, double zoom) {
  const CounterRandom random(3, 1);
  const int period = width / 8;
  const double middle = (width - 1) / 2.0;
  View view{Image<float>(width, width * 3 / 4), Image<float>(width, width * 3 / 4)};
  for (int y = 0; y < view.depth_m.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      view.depth_m(x, y) = x / (period / 2) % 2 == 1 ? 1.5f : 3.0f;
      const int seen = int(std::floor(middle + (x - middle) / zoom)) / (period / 2);
      const double paint = 0.5 + (seen % 2 == 1 ? 0.1 : -0.1) + 0.05 * (seen % 3);
      const int u = x * 640 / width, v = y * 640 / width;
      const double mottle = 0.03 * random.Normal(std::uint64_t(640 * v + u));
      view.intensity(x, y) = float(paint + mottle);
    }
  }
  return view;
}

double EdgeContrast(const View& view) {
  return ContentOf(view.intensity, view.depth_m).edge_contrast;
}

class EdgesOfWidth : public testing::TestWithParam<int> {};

TEST_P(EdgesOfWidth, TellWhetherColoursAreRegistered) {
  EXPECT_GT(EdgeContrast(Posts(GetParam(), 1)), 2);
  const double unregistered = EdgeContrast(Posts(GetParam(), 0.9));
  EXPECT_GT(unregistered, 0.5);
  EXPECT_LT(unregistered, 1.3);
}

INSTANTIATE_TEST_SUITE_P(ImageContent, EdgesOfWidth, testing::Values(320, 640, 1280));

// What a nearer surface hides from a structured-light sensor has no depth: the edge of what is seen
// lies at the nearer surface's end. An infinite or undefined depth is none.
TEST(ImageContent, EdgesLieAtTheEndOfTheNearerSurface) {
  for (const float none : {0.0f, -1.0f, std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()}) {
    for (const int side : {-1, 1}) {
      View view = Posts(640, 1);
      const Image<float> whole = view.depth_m;
      for (int y = 0; y < whole.height(); ++y) {
        for (int x = 12; x < whole.width() - 12; ++x) {
          if (whole(x, y) > 2 && whole(x - 12 * side, y) < 2) view.depth_m(x, y) = none;
        }
      }
      EXPECT_GT(EdgeContrast(view), 2) << none << " " << side;
      // Beyond a wider hole nobody knows where the edge lay.
      for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole.data()[i] > 2) view.depth_m.data()[i] = none;
      }
      EXPECT_EQ(EdgeContrast(view), 0) << none;
    }
  }
}

TEST(ImageContent, OfFewEdgesOrLittleTextureNothingIsTold) {
  View view = Posts(640, 1);
  View plane = view;
  for (float& z : plane.depth_m) z = 2;
  EXPECT_EQ(EdgeContrast(plane), 0);
  for (float& intensity : view.intensity) intensity = 0.5f;
  EXPECT_EQ(EdgeContrast(view), 0);
}

// A slope is no edge.
TEST(ImageContent, ASlopeHasNoEdges) {
  View view = Posts(640, 1);
  for (int y = 0; y < view.depth_m.height(); ++y) {
    for (int x = 0; x < 640; ++x) view.depth_m(x, y) = float(std::exp(0.005 * x));
  }
  EXPECT_EQ(EdgeContrast(view), 0);
}

}  // namespace
}  // namespace silt::tracker
