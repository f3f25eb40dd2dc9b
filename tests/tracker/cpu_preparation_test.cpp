// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_preparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "silt/core/color.h"
#include "silt/core/pyramid.h"
#include "silt/core/random.h"

namespace silt::tracker {

static void PrintTo(SimdLevel level, std::ostream* out) { *out << Name(level); }

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Surfaces at several depths in patches, some rough enough for jumps, with holes of every kind.
Image<float> PatchyDepth(int width, int height) {
  const CounterRandom patches(6), texture(7), dropped(8), kind(9);
  const float holes[] = {0, kNaN, kInfinity, -1, 1e6f};
  Image<float> depth_m(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint64_t at = std::uint64_t(y) * 100000 + std::uint64_t(x);
      const std::uint64_t patch = std::uint64_t(y / 11) * 1000 + std::uint64_t(x / 13);
      depth_m(x, y) = float(1 + 3 * patches.Uniform(patch) + 0.04 * texture.Uniform(at));
      if (dropped.Uniform(at) < 0.01) depth_m(x, y) = holes[int(5 * kind.Uniform(at))];
    }
  }
  return depth_m;
}

Image<float> Noise(int width, int height) {
  const CounterRandom random(5);
  Image<float> image(width, height);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = float(random.Uniform(i));
  return image;
}

// Equal to the last bit; NaN equals NaN.
bool SameBits(const Image<float>& a, const Image<float>& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
           return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
         });
}

// The definition of depth_edges.h, pixel by pixel.
bool IsJump(float a, float b) { return !(std::abs(a - b) <= 0.03f * std::min(a, b)); }

Image<std::uint8_t> Edges(const Image<float>& depth_m, int margin_px) {
  const int w = depth_m.width(), h = depth_m.height(), reach = margin_px - 1;
  Image<std::uint8_t> edges(w, h);
  const auto mark = [&](int x, int y) {
    for (int v = std::max(0, y - reach); v <= std::min(h - 1, y + reach); ++v) {
      for (int u = std::max(0, x - reach); u <= std::min(w - 1, x + reach); ++u) edges(u, v) = 1;
    }
  };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      if (x + 1 < w && IsJump(depth_m(x, y), depth_m(x + 1, y))) mark(x, y), mark(x + 1, y);
      if (y + 1 < h && IsJump(depth_m(x, y), depth_m(x, y + 1))) mark(x, y), mark(x, y + 1);
    }
  }
  return edges;
}

class Preparation : public testing::TestWithParam<SimdLevel> {
 protected:
  CpuPreparation::Kept AwayFromEdges(const Image<float>& depth_m, const Image<float>* intensity,
                                     int margin_px, const CpuPreparation::Wanted& wanted) const {
    return prepare_.AwayFromEdges({{&depth_m, intensity, margin_px}}, wanted).front();
  }

  const CpuPreparation prepare_{GetParam()};
};

// Widths that leave lanes empty and that leave none; more than a chunk of marks, and less than a
// batch.
constexpr int kSizes[][2] = {{640, 70}, {333, 65}, {48, 3}, {5, 4}, {2, 2}};

TEST_P(Preparation, HalvesAsCoreDoes) {
  for (const auto& [width, height] : kSizes) {
    const Image<float> depth_m = PatchyDepth(width, height), intensity = Noise(width, height);
    const CpuPreparation::Pyramids made = prepare_.Make({nullptr, &intensity, &depth_m}, 3, 0);
    const CpuPyramid &depths = made.depth_m, &values = made.intensity;
    ASSERT_EQ(depths.size(), 3u);
    EXPECT_EQ(depths[0].get(), &depth_m);
    EXPECT_EQ(values[0].get(), &intensity);
    EXPECT_TRUE(SameBits(*prepare_.Depth(depth_m, 3)[2], *depths[2])) << width;
    EXPECT_TRUE(SameBits(*depths[1], HalvedDepth(depth_m))) << width;
    EXPECT_TRUE(SameBits(*depths[2], HalvedDepth(HalvedDepth(depth_m)))) << width;
    EXPECT_TRUE(SameBits(*values[1], HalvedIntensity(intensity))) << width;
    EXPECT_TRUE(SameBits(*values[2], HalvedIntensity(HalvedIntensity(intensity)))) << width;
  }
}

