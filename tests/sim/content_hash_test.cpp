// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/content_hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace silt::sim {
namespace {

TEST(ContentHash, EveryBitCounts) {
  std::string data(40, '\0');
  std::set<std::string> digests{ContentHash().AddBytes(data.data(), data.size()).Digest()};
  for (std::size_t bit = 0; bit < 8 * data.size(); ++bit) {
    std::string other = data;
    other[bit / 8] = char(1 << bit % 8);
    digests.insert(ContentHash().AddBytes(other.data(), other.size()).Digest());
  }
  EXPECT_EQ(digests.size(), 1 + 8 * data.size());
}

TEST(ContentHash, LengthAndOrderCount) {
  const std::vector<float> none, zero{0}, a{1, 2}, b{2, 1};
  const std::set<std::string> digests{ContentHash().Digest(), ContentHash().AddArray(none).Digest(),
                                      ContentHash().AddArray(zero).Digest(),
                                      ContentHash().AddArray(a).Digest(),
                                      ContentHash().AddArray(b).Digest()};
  EXPECT_EQ(digests.size(), 5u);
}

TEST(ContentHash, IsTheSameEverywhere) {
  EXPECT_EQ(ContentHash().Add(1).Digest(), ContentHash().Add(1).Digest());
  EXPECT_EQ(ContentHash().Digest().size(), 32u);
}

}  // namespace
}  // namespace silt::sim
