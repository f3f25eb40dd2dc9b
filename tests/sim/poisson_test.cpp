// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/poisson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "noise_statistics.h"

namespace silt::sim {
namespace {

std::vector<double> Numbers(double mean) {
  const CounterRandom random(17, 3);
  std::vector<double> numbers;
  for (int i = 0; i < kCount; ++i) numbers.push_back(Poisson(random, std::uint64_t(i), mean));
  return numbers;
}

// χ² over all counts that are expected at least ten times, against its own mean and deviation.
TEST(Poisson, CountsFollowTheLaw) {
  for (const double mean : {0.3, 3.0, 9.99, 10.0, 14.0, 60.0}) {
    std::map<double, int> counts;
    for (const double k : Numbers(mean)) ++counts[k];
    double chi2 = 0;
    int cells = 0, counted = 0;
    for (int k = 0; k < 200; ++k) {
      const double expected = kCount * std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
      if (expected < 10) continue;
      const double d = counts[k] - expected;
      chi2 += d * d / expected;
      counted += counts[k];
      ++cells;
    }
    EXPECT_GT(counted, 0.99 * kCount) << mean;
    EXPECT_NEAR(chi2, cells, kSigmas * std::sqrt(2.0 * cells)) << mean;
  }
}

TEST(Poisson, MeanAndVarianceAreEqual) {
  for (const double mean : {0.3, 1.0, 25.0, 400.0, 1e4, 1e6}) {
    ExpectMeanAndVariance(Numbers(mean), mean, mean);
  }
}

TEST(Poisson, NoMeanGivesNone) {
  const CounterRandom random(1);
  EXPECT_EQ(Poisson(random, 5, 0), 0);
  EXPECT_EQ(Poisson(random, 5, -2), 0);
  EXPECT_EQ(Poisson(random, 5, std::nan("")), 0);
}

TEST(Poisson, IsAFunctionOfItsIndex) {
  const CounterRandom random(1);
  EXPECT_EQ(Poisson(random, 5, 1000), Poisson(random, 5, 1000));
  EXPECT_NE(Poisson(random, 5, 1000), Poisson(random, 6, 1000));
}

}  // namespace
}  // namespace silt::sim
