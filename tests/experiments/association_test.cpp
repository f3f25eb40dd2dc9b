// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/association.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "silt/core/random.h"

namespace silt::experiments {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

using TimePairs = std::vector<std::pair<double, double>>;

Trajectory At(const std::vector<double>& times) {
  Trajectory trajectory;
  for (const double time_s : times) trajectory.push_back({time_s, {}});
  return trajectory;
}

TimePairs TimesOf(const std::vector<PosePair>& pairs) {
  TimePairs times;
  for (const PosePair& pair : pairs) times.emplace_back(pair.truth.time_s, pair.estimate.time_s);
  return times;
}

TimePairs Evo(const std::vector<double>& truth, const std::vector<double>& estimate, double tol) {
  return TimesOf(AssociateLikeEvo(At(truth), At(estimate), tol));
}

TimePairs Tum(const std::vector<double>& truth, const std::vector<double>& estimate, double tol) {
  return TimesOf(AssociateLikeTum(At(truth), At(estimate), tol));
}

TEST(Association, OfEqualTimesPairsThemAll) {
  EXPECT_THAT(Evo({1, 2}, {1, 2}, 0.01), ElementsAre(Pair(1, 1), Pair(2, 2)));
  EXPECT_THAT(Tum({1, 2}, {1, 2}, 0.01), ElementsAre(Pair(1, 1), Pair(2, 2)));
}

// Binary fractions, so that "exactly at the tolerance" is exact.
TEST(Association, ExactlyAtTheToleranceCountsForEvoAndNotForTum) {
  EXPECT_THAT(Evo({0, 8}, {0.25}, 0.25), ElementsAre(Pair(0, 0.25)));
  EXPECT_THAT(Tum({0, 8}, {0.25}, 0.25), IsEmpty());
}

TEST(Association, OfTwoEquallyNearTheEarlierIsTaken) {
  EXPECT_THAT(Evo({0, 1, 2}, {0.5}, 1), ElementsAre(Pair(0, 0.5)));
  EXPECT_THAT(Tum({0, 1, 2}, {0.5}, 1), ElementsAre(Pair(0, 0.5)));
  EXPECT_THAT(Tum({0.5}, {0, 1, 2}, 1), ElementsAre(Pair(0.5, 0)));
}

TEST(Association, EvoLetsAPoseServeSeveralAndTumDoesNot) {
  EXPECT_THAT(Evo({1, 5, 9}, {0.75, 1.125}, 0.5), ElementsAre(Pair(1, 0.75), Pair(1, 1.125)));
  EXPECT_THAT(Tum({1, 5, 9}, {0.75, 1.125}, 0.5), ElementsAre(Pair(1, 1.125)));
}

TEST(Association, EvoSearchesForEachPoseOfTheShorterOne) {
  // Only one truth, so only one pair although three estimates lie near.
  EXPECT_THAT(Evo({1}, {0.9, 1.05, 1.2}, 0.5), ElementsAre(Pair(1, 1.05)));
}

TEST(Association, TumTakesTheClosestPairFirst) {
  // 0 and 0.0625 both want 0.05; the nearer one gets it, the other its second choice.
  EXPECT_THAT(Tum({0, 0.0625}, {0.05, 0.11}, 0.2), ElementsAre(Pair(0, 0.11), Pair(0.0625, 0.05)));
}

TEST(Association, OfNothingIsNothing) {
  EXPECT_THAT(Evo({}, {1}, 1), IsEmpty());
  EXPECT_THAT(Evo({1}, {}, 1), IsEmpty());
  EXPECT_THAT(Tum({}, {}, 1), IsEmpty());
  EXPECT_THAT(Tum({1}, {2}, 0.5), IsEmpty());
}

std::vector<double> RandomTimes(std::uint64_t stream, int n) {
  const CounterRandom random(3, stream);
  std::vector<double> times;
  double time_s = random.Uniform(0);
  for (int i = 0; i < n; ++i) times.push_back(time_s += 0.01 + 0.05 * random.Uniform(i + 1));
  return times;
}

// The rule in its plainest form: sort all pairs, take each that is still free.
TimePairs TumByBruteForce(const std::vector<double>& truth, const std::vector<double>& estimate,
                          double tolerance_s) {
  std::vector<std::tuple<double, double, double>> all;
  for (const double a : truth) {
    for (const double b : estimate) {
      if (std::abs(a - b) < tolerance_s) all.emplace_back(std::abs(a - b), a, b);
    }
  }
  std::sort(all.begin(), all.end());
  TimePairs pairs;
  for (const auto& [apart, a, b] : all) {
    const bool taken = std::any_of(pairs.begin(), pairs.end(), [a = a, b = b](const auto& pair) {
      return pair.first == a || pair.second == b;
    });
    if (!taken) pairs.emplace_back(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Association, LikeTumIsTheBruteForceRule) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const std::vector<double> truth = RandomTimes(2 * i, 60), estimate = RandomTimes(2 * i + 1, 40);
    EXPECT_EQ(Tum(truth, estimate, 0.03), TumByBruteForce(truth, estimate, 0.03));
  }
}

TEST(NearestIndex, IsTheFirstOfTheNearest) {
  const std::vector<double> values{0, 1, 1, 1, 3};
  EXPECT_EQ(NearestIndex(values, -5), 0u);
  EXPECT_EQ(NearestIndex(values, 0.4), 0u);
  EXPECT_EQ(NearestIndex(values, 1), 1u);
  EXPECT_EQ(NearestIndex(values, 1.9), 1u);
  EXPECT_EQ(NearestIndex(values, 2), 1u);
  EXPECT_EQ(NearestIndex(values, 2.1), 4u);
  EXPECT_EQ(NearestIndex(values, 99), 4u);
}

}  // namespace
}  // namespace silt::experiments
