// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_preparation.h"

#include <algorithm>
#include <numeric>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/core/pyramid.h"

namespace silt::tracker {
namespace {

constexpr int kTileRows = 32;
// Waking another thread takes longer than so few pixels.
constexpr int kFewPixels = 20000;

simd::PreparationKernels KernelsOf(SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::kAvx512) return simd::Avx512Preparation();
  if (level == SimdLevel::kAvx2) return simd::Avx2Preparation();
#endif
  SILT_CHECK(level == SimdLevel::kBaseline);
  return simd::BaselinePreparation();
}

int Tiles(int height) { return (height + kTileRows - 1) / kTileRows; }

// Calls work(tile, begin, end) for all tiles of rows of an image.
template <typename Work>
void ForTiles(int width, int height, const Work& work) {
  const auto tile = [&](int i) { work(i, i * kTileRows, std::min(height, (i + 1) * kTileRows)); };
  const int tiles = Tiles(height);
  if (width * height > kFewPixels) return ParallelFor(tiles, tile);
  for (int i = 0; i < tiles; ++i) tile(i);
}

}  // namespace

CpuPreparation::CpuPreparation(SimdLevel level)
    : kernels_(KernelsOf(level)), pool_(std::make_shared<ImagePool>()) {}

CpuPyramid CpuPreparation::Halved(const Image<float>& finest, int levels, Halve halve) const {
  CpuPyramid pyramid{CpuLevel(CpuLevel(), &finest)};
  for (int level = 1; level < levels; ++level) {
    const Image<float>& fine = *pyramid.back();
    const auto half = Take(fine.width() / 2, fine.height() / 2);
    const simd::HalvedView view{fine.data(), half->data(), fine.width(), kSameSurface};
    ForTiles(half->width(), half->height(),
             [&](int, int begin, int end) { halve(view, begin, end); });
    pyramid.push_back(half);
  }
  return pyramid;
}

CpuPyramid CpuPreparation::Intensity(const Image<float>& finest, int levels) const {
  return Halved(finest, levels, kernels_.halve_intensity);
}

CpuPyramid CpuPreparation::Depth(const Image<float>& finest_m, int levels) const {
  return Halved(finest_m, levels, kernels_.halve_depth);
}

CpuLevel CpuPreparation::Own(const Image<float>& image) const {
  const auto copy = Take(image.width(), image.height());
  ForTiles(image.width(), image.height(), [&](int, int begin, int end) {
    const std::size_t row = std::size_t(image.width());
    std::copy_n(image.data() + begin * row, (end - begin) * row, copy->data() + begin * row);
  });
  return copy;
}

CpuPreparation::Kept CpuPreparation::AwayFromEdges(const Image<float>& depth_m,
                                                   const Image<float>* intensity, int margin_px,
                                                   const Wanted& wanted) const {
  SILT_CHECK(!wanted.intensity || intensity != nullptr);
  const int width = depth_m.width(), height = depth_m.height();
  using Buffer = std::shared_ptr<Image<float>>;
  const auto take = [&](bool needed) { return needed ? Take(width, height) : Buffer(); };
  const Buffer marks = take(margin_px > 0), kept_m = take(wanted.depth),
               inverse_depth = take(wanted.inverse_depth), kept = take(wanted.intensity);
  const auto data = [](const Buffer& buffer) { return buffer ? buffer->data() : nullptr; };
  const simd::EdgeView view{width,
                            height,
                            std::clamp(margin_px - 1, 0, simd::kMaxEdgeReach),
                            depth_m.data(),
                            intensity ? intensity->data() : nullptr,
                            data(marks),
                            data(kept_m),
                            data(inverse_depth),
                            data(kept)};
  if (marks) {
    ForTiles(width, height,
             [&](int, int begin, int end) { kernels_.mark_edges(view, begin, end); });
  }
  std::vector<int> measured(Tiles(height));
  ForTiles(width, height,
           [&](int tile, int begin, int end) { measured[tile] = kernels_.keep(view, begin, end); });
  return {kept_m, inverse_depth, kept, std::accumulate(measured.begin(), measured.end(), 0)};
}

}  // namespace silt::tracker
