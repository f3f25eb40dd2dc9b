// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/alignment.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "silt/core/error.h"

// Algorithm 1's bookkeeping on a backend without images: only x, the first coordinate of the
// translation, moves, and the test says what each pose costs.
namespace silt::tracker {
namespace {

using testing::DoubleEq;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

struct FakeReference : ReferencePyramid {
  explicit FakeReference(const std::vector<int>& measured) {
    for (int pixels : measured) all.push_back({kIclNuimCamera, pixels});
  }
  const PyramidLevels& levels() const override { return all; }
  PyramidLevels all;
};

class FakeBackend : public Backend {
 public:
  using CostFunction = std::function<PhotometricCost(int level, double x)>;
  explicit FakeBackend(CostFunction cost) : cost_(std::move(cost)) {
    equations.hessian = {1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1};
    equations.gradient = {0, 0, 0, -0.1, 0, 0};
  }

  std::string name() const override { return "fake"; }
  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>&, const Image<float>&,
                                                  const PinholeCamera&,
                                                  const PyramidOptions&) const override {
    return nullptr;
  }
  std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>&, const Image<float>&,
                                              const PyramidOptions&) const override {
    return nullptr;
  }
  std::unique_ptr<ReferencePyramid> WithoutHidden(const ImagePair& pair, int,
                                                  const SE3d&) const override {
    return std::make_unique<FakeReference>(dynamic_cast<const FakeReference&>(pair.reference));
  }
  PhotometricCost Cost(const ImagePair&, int level, const SE3d& pose) const override {
    return cost_(level, pose.translation.x);
  }
  NormalEquations Linearize(const ImagePair&, int level, const SE3d& pose,
                            const ResidualNorm&) const override {
    ++linearizations;
    if (before) before();
    NormalEquations result = equations;
    result.cost = Cost({FakeReference({}), CurrentPyramid()}, level, pose);
    return result;
  }

  NormalEquations equations;
  std::function<void()> before;  // each linearization
  mutable int linearizations = 0;

 private:
  CostFunction cost_;
};

AlignmentOptions Levels(std::vector<int> max_iterations) {
  AlignmentOptions options;
  options.max_iterations = std::move(max_iterations);
  options.keep_log = true;
  return options;
}

AlignmentResult AlignFake(const FakeBackend& backend, const AlignmentOptions& options,
                          int measured = 1000) {
  const FakeReference reference(std::vector<int>(std::size_t(options.levels()), measured));
  const CurrentPyramid current;
  return Align(backend, ImagePair{reference, current}, SE3d{}, options);
}

PhotometricCost FallingCost(int, double x) { return {10 - x, 1000}; }
PhotometricCost RisingCost(int, double x) { return {10 + x, 1000}; }

std::vector<double> Dampings(const AlignmentResult& result) {
  std::vector<double> dampings;
  for (const AlignmentStep& step : result.log) dampings.push_back(step.damping);
  return dampings;
}

TEST(Alignment, SuccessDividesTheDampingByTen) {
  const AlignmentResult result = AlignFake(FakeBackend(FallingCost), Levels({4}));
  ASSERT_TRUE(result.ok) << result.failure;
  EXPECT_THAT(Dampings(result),
              ElementsAre(DoubleEq(1e-3), DoubleEq(1e-4), DoubleEq(1e-5), DoubleEq(1e-6)));
  EXPECT_THAT(result.log, Each(Field(&AlignmentStep::accepted, true)));
  // dξ = −(JᵀJ + αI)⁻¹·Jᵀr.
  EXPECT_DOUBLE_EQ(result.log[0].update_norm, 0.1 / 1.001);
  EXPECT_NEAR(result.current_from_reference.translation.x,
              0.1 / 1.001 + 0.1 / 1.0001 + 0.1 / 1.00001 + 0.1 / 1.000001, 1e-15);
}

TEST(Alignment, FailureMultipliesTheDampingByTenAndKeepsThePose) {
  const AlignmentResult result = AlignFake(FakeBackend(RisingCost), Levels({5}));
  ASSERT_TRUE(result.ok) << result.failure;
  EXPECT_THAT(Dampings(result), ElementsAre(DoubleEq(1e-3), DoubleEq(1e-2), DoubleEq(1e-1),
                                            DoubleEq(1), DoubleEq(10)));
  EXPECT_EQ(result.current_from_reference.translation.x, 0);
  EXPECT_EQ(result.final_cost().sum, 10);
}

