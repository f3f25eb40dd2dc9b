// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/trust.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "analytic_room.h"
#include "silt/core/color.h"
#include "silt/core/random.h"
#include "silt/tracker/cpu_backend.h"

namespace silt::tracker {
namespace {

using testing::HasSubstr;

constexpr PoseEvidence kGood{0.9, 0.01, 0.001, 0.98, 1e-4};

struct Spoiled {
  const char* name;
  double PoseEvidence::*of;
  double doubtful, lost;
  const char* message;
};

void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.name; }

class BadEvidence : public testing::TestWithParam<Spoiled> {};

TEST_P(BadEvidence, IsDoubtfulThenLost) {
  const TrustOptions options = AccuratePreset().trust;
  PoseEvidence evidence = kGood;
  evidence.*GetParam().of = GetParam().doubtful;
  const Judgement doubtful = Judge(evidence, options);
  EXPECT_EQ(doubtful.status, TrackingStatus::kDoubtful) << doubtful.message;
  EXPECT_THAT(doubtful.message, HasSubstr("doubtful: "));
  EXPECT_THAT(doubtful.message, HasSubstr(GetParam().message));
  evidence.*GetParam().of = GetParam().lost;
  const Judgement lost = Judge(evidence, options);
  EXPECT_EQ(lost.status, TrackingStatus::kLost);
  EXPECT_THAT(lost.message, HasSubstr("lost: "));
  evidence.*GetParam().of = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Judge(evidence, options).status, TrackingStatus::kLost);
}

INSTANTIATE_TEST_SUITE_P(Trust, BadEvidence,
                         testing::Values(Spoiled{"unexplained", &PoseEvidence::unexplained_variance,
                                                 0.22, 0.3, "do not look alike"},
                                         Spoiled{"depth", &PoseEvidence::depth_disagreement, 0.025,
                                                 0.04, "depths differ"},
                                         Spoiled{"inliers", &PoseEvidence::inlier_ratio, 0.7, 0.3,
                                                 "70 % of the pixels agree"},
                                         Spoiled{"uncertain", &PoseEvidence::uncertainty_rad, 0.01,
                                                 0.1, "determine the pose to 0.01 rad"}),
                         [](const auto& p) { return std::string(p.param.name); });

TEST(Trust, GoodEvidenceIsTrackedByEveryPreset) {
  for (const TrackerOptions& preset : {PaperPreset(), AccuratePreset(), FastPreset()}) {
    EXPECT_EQ(Judge(kGood, preset.trust).status, TrackingStatus::kTracked);
  }
}

// Above 1 just where the judgement is not that all is well, and more the worse the evidence is.
TEST_P(BadEvidence, DoubtGrowsWithIt) {
  const TrustOptions options = AccuratePreset().trust;
  EXPECT_LE(Doubt(kGood, options), 1);
  EXPECT_LE(Disagreement(kGood, options), Doubt(kGood, options));
  PoseEvidence doubtful = kGood, worse = kGood;
  doubtful.*GetParam().of = GetParam().doubtful;
  worse.*GetParam().of = GetParam().lost;
  EXPECT_GT(Doubt(doubtful, options), 1);
  EXPECT_GT(Doubt(worse, options), Doubt(doubtful, options));
  worse.*GetParam().of = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GT(Doubt(worse, options), Doubt(doubtful, options));
}

TEST(Trust, LittleOverlapIsDoubtful) {
  PoseEvidence evidence = kGood;
  evidence.overlap = 0.2;
  const Judgement judgement = Judge(evidence, {});
  EXPECT_EQ(judgement.status, TrackingStatus::kDoubtful);
  EXPECT_EQ(judgement.message, "doubtful: 20 % of the keyframe is seen");
  EXPECT_NEAR(Doubt(evidence, {}), 1.5, 1e-12);
  EXPECT_LE(Disagreement(evidence, {}), 1);
}

TEST(Trust, StatusesHaveNames) {
  EXPECT_STREQ(Name(TrackingStatus::kTracked), "tracked");
  EXPECT_STREQ(Name(TrackingStatus::kDoubtful), "doubtful");
  EXPECT_STREQ(Name(TrackingStatus::kLost), "lost");
}

