// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Each bound below is one that a perfect generator exceeds once in a million draws of the seed.
namespace silt {
namespace {

constexpr int kDraws = 100000;
constexpr double kTwoSidedZ = 4.892;   // P(|N(0, 1)| > z) = 1e-6
constexpr double kOneSidedZ = 4.753;   // P(N(0, 1) > z) = 1e-6
constexpr double kKolmogorov = 2.694;  // P(√n·D > k) = 2·exp(−2k²) = 1e-6

// Quantile of χ² by Wilson and Hilferty.
double ChiSquareBound(double freedom) {
  const double s = 2 / (9 * freedom);
  return freedom * std::pow(1 - s + kOneSidedZ * std::sqrt(s), 3);
}

// √n times the correlation of two series of mean and variance given: N(0, 1) where independent.
double ScaledCorrelation(const std::vector<double>& a, const std::vector<double>& b, double mean,
                         double variance) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean) * (b[i] - mean);
  return sum / variance / std::sqrt(double(a.size()));
}

std::vector<double> Uniforms(const CounterRandom& random, std::uint64_t first = 0) {
  std::vector<double> values;
  for (std::uint64_t i = 0; i < kDraws; ++i) values.push_back(random.Uniform(first + i));
  return values;
}

class RandomAtSeed : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomAtSeed, UniformFillsItsBinsEvenly) {
  constexpr int kBins = 256;
  std::vector<int> count(kBins);
  for (double value : Uniforms(CounterRandom(GetParam()))) {
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    ++count[std::size_t(value * kBins)];
  }
  double chi_square = 0;
  for (int n : count) chi_square += std::pow(n - double(kDraws) / kBins, 2) * kBins / kDraws;
  EXPECT_LT(chi_square, ChiSquareBound(kBins - 1));
}

TEST_P(RandomAtSeed, EveryBitIsSetHalfTheTime) {
  const CounterRandom random(GetParam());
  int set[64] = {};
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    const std::uint64_t bits = random.Bits(i);
    for (int b = 0; b < 64; ++b) set[b] += int(bits >> b & 1);
  }
  for (int n : set) EXPECT_LT(std::abs(2.0 * n - kDraws) / std::sqrt(double(kDraws)), kTwoSidedZ);
}

// Kolmogorov's and Smirnov's distance to the distribution function of N(0, 1).
TEST_P(RandomAtSeed, NormalHasTheNormalDistribution) {
  const CounterRandom random(GetParam());
  std::vector<double> values;
  for (std::uint64_t i = 0; i < kDraws; ++i) values.push_back(random.Normal(i));
  std::sort(values.begin(), values.end());
  double distance = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = 0.5 * std::erfc(-values[i] / std::sqrt(2.0));
    distance = std::max({distance, std::abs(expected - double(i) / kDraws),
                         std::abs(expected - double(i + 1) / kDraws)});
  }
  EXPECT_LT(distance * std::sqrt(double(kDraws)), kKolmogorov);
}

TEST_P(RandomAtSeed, NeighboursAreUncorrelated) {
  const std::uint64_t seed = GetParam();
  const std::vector<double> base = Uniforms(CounterRandom(seed, 4));
  for (const auto& other :
       {Uniforms(CounterRandom(seed, 4), 1), Uniforms(CounterRandom(seed, 5)),
        Uniforms(CounterRandom(seed + 1, 4)), Uniforms(CounterRandom(4, seed))}) {
    EXPECT_LT(std::abs(ScaledCorrelation(base, other, 0.5, 1.0 / 12)), kTwoSidedZ);
  }
}

std::vector<double> Normals(const CounterRandom& random, std::uint64_t first) {
  std::vector<double> values;
  for (std::uint64_t i = 0; i < kDraws; ++i) values.push_back(random.Normal(first + i));
  return values;
}

std::vector<double> Squared(std::vector<double> values) {
  for (double& value : values) value *= value;
  return values;
}

// N(0, 1) has mean 0 with variance 1, and mean square 1 with variance 2.
TEST_P(RandomAtSeed, NormalHasItsMoments) {
  double sum = 0, sum_of_squares = 0;
  for (double value : Normals(CounterRandom(GetParam()), 0)) {
    sum += value;
    sum_of_squares += value * value;
  }
  EXPECT_LT(std::abs(sum) / std::sqrt(double(kDraws)), kTwoSidedZ);
  EXPECT_LT(std::abs(sum_of_squares - kDraws) / std::sqrt(2.0 * kDraws), kTwoSidedZ);
}

// Normals that shared a uniform number would be uncorrelated; their squares would not.
TEST_P(RandomAtSeed, SuccessiveNormalsAreIndependent) {
  const CounterRandom random(GetParam());
  const std::vector<double> now = Normals(random, 0), next = Normals(random, 1);
  EXPECT_LT(std::abs(ScaledCorrelation(now, next, 0, 1)), kTwoSidedZ);
  EXPECT_LT(std::abs(ScaledCorrelation(Squared(now), Squared(next), 1, 2)), kTwoSidedZ);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomAtSeed, testing::Values(0, 1, 42, ~std::uint64_t(0)));

TEST(RandomTest, ValueDependsNeitherOnOrderNorOnOtherDraws) {
  const CounterRandom random(9, 3);
  std::vector<double> forward, backward(1000);
  for (std::uint64_t i = 0; i < 1000; ++i) forward.push_back(random.Normal(i));
  for (std::uint64_t i = 1000; i-- > 0;) backward[i] = CounterRandom(9, 3).Normal(i);
  EXPECT_EQ(forward, backward);
}

// Published figures hang on these: a change of the generator must be a decision.
TEST(RandomTest, ValuesStayAsTheyWere) {
  EXPECT_EQ(CounterRandom(0).Bits(0), 2077113891230206638u);
  EXPECT_EQ(CounterRandom(1, 2).Bits(3), 18267492641143413165u);
}

}  // namespace
}  // namespace silt