TEST(Alignment, AnEqualCostIsNotASuccess) {
  const FakeBackend backend([](int, double) { return PhotometricCost{10, 1000}; });
  EXPECT_THAT(AlignFake(backend, Levels({3})).log, Each(Field(&AlignmentStep::accepted, false)));
}

TEST(Alignment, RejectedSolvesCountAsIterations) {
  const FakeBackend backend(RisingCost);
  const AlignmentResult result = AlignFake(backend, Levels({2, 5, 20, 20}));
  std::vector<int> iterations;
  for (const AlignmentLevel& level : result.levels) iterations.push_back(level.iterations);
  // |dξ| falls as α grows, by a factor of ten each; it passes 1e-6 in the ninth solve.
  EXPECT_THAT(iterations, ElementsAre(9, 9, 5, 2));
  EXPECT_EQ(backend.linearizations, 4);
}

TEST(Alignment, EachLevelStartsWithTheInitialDampingFromWhereTheOneBeforeEnded) {
  const AlignmentResult result = AlignFake(FakeBackend(FallingCost), Levels({1, 2, 1}));
  ASSERT_EQ(result.log.size(), 4u);
  EXPECT_THAT(Dampings(result),
              ElementsAre(DoubleEq(1e-3), DoubleEq(1e-3), DoubleEq(1e-4), DoubleEq(1e-3)));
  EXPECT_EQ(result.log[0].level, 3);
  EXPECT_EQ(result.log[3].level, 1);
  EXPECT_EQ(result.levels[1].initial_cost, result.levels[0].final_cost);
  EXPECT_EQ(result.levels[1].level, 2);
}

TEST(Alignment, ASmallUpdateEndsTheLevelWithoutBeingTaken) {
  FakeBackend backend(FallingCost);
  backend.equations.gradient = {0, 0, 0, -0.9e-6, 0, 0};
  const AlignmentResult result = AlignFake(backend, Levels({7}));
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_TRUE(result.levels[0].converged);
  EXPECT_FALSE(result.log[0].accepted);
  EXPECT_EQ(result.current_from_reference.translation.x, 0);
}

TEST(Alignment, ASmallUpdateIsTakenUntestedWhereAsked) {
  FakeBackend backend(RisingCost);
  backend.equations.gradient[3] = -1e-7;
  AlignmentOptions options = Levels({5});
  options.take_last_step = true;
  for (const bool keep_log : {false, true}) {
    options.keep_log = keep_log;
    const AlignmentResult result = AlignFake(backend, options);
    EXPECT_DOUBLE_EQ(result.current_from_reference.translation.x, 1e-7 / 1.001);
    EXPECT_EQ(result.levels[0].iterations, 1);
    EXPECT_TRUE(result.levels[0].converged);
    EXPECT_EQ(result.final_cost().sum, 10);
    EXPECT_THAT(result.log, Each(Field(&AlignmentStep::accepted, true)));
  }
}

TEST(Alignment, CoarserLevelsMayStopEarlier) {
  FakeBackend backend(FallingCost);
  backend.equations.gradient[3] = -3e-6;
  AlignmentOptions options = Levels({0, 3, 3, 3});
  options.coarser_update_norm = 2;
  std::vector<int> iterations;
  for (const AlignmentLevel& level : AlignFake(backend, options).levels) {
    iterations.push_back(level.iterations);
  }
  // The least are 4e-6, 2e-6, and at the finest level that is aligned 1e-6.
  EXPECT_THAT(iterations, ElementsAre(1, 3, 3));
}

TEST(Alignment, MarquardtsDampingIsInUnitsOfTheDiagonal) {
  FakeBackend backend(FallingCost);
  for (double& h : backend.equations.hessian) h *= 50;
  AlignmentOptions options = Levels({1});
  EXPECT_DOUBLE_EQ(AlignFake(backend, options).log[0].update_norm, 0.1 / 50.001);
  options.scaled_damping = true;
  EXPECT_DOUBLE_EQ(AlignFake(backend, options).log[0].update_norm, 0.1 / 50.05);
}

