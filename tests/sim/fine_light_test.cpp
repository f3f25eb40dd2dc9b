// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/fine_light.h"

#include <gtest/gtest.h>

namespace silt::sim {
namespace {

// Two patches whose values rise along the rows by 1, and from row to row by 10.
FineLight Ramps() {
  std::vector<Vec3f> values;
  for (const float first : {100.0f, 200.0f}) {
    for (int i = 0; i < FineLight::kPlaces; ++i) {
      const auto column = float(i % FineLight::kSide), row = float(i / FineLight::kSide);
      values.push_back({first + column + 10 * row, 0, 0});
    }
  }
  return {{{{7, 1, 2}, 0}, {{7, 1, 2}, 1}}, values};
}

TEST(FineLight, IsBilinearBetweenItsPlaces) {
  const FineLight light = Ramps();
  for (const bool front : {false, true}) {
    for (const float along : {0.0f, 0.1f, 0.25f, 0.6f, 1.0f}) {
      for (const float up : {0.0f, 0.3f, 0.5f, 0.9f, 1.0f}) {
        const auto found = light.At({{7, 1, 2}, along, up}, front);
        ASSERT_TRUE(found);
        const float expected =
            (front ? 200.0f : 100.0f) + FineLight::kIntervals * (along + 10 * up);
        EXPECT_NEAR(found->x, expected, 1e-3f) << along << ", " << up;
      }
    }
  }
}

TEST(FineLight, OtherCellsHaveNone) {
  const FineLight light = Ramps();
  EXPECT_FALSE(light.At({{7, 1, 1}, 0, 0}, true));
  EXPECT_FALSE(light.At({{7, 2, 2}, 0, 0}, true));
  EXPECT_FALSE(light.At({{6, 1, 2}, 0, 0}, true));
  EXPECT_FALSE(light.At({{8, 1, 2}, 0, 0}, true));
  EXPECT_FALSE(FineLight().At({{7, 1, 2}, 0, 0}, true));
}

}  // namespace
}  // namespace silt::sim
