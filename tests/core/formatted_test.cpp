// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/formatted.h"

#include <gtest/gtest.h>

namespace silt {
namespace {

TEST(Formatted, IsAsPrintfPrintsIt) {
  EXPECT_EQ(Formatted("%5.2f cm, %d of %s", 1.25, 3, "four"), " 1.25 cm, 3 of four");
  EXPECT_EQ(Formatted("%s", ""), "");
}

TEST(Formatted, TextsOfAnyLengthAreWhole) {
  const std::string words(5000, 'w');
  EXPECT_EQ(Formatted("<%s>", words.c_str()), "<" + words + ">");
}

}  // namespace
}  // namespace silt
