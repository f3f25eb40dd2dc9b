// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/kinect_depth.h"

#include <gtest/gtest.h>

#include "depth_scene.h"

namespace silt::sim {
namespace {

TEST(KinectDepth, StepsAreEighthsOfAPixelOfDisparity) {
  const GeometryBuffers truth = Geometry([](int x, int y) { return 0.5 + 0.01 * x + 0.02 * y; });
  for (const char* model : {"kinect", "kinect-legacy"}) {
    const Image<float> measured = Measured({model, {}}, truth);
    for (const float z : measured) {
      ASSERT_GT(z, 0);
      const double steps = 351.3 / double(z);
      EXPECT_EQ(z, float(351.3 / std::round(steps))) << steps;
    }
  }
}

// Walls at ten depths, each varying slowly, so that its disparities lie anywhere between steps: the
// error is that of the noise, 1/36, and of the rounding, 1/12. Forty comparisons of
// noise_statistics.h: with other seeds, one fails by chance in one run of 43,000.
TEST(KinectDepth, DisparityErrorIsThatOfNoiseAndRoundingAtTenDepths) {
  for (int i = 1; i <= 10; ++i) {
    const double steps = 351.3 / (0.5 * i);
    SCOPED_TRACE(0.5 * i);
    const GeometryBuffers truth =
        Geometry([steps](int x, int y) { return 351.3 / (steps + 0.0371 * x + 0.0293 * y); });
    const auto error = [&](const char* model) {
      const Image<float> measured = Measured({model, {}}, truth);
      return Values([&](int x, int y) {
        return 351.3 / double(measured(x, y)) - 351.3 / double(truth.depth_m(x, y));
      });
    };
    ExpectMeanAndVariance(error("kinect"), 0, 1.0 / 36 + 1.0 / 12);
    ExpectMeanAndVariance(error("kinect-legacy"), 0.5, 1.0 / 36 + 1.0 / 12);
  }
}

// The legacy variant's depth is too small by z²·0.5/351.3.
TEST(KinectDepth, TheLegacyVariantIsTooNear) {
  for (const double z : {1.0, 2.0, 4.0}) {
    const GeometryBuffers truth =
        Geometry([z](int x, int y) { return z + 1e-4 * z * z * (0.31 * x + 0.17 * y - 61); });
    const auto mean_error = [&](const char* model) {
      const Image<float> measured = Measured({model, {}}, truth);
      double sum = 0;
      for (int i = 0; i < kCount; ++i) {
        sum += double(measured.data()[i]) - double(truth.depth_m.data()[i]);
      }
      return sum / kCount;
    };
    const double step = z * z / 351.3;
    EXPECT_NEAR(mean_error("kinect"), 0, 0.02 * step) << z;
    EXPECT_NEAR(mean_error("kinect-legacy"), -0.5 * step, 0.02 * step) << z;
  }
}

// Half a pixel of shift turns a slope of 2 cm per pixel into 1 cm of noise, far above the steps.
TEST(KinectDepth, PixelsShiftByHalfAPixelAlongRowsAndColumns) {
  const double slope = 0.02;
  for (const bool along_x : {true, false}) {
    const GeometryBuffers truth =
        Geometry([&](int x, int y) { return 0.6 + slope * ((along_x ? x : y) % 128); });
    const Image<float> measured = Measured({"kinect", {}}, truth);
    std::vector<double> errors;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const int i = (along_x ? x : y) % 128;
        if (i < 4 || i > 40) continue;
        errors.push_back(double(measured(x, y) - truth.depth_m(x, y)));
      }
    }
    double squares = 0;
    for (const double e : errors) squares += e * e;
    EXPECT_NEAR(std::sqrt(squares / double(errors.size())), slope / 2, 0.05 * slope / 2);
  }
}

TEST(KinectDepth, MeasuresNothingWhereThereIsNothing) {
  GeometryBuffers truth = Wall(2);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 96; x <= 104; ++x) truth.depth_m(x, y) = 0;
  }
  const Image<float> measured = Measured({"kinect", {}}, truth);
  for (int y = 0; y < kHeight; ++y) {
    EXPECT_EQ(measured(100, y), 0);
    EXPECT_GT(measured(90, y), 0);
  }
  EXPECT_EQ(Measured({"kinect", {}}, Wall(1e6))(5, 5), 0);
}

}  // namespace
}  // namespace silt::sim