Image<Rgb8> Colours(int width, int height) {
  const CounterRandom random(4);
  Image<Rgb8> image(width, height);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const auto byte = [&](std::uint64_t k) {
      return std::uint8_t(256 * random.Uniform(3 * i + k));
    };
    image.data()[i] = {byte(0), byte(1), byte(2)};
  }
  return image;
}

// With the gray image itself, and without it.
TEST_P(Preparation, HalvesColoursAsTheirGrayImage) {
  for (const auto& [width, height] : kSizes) {
    const Image<Rgb8> rgb = Colours(width, height);
    const Image<float> gray = GrayFromRgb(rgb);
    const auto want = prepare_.Make({nullptr, &gray, nullptr}, 3, 0);
    const auto all = prepare_.Make({&rgb, nullptr, nullptr}, 3, 0);
    const auto coarse = prepare_.Make({&rgb, nullptr, nullptr}, 3, 1);
    EXPECT_TRUE(SameBits(*all.intensity[0], gray)) << width;
    EXPECT_FALSE(coarse.intensity[0]);
    EXPECT_TRUE(all.depth_m.empty());
    for (const int level : {1, 2}) {
      EXPECT_TRUE(SameBits(*all.intensity[level], *want.intensity[level])) << width;
      EXPECT_TRUE(SameBits(*coarse.intensity[level], *want.intensity[level])) << width;
    }
  }
}

// Levels of different margins at once, as each of them alone.
TEST_P(Preparation, KeepsSeveralLevelsAtOnce) {
  const Image<float> fine_m = PatchyDepth(333, 265), coarse_m = PatchyDepth(160, 120);
  const auto both = prepare_.AwayFromEdges({{&fine_m, nullptr, 2}, {&coarse_m, nullptr, 1}},
                                           {true, false, false});
  const auto fine = AwayFromEdges(fine_m, nullptr, 2, {true, false, false});
  const auto coarse = AwayFromEdges(coarse_m, nullptr, 1, {true, false, false});
  EXPECT_TRUE(SameBits(*both[0].depth_m, *fine.depth_m));
  EXPECT_TRUE(SameBits(*both[1].depth_m, *coarse.depth_m));
  EXPECT_EQ(both[0].measured, fine.measured);
  EXPECT_EQ(both[1].measured, coarse.measured);
}

TEST_P(Preparation, KeepsWhatLiesAwayFromEdges) {
  for (const auto& [width, height] : kSizes) {
    for (const int margin : {0, 1, 2, 5, 100}) {
      const Image<float> depth_m = PatchyDepth(width, height), intensity = Noise(width, height);
      const Image<std::uint8_t> edges =
          margin > 0 ? Edges(depth_m, margin) : Image<std::uint8_t>(width, height);
      Image<float> kept_m = depth_m, inverse = depth_m, kept = intensity;
      for (std::size_t i = 0; i < kept.size(); ++i) {
        float& z = kept_m.data()[i];
        if (edges.data()[i]) z = 0;
        inverse.data()[i] = IsMeasured(z) ? 1 / z : kNaN;
        if (z == 0 && depth_m.data()[i] != 0) kept.data()[i] = kNaN;
      }
      const auto got = AwayFromEdges(depth_m, &intensity, margin, {true, true, true});
      EXPECT_TRUE(SameBits(*got.depth_m, kept_m)) << width << " " << margin;
      EXPECT_TRUE(SameBits(*got.inverse_depth, inverse)) << width << " " << margin;
      EXPECT_TRUE(SameBits(*got.intensity, kept)) << width << " " << margin;
      EXPECT_EQ(got.measured, std::count_if(kept_m.begin(), kept_m.end(), IsMeasured));
    }
  }
}

TEST_P(Preparation, GivesNothingUnasked) {
  const auto got = AwayFromEdges(PatchyDepth(48, 30), nullptr, 1, {false, true, false});
  EXPECT_FALSE(got.depth_m);
  EXPECT_TRUE(got.inverse_depth);
  EXPECT_FALSE(got.intensity);
}

TEST_P(Preparation, OwnedCopiesStay) {
  const Image<float> image = Noise(333, 100);
  const CpuLevel copy = prepare_.Own(image);
  EXPECT_NE(copy.get(), &image);
  EXPECT_TRUE(SameBits(*copy, image));
}

INSTANTIATE_TEST_SUITE_P(Levels, Preparation, testing::ValuesIn(SupportedSimdLevels()),
                         [](const auto& level) { return Name(level.param); });

}  // namespace
}  // namespace silt::tracker
