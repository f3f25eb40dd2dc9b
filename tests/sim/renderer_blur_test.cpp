// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"
#include "silt/core/color.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

// A blurred frame is the mean of linear sharp frames over its exposure, within the error of its
// samples. Both are rendered kRuns times with scrambled patterns of their own, so that the
// differences D of a pixel are independent between runs and pixels, and tell their own variance.
// Under the hypothesis that their mean is 0, over all pixels,
//   ratio = Σ mean(D)² / Σ var(D)/kRuns is 1,   z = Σ mean(D) / √(Σ var(D)/kRuns) is 0,
// the first with variance 2·(1 + 1/(kRuns − 1))·Σ v²/(Σ v)² (v = var(D)), the second with 1. Both
// are compared at 5 standard deviations: with other seeds than the fixed ones, a comparison fails
// by chance about once in a million.
namespace silt::sim {
namespace {

constexpr int kRuns = 8;
constexpr double kExposure_s = 1.0 / 60, kMiddle_s = 0.4;
constexpr double kSigmas = 5;

// Some five pixels during the exposure.
SE3d Moving(double t) {
  return LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7}) * SE3d::Exp({{0.2 * t, 3 * t, t}, {2 * t, 0, 0}});
}

struct Setup {
  LightMode light;
  PinholeCamera camera;
  int instants;  // of a blurred frame, and sharp frames of one sample each
};

// The sharp frames' exposure, which a wrong shutter would mistake.
struct Interval {
  double begin_s = kMiddle_s - kExposure_s / 2, length_s = kExposure_s;
  bool encoded = false;  // their mean is that of encoded values
};

float Encoded(float linear) { return SrgbFromLinear(std::min(linear, 1.0f)); }
float Decoded(float encoded) { return LinearFromSrgb(encoded); }

class BlurComparison {
 public:
  explicit BlurComparison(const Setup& setup) : setup_(setup) {
    LightingOptions lighting;
    lighting.mode = setup.light;
    lighting.direct_spacing_m = 0.2f;
    lighting.indirect_spacing_m = 0.5f;
    lit_ = std::make_shared<const LitScene>(RoomWithBoxAndBall(), lighting);
    for (int run = 0; run < kRuns; ++run) {
      RenderOptions options = Options(setup.instants);
      options.shutter = {kExposure_s, setup.instants};
      options.seed = std::uint64_t(run);
      blurred_.push_back(Renderer(lit_, options).RenderLinear(Moving, kMiddle_s));
    }
  }

  struct Result {
    double ratio = 0, ratio_error = 0, z = 0;

    bool Agrees() const { return std::abs(ratio - 1) < kSigmas * ratio_error && AgreesInMean(); }
    bool AgreesInMean() const { return std::abs(z) < kSigmas; }
  };
  Result With(const Interval& interval) const {
    std::vector<Image<Vec3f>> sharp;
    for (int run = 0; run < kRuns; ++run) sharp.push_back(MeanOfSharp(interval, run));
    double means = 0, squares = 0, variances = 0, variances_squared = 0;
    for (std::size_t i = 0; i < sharp[0].size(); ++i) {
      double sum = 0, sum_of_squares = 0;
      for (int run = 0; run < kRuns; ++run) {
        const auto at = std::size_t(run);
        const double d = double(blurred_[at].data()[i].y) - double(sharp[at].data()[i].y);
        sum += d;
        sum_of_squares += d * d;
      }
      const double mean = sum / kRuns;
      const double variance = (sum_of_squares - kRuns * mean * mean) / (kRuns - 1) / kRuns;
      means += mean;
      squares += mean * mean;
      variances += variance;
      variances_squared += variance * variance;
    }
    const double spread = 2 * (1 + 1.0 / (kRuns - 1)) * variances_squared;
    return {squares / variances, std::sqrt(spread) / variances, means / std::sqrt(variances)};
  }

 private:
  RenderOptions Options(int samples) const {
    RenderOptions options{.camera = setup_.camera, .samples_per_pixel = samples};
    options.pattern = PixelPattern::kScrambled;
    return options;
  }

  Image<Vec3f> MeanOfSharp(const Interval& interval, int run) const {
    RenderOptions options = Options(1);
    options.seed = std::uint64_t(1000 + run);
    const Renderer renderer(lit_, options);
    Image<Vec3f> mean(setup_.camera.width, setup_.camera.height);
    for (int i = 0; i < setup_.instants; ++i) {
      const double time_s = interval.begin_s + (i + 0.5) / setup_.instants * interval.length_s;
      const Image<Vec3f> frame = renderer.RenderLinear(Moving, time_s, i);
      for (std::size_t k = 0; k < frame.size(); ++k) {
        const float value = frame.data()[k].y;
        mean.data()[k].y += (interval.encoded ? Encoded(value) : value) / float(setup_.instants);
      }
    }
    if (interval.encoded) {
      for (Vec3f& value : mean) value.y = Decoded(value.y);
    }
    return mean;
  }

  Setup setup_;
  std::shared_ptr<const LitScene> lit_;
  std::vector<Image<Vec3f>> blurred_;
};

void ExpectTheMeanOfSharpFrames(const Setup& setup) {
  const BlurComparison comparison(setup);
  const BlurComparison::Result right = comparison.With({});
  EXPECT_NEAR(right.ratio, 1, kSigmas * right.ratio_error);
  EXPECT_NEAR(right.z, 0, kSigmas);
  EXPECT_LT(right.ratio_error, 0.1);  // or nothing would be told
  // Half an exposure, one that begins where it should have its middle, and a mean of codes.
  EXPECT_FALSE(comparison.With({kMiddle_s - kExposure_s / 4, kExposure_s / 2}).Agrees());
  EXPECT_FALSE(comparison.With({kMiddle_s, kExposure_s}).Agrees());
  EXPECT_FALSE(comparison.With({kMiddle_s - kExposure_s / 2, kExposure_s, true}).AgreesInMean());
}

TEST(RendererBlur, OfBakedLightIsTheMeanOfSharpFrames) {
  ExpectTheMeanOfSharpFrames({LightMode::kBaked, {80, 80, 49.5, 36.5, 100, 74}, 32});
}

TEST(RendererBlur, OfPathsIsTheMeanOfSharpFrames) {
  ExpectTheMeanOfSharpFrames({LightMode::kPath, {48, 48, 29.5, 21.5, 60, 44}, 16});
}

}  // namespace
}  // namespace silt::sim
