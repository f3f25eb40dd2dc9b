// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/time_jet.h"

#include <gtest/gtest.h>

namespace silt::sim {
namespace {

void ExpectNear(const TimeJet& jet, double f, double df, double ddf) {
  EXPECT_NEAR(jet.value, f, 1e-14);
  EXPECT_NEAR(jet.d1, df, 1e-14);
  EXPECT_NEAR(jet.d2, ddf, 1e-13);
}

const double kT = 0.8;
const TimeJet kTime = TimeJet::Time(kT);

TEST(TimeJet, Polynomial) {
  const TimeJet cubic = kTime * kTime * kTime - TimeJet(2.0) * kTime + TimeJet(5.0);
  ExpectNear(cubic, kT * kT * kT - 2 * kT + 5, 3 * kT * kT - 2, 6 * kT);
}

TEST(TimeJet, Quotient) {
  ExpectNear(TimeJet(1.0) / kTime, 1 / kT, -1 / (kT * kT), 2 / (kT * kT * kT));
  ExpectNear((kTime * kTime) / kTime, kT, 1, 0);
}

TEST(TimeJet, Root) {
  ExpectNear(sqrt(kTime), std::sqrt(kT), 0.5 / std::sqrt(kT), -0.25 / (kT * std::sqrt(kT)));
  ExpectNear(sqrt(kTime * kTime), kT, 1, 0);
}

TEST(TimeJet, SineAndCosine) {
  const TimeJet angle = kTime * kTime;
  const double a = kT * kT, s = std::sin(a), c = std::cos(a);
  ExpectNear(sin(angle), s, 2 * kT * c, 2 * c - 4 * a * s);
  ExpectNear(cos(angle), c, -2 * kT * s, -2 * s - 4 * a * c);
}

TEST(TimeJet, ComparesByValue) {
  EXPECT_TRUE(TimeJet(1, 9, 9) < TimeJet(2, 0, 0));
  EXPECT_FALSE(TimeJet(2, 0, 0) < TimeJet(1, 9, 9));
}

}  // namespace
}  // namespace silt::sim
