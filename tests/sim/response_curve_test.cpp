// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/response_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

class ResponseCurves : public testing::Test {
 protected:
  std::string Write(const std::string& text) const {
    return folder_.Write("curve.txt", text).string();
  }
  std::vector<ResponseCurve> All() const {
    return {ResponseCurve(), ResponseCurve::Linear(), ResponseCurve::Gamma(2.2),
            ResponseCurve::Gamma(0.5), ResponseCurve::FromFile(Write(kKnee))};
  }

  static constexpr const char* kKnee = "# knee\n0 0\n\n0.25 0.5  # steep\n0.5 0.75\n1 1\n";
  TempFolder folder_;
};

TEST_F(ResponseCurves, EncodeAsTheirFormulasSay) {
  EXPECT_NEAR(ResponseCurve().Encode(0.2), SrgbFromLinear(0.2f), 1e-7);
  EXPECT_DOUBLE_EQ(ResponseCurve::Linear().Encode(0.3), 0.3);
  EXPECT_DOUBLE_EQ(ResponseCurve::Gamma(2.2).Encode(0.3), std::pow(0.3, 1 / 2.2));
  const ResponseCurve knee = ResponseCurve::FromFile(Write(kKnee));
  EXPECT_DOUBLE_EQ(knee.Encode(0.125), 0.25);
  EXPECT_DOUBLE_EQ(knee.Encode(0.25), 0.5);
  EXPECT_DOUBLE_EQ(knee.Encode(0.75), 0.875);
}

TEST_F(ResponseCurves, DecodeInvertsEncode) {
  for (const ResponseCurve& curve : All()) {
    for (int i = 0; i <= 100; ++i) {
      EXPECT_NEAR(curve.Decode(curve.Encode(0.01 * i)), 0.01 * i, 1e-6) << curve.name();
    }
    EXPECT_EQ(curve.Encode(-1), 0);
    EXPECT_NEAR(curve.Encode(7), 1, 1e-7);
    EXPECT_EQ(curve.Decode(-1), 0);
    EXPECT_NEAR(curve.Decode(2), 1, 1e-7);
  }
}

TEST_F(ResponseCurves, SlopeIsTheDerivative) {
  for (const ResponseCurve& curve : All()) {
    for (const double x : {0.1, 0.3, 0.6, 0.93}) {
      const double h = 1e-3;
      const double difference = (curve.Encode(x + h) - curve.Encode(x - h)) / (2 * h);
      EXPECT_NEAR(curve.Slope(x) / difference, 1, 1e-3) << curve.name() << " at " << x;
    }
  }
  EXPECT_NEAR(ResponseCurve().Slope(0.001), 12.92, 1e-12);
}

TEST_F(ResponseCurves, EightBitsRoundToNearest) {
  for (const ResponseCurve& curve : All()) {
    for (int i = 0; i <= 10'000; ++i) {
      const float linear = float(i) / 10'000;
      // A hundredth of a code for the rounding of thresholds to float.
      EXPECT_NEAR(curve.Encode8(linear), 255 * curve.Encode(double(linear)), 0.5 + 1e-2)
          << curve.name() << " at " << linear;
    }
  }
}

TEST_F(ResponseCurves, EightBitsReachEveryCodeInOrder) {
  for (const ResponseCurve& curve : All()) {
    int last = 0;
    for (int i = 0; i <= 100'000; ++i) {
      const int code = curve.Encode8(float(i) / 100'000);
      EXPECT_GE(code, last);
      last = code;
    }
    EXPECT_EQ(last, 255);
  }
}

TEST_F(ResponseCurves, EightBitsClipWhatIsOutsideAndSurviveWhatIsNoNumber) {
  const ResponseCurve srgb;
  EXPECT_EQ(srgb.Encode8(0), 0);
  EXPECT_EQ(srgb.Encode8(-1), 0);
  EXPECT_EQ(srgb.Encode8(1), 255);
  EXPECT_EQ(srgb.Encode8(1e30f), 255);
  EXPECT_EQ(srgb.Encode8(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb.Encode8(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb.Encode8(std::nextafter(1.0f, 0.0f)), 255);
}

TEST_F(ResponseCurves, EncodeImagesChannelByChannel) {
  Image<Vec3f> linear(3, 2, {0, 0.2159f, 1});
  linear(2, 1) = {1, 0, 0.0331f};
  const Image<Rgb8> encoded = ResponseCurve().Encode8(linear);
  EXPECT_EQ(encoded(0, 0), (Rgb8{0, 128, 255}));
  EXPECT_EQ(encoded(2, 1), (Rgb8{255, 0, 51}));
}

TEST_F(ResponseCurves, HaveNames) {
  for (const char* name : {"srgb", "linear", "gamma:2.2"}) {
    EXPECT_EQ(ResponseCurve::Named(name).name(), name);
  }
  EXPECT_DOUBLE_EQ(ResponseCurve::Named("gamma:2").Encode(0.25), 0.5);
  const std::string file = Write("0 0\n1 1\n");
  EXPECT_EQ(ResponseCurve::Named(file).name(), file);
}

std::string Complaint(const std::string& name) {
  try {
    ResponseCurve::Named(name);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(ResponseCurves, RefuseWhatIsNoCurve) {
  for (const char* name : {"gamma:", "gamma:x", "gamma:2.2x", "gamma: 2"}) {
    EXPECT_THAT(Complaint(name), HasSubstr("write gamma:2.2")) << name;
  }
  for (const char* name : {"gamma:0", "gamma:-2", "gamma:11", "gamma:nan", "gamma:inf"}) {
    EXPECT_THAT(Complaint(name), HasSubstr("from 0.1 to 10")) << name;
  }
  EXPECT_THAT(Complaint("rec709"), HasSubstr("'rec709' is no file"));
  EXPECT_THAT(Complaint("/"), HasSubstr("'/' is no file"));
}

TEST_F(ResponseCurves, RefuseATableThatIsNone) {
  const auto expect = [&](const std::string& text, const std::string& said) {
    const std::string complaint = Complaint(Write(text));
    EXPECT_THAT(complaint, HasSubstr(said)) << text;
    EXPECT_EQ(complaint.find('\n'), std::string::npos);
  };
  expect("", ":0: the last point must be '1 1'");
  expect("0 0\n", ":1: the last point");
  expect("0 0\n0.5 0.9\n", ":2: the last point");
  expect("0.1 0\n1 1\n", ":1: the first point must be '0 0'");
  expect("0 0\n0.5 0.5\n0.5 0.6\n1 1\n", ":3: both numbers must be above");
  expect("0 0\n0.5 0.5\n0.6 0.5\n1 1\n", ":3: both numbers must be above");
  expect("0 0\n# c\n0.5 nan\n1 1\n", ":3: ");
  expect("0 0\n0.5\n1 1\n", ":2: expected two numbers");
  expect("0 0 0\n1 1\n", ":1: expected two numbers");
  expect("0 0\nx\x01y z\n1 1\n", ":2: expected two numbers");
  expect("0 0\n1 1\n2 2\n", ":3: the last point");
}

}  // namespace
}  // namespace silt::sim