// The spread does not depend on the norm, so that the scale never settles.
TEST(Alignment, ScalesAreEstimatedSoOftenAtMost) {
  const auto linearizations = [](int scale_rounds) {
    FakeBackend backend(RisingCost);
    double squares = 1;
    AlignmentOptions options = Levels({1, 1, 1});
    options.robust_scale = 2.5;
    options.scale_rounds = scale_rounds;
    backend.before = [&] { backend.equations.intensity = {squares *= 2, 1000}; };
    EXPECT_TRUE(AlignFake(backend, options).ok);
    return backend.linearizations;
  };
  // Each level takes one more for its trial step; the first one has nothing to begin with.
  EXPECT_EQ(linearizations(0), 6 + 4);
  EXPECT_EQ(linearizations(1), 6 + 4 + 1 + 1);
}

TEST(Alignment, ComparesTheMeanCostNotTheSum) {
  // The sum falls, but only because pixels leave the view.
  const FakeBackend losing([](int, double x) {
    return x > 0 ? PhotometricCost{8, 500} : PhotometricCost{10, 1000};
  });
  EXPECT_FALSE(AlignFake(losing, Levels({1})).log[0].accepted);
  // The sum grows with the number of pixels while each fits better.
  const FakeBackend gaining([](int, double x) {
    return x > 0 ? PhotometricCost{12, 1000} : PhotometricCost{10, 500};
  });
  EXPECT_TRUE(AlignFake(gaining, Levels({1})).log[0].accepted);
}

TEST(Alignment, APoseThatShowsTooLittleIsRejected) {
  const FakeBackend backend([](int, double x) {
    return x > 0 ? PhotometricCost{0.01, 99} : PhotometricCost{10, 1000};
  });
  EXPECT_FALSE(AlignFake(backend, Levels({1})).log[0].accepted);
}

TEST(Alignment, FailsWhereTheStartShowsTooLittle) {
  const FakeBackend backend([](int, double) { return PhotometricCost{1, 99}; });
  const AlignmentResult result = AlignFake(backend, Levels({1}));
  EXPECT_FALSE(result.ok);
  EXPECT_EQ(result.failure, "the images share 99 of 1000 measured pixels at level 1");
}

TEST(Alignment, SkipsLevelsWithoutPixelsOrIterations) {
  const FakeBackend backend(FallingCost);
  EXPECT_EQ(AlignFake(backend, Levels({0, 3, 0})).levels.size(), 1u);
  const AlignmentResult none = AlignFake(backend, Levels({1, 1}), 10);
  EXPECT_FALSE(none.ok);
  EXPECT_EQ(none.failure, "no pyramid level has enough measured pixels");
}

TEST(Alignment, FailsWithoutNanWhereTheEquationsAreNotFinite) {
  FakeBackend backend(FallingCost);
  backend.equations.hessian[0] = std::numeric_limits<double>::quiet_NaN();
  const AlignmentResult result = AlignFake(backend, Levels({3}));
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.failure, HasSubstr("no finite solution"));
  EXPECT_EQ(result.current_from_reference.translation.x, 0);
}

TEST(Alignment, FailsWhereTheEquationsAreSingular) {
  FakeBackend backend(FallingCost);
  // The first two parameters do the same.
  backend.equations.hessian[1] = 1;
  const AlignmentResult result = AlignFake(backend, Levels({3}));
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.failure, HasSubstr("does not determine a pose"));
}

TEST(Alignment, KeepsNoLogUnlessAsked) {
  AlignmentOptions options = Levels({3});
  options.keep_log = false;
  const AlignmentResult result = AlignFake(FakeBackend(FallingCost), options);
  EXPECT_TRUE(result.log.empty());
  EXPECT_EQ(result.levels.size(), 1u);
}

TEST(Alignment, CovarianceIsThatOfTheTilesOrElseOfTheResiduals) {
  FakeBackend backend([](int, double) { return PhotometricCost{50, 1000, 40}; });
  for (double& h : backend.equations.hessian) h *= 4;
  const AlignmentResult plain = AlignFake(backend, Levels({1}));
  ASSERT_TRUE(plain.ok) << plain.failure;
  EXPECT_NEAR(plain.covariance[0], 0.04 / 4, 1e-12);
  EXPECT_NEAR(plain.covariance[1], 0, 1e-12);
  backend.equations.scatter = {6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0, 6, 0, 24};
  EXPECT_NEAR(AlignFake(backend, Levels({1})).covariance[35],
              (6 + 12 + 6 + 24) / 4.0 / 6 / 4 * 8 / 7, 1e-12);
}

}  // namespace
}  // namespace silt::tracker
