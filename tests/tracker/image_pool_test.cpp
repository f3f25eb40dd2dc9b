// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_pool.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace silt::tracker {
namespace {

TEST(ImagePool, GivesOutWhatCameBack) {
  ImagePool pool;
  const float* first = pool.Take(8, 4)->data();
  EXPECT_EQ(pool.Take(8, 4)->data(), first);
}

TEST(ImagePool, GivesNoImageTwiceAtOnce) {
  ImagePool pool;
  const auto a = pool.Take(8, 4), b = pool.Take(8, 4);
  EXPECT_NE(a->data(), b->data());
}

TEST(ImagePool, GivesTheSizeThatIsAskedFor) {
  ImagePool pool;
  pool.Take(8, 4);
  const auto image = pool.Take(4, 8);
  EXPECT_EQ(image->width(), 4);
  EXPECT_EQ(image->height(), 8);
  EXPECT_EQ(pool.Take(0, 0)->size(), 0u);
}

TEST(ImagePool, ItsImagesMayOutliveIt) {
  std::optional<ImagePool> pool(std::in_place);
  const auto image = pool->Take(2, 2);
  pool.reset();
  (*image)(1, 1) = 3;
  EXPECT_EQ((*image)(1, 1), 3);
}

// A size that no longer comes gives way.
TEST(ImagePool, KeepsNoMoreThanItNeeds) {
  ImagePool pool;
  const auto old = pool.Take(5, 5);
  std::vector<std::shared_ptr<Image<float>>> many;
  for (int i = 0; i < 200; ++i) many.push_back(pool.Take(3, 3));
  many.clear();
  const float* data = pool.Take(3, 3)->data();
  EXPECT_EQ(pool.Take(3, 3)->data(), data);
}

}  // namespace
}  // namespace silt::tracker