// The evidence of a true pose, with a share of the current image painted over.
PoseEvidence EvidenceWith(double painted) {
  const SE3d current_from_reference = SE3d::Exp({{0.01, 0.02, 0}, {0.02, 0, 0.01}});
  const View reference = RenderRoom({});
  View current = RenderRoom(current_from_reference.Inverse());
  const auto end = std::ptrdiff_t(painted * double(current.intensity.size()));
  std::fill_n(current.intensity.begin(), end, 1.0f);
  const auto backend = MakeCpuBackend();
  const auto r = backend->MakeReference(reference.intensity, reference.depth_m, kSmallCamera, {3});
  const auto c = backend->MakeCurrent(current.intensity, {}, {3});
  AlignmentResult alignment;
  alignment.ok = true;
  alignment.current_from_reference = current_from_reference;
  alignment.levels.push_back({1, 160, 120, {}, backend->Cost({*r, *c}, 0, current_from_reference)});
  alignment.covariance[0] = 4e-6;
  return EvidenceOf(*backend, {{*r, {}}}, *c, alignment,
                    ContentOf(reference.intensity, reference.depth_m));
}

TEST(Trust, EvidenceTellsHowManyPixelsAgree) {
  const PoseEvidence good = EvidenceWith(0), bad = EvidenceWith(0.4);
  EXPECT_GT(good.inlier_ratio, 0.99);
  EXPECT_NEAR(bad.inlier_ratio, 0.6, 0.06);
  EXPECT_LT(good.unexplained_variance, 0.01);
  EXPECT_GT(bad.unexplained_variance, 0.5);
  EXPECT_GT(good.overlap, 0.9);
  EXPECT_LE(good.overlap, 1);
  EXPECT_NEAR(good.uncertainty_rad, 2e-3, 1e-9);
  EXPECT_EQ(good.depth_disagreement, 0);
}

// White noise, or the same smeared over neighbours, which then err together.
Image<float> Noisy(Image<float> image, double sigma, bool smeared, std::uint64_t seed) {
  const CounterRandom random(seed);
  Image<float> noise(image.width(), image.height());
  for (std::size_t i = 0; i < noise.size(); ++i) noise.data()[i] = float(sigma * random.Normal(i));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      float sum = noise(x, y);
      if (smeared) {
        sum = 0;
        for (int k = 0; k < 9; ++k) {
          const int u = (x + k % 3) % image.width(), v = (y + k / 3) % image.height();
          sum += noise(u, v) / 3;
        }
      }
      image(x, y) += sum;
    }
  }
  return image;
}

struct NoiseCase {
  bool robust, smeared;
};
void PrintTo(const NoiseCase& each, std::ostream* out) {
  *out << (each.robust ? "robust" : "squares") << (each.smeared ? "_smeared" : "_white");
}

class CovarianceOf : public testing::TestWithParam<NoiseCase> {};

// 200 alignments of two views of the room under fresh noise: ξᵀC⁻¹ξ is 6 on average. Its own spread
// is √(12/200) = 0.24; that of C, from 15 tiles, and what interpolation costs add to it. The noise
// is the reference's: in the current image it would be part of the gradient too.
TEST_P(CovarianceOf, AlignmentsFitsTheirErrors) {
  // No pixel lands on another, where the interpolant has creases.
  const SE3d truth = SE3d::Exp({{0.01, 0.02, 0.03}, {0.03, 0.02, 0.05}});
  const View room = RenderRoom({});
  const auto backend = MakeCpuBackend();
  const auto current = backend->MakeCurrent(RenderRoom(truth.Inverse()).intensity, {}, {1});
  AlignmentOptions options;
  options.max_iterations = {8};
  options.exclude_hidden = false;
  options.robust_scale = GetParam().robust ? 2.5 : 0;
  double mean = 0;
  constexpr int runs = 200;
  for (int i = 0; i < runs; ++i) {
    const auto reference =
        backend->MakeReference(Noisy(room.intensity, 0.02, GetParam().smeared, std::uint64_t(i)),
                               room.depth_m, kSmallCamera, {1});
    const AlignmentResult result = Align(*backend, {*reference, *current}, truth, options);
    ASSERT_TRUE(result.ok) << result.failure;
    EXPECT_EQ(result.intensity_scale > 0, options.robust());
    const auto square = NormalizedSquare((truth * result.current_from_reference.Inverse()).Log(),
                                         result.covariance);
    ASSERT_TRUE(square.has_value());
    mean += *square / runs;
  }
  EXPECT_GT(mean, 4.5);
  EXPECT_LT(mean, 9);
}

INSTANTIATE_TEST_SUITE_P(Trust, CovarianceOf,
                         testing::Values(NoiseCase{false, false}, NoiseCase{false, true},
                                         NoiseCase{true, false}, NoiseCase{true, true}),
                         [](const auto& p) {
                           return std::string(p.param.robust ? "robust" : "squares") +
                                  (p.param.smeared ? "_smeared" : "_white");
                         });

}  // namespace
}  // namespace silt::tracker
