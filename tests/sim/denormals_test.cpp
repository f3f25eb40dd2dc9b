// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/denormals.h"

#include <gtest/gtest.h>

#include <limits>

namespace silt::sim {
namespace {

float Halved(float x) {
  volatile float value = x;
  return value * 0.5f;
}

TEST(Denormals, AreFlushedOnlyWithinTheScope) {
  const float least = std::numeric_limits<float>::min();
  EXPECT_GT(Halved(least), 0);
#if defined(__SSE2__)
  {
    const ScopedFlushDenormals flush;
    EXPECT_EQ(Halved(least), 0);
  }
#endif
  EXPECT_GT(Halved(least), 0);
}

}  // namespace
}  // namespace silt::sim
