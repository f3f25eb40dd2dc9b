// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_preparation.h"

#include <algorithm>
#include <functional>

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

static_assert(sizeof(Rgb8) == 3);

using Buffer = std::shared_ptr<Image<float>>;

float* DataOf(const Buffer& buffer) { return buffer ? buffer->data() : nullptr; }

// Calls work(begin, end) for all tiles of rows of an image. A std::function that refers to its
// target, rather than holding it, needs no memory.
template <typename Work>
void ForTiles(int width, int height, int tile_rows, const Work& work) {
  const auto tile = [&](int i) { work(i * tile_rows, std::min(height, (i + 1) * tile_rows)); };
  const int tiles = (height + tile_rows - 1) / tile_rows;
  if (width * height > kFewPixels) return ParallelFor(tiles, std::cref(tile));
  for (int i = 0; i < tiles; ++i) tile(i);
}

}  // namespace

CpuPreparation::CpuPreparation(SimdLevel level)
    : kernels_(KernelsOf(level)), pool_(std::make_shared<ImagePool>()) {}

// The images of all levels that are made; null where they are not.
struct CpuPreparation::Buffers {
  PooledVector<Buffer> intensity, depth_m;
};

CpuPreparation::Buffers CpuPreparation::BuffersFor(const Source& source, int levels,
                                                   int finest) const {
  Buffers buffers{PooledVector<Buffer>(std::size_t(levels)), {}};
  if (source.depth_m) buffers.depth_m.resize(std::size_t(levels));
  for (int level = 0; level < levels; ++level) {
    const int width = source.width() >> level, height = source.height() >> level;
    if (level > 0 || (source.rgb && finest == 0)) buffers.intensity[level] = Take(width, height);
    if (level > 0 && source.depth_m) buffers.depth_m[level] = Take(width, height);
  }
  return buffers;
}

// What rows [begin, end) of the finest level give at all levels, while they are in the cache.
void CpuPreparation::MakeRows(const Source& source, const Buffers& buffers, int begin,
                              int end) const {
  const int width = source.width(), height = source.height();
  const float* intensity = source.gray ? source.gray->data() : DataOf(buffers.intensity[0]);
  const float* depth_m = source.depth_m ? source.depth_m->data() : nullptr;
  if (source.rgb && intensity) {
    kernels_.gray({&source.rgb->data()->r, DataOf(buffers.intensity[0]), width}, begin, end);
  }
  for (std::size_t level = 1; level < buffers.intensity.size(); ++level) {
    const int first = begin >> level, last = (end == height ? height : end) >> level;
    float* const half = DataOf(buffers.intensity[level]);
    if (level > 1 || intensity) {
      kernels_.halve_intensity({intensity, half, width >> (level - 1)}, first, last);
    } else {
      kernels_.halve_gray({&source.rgb->data()->r, half, width}, first, last);
    }
    intensity = half;
    if (!source.depth_m) continue;
    float* const half_m = DataOf(buffers.depth_m[level]);
    kernels_.halve_depth({depth_m, half_m, width >> (level - 1)}, first, last);
    depth_m = half_m;
  }
}

CpuPreparation::Pyramids CpuPreparation::Make(const Source& source, int levels, int finest) const {
  const Buffers buffers = BuffersFor(source, levels, finest);
  // No row of a coarse level has a part in two tiles.
  const int tile_rows = std::max(kTileRows, 1 << (levels - 1));
  ForTiles(source.width(), source.height(), tile_rows,
           [&](int begin, int end) { MakeRows(source, buffers, begin, end); });
  Pyramids made{{buffers.intensity.begin(), buffers.intensity.end()},
                {buffers.depth_m.begin(), buffers.depth_m.end()}};
  if (source.gray) made.intensity[0] = CpuLevel(CpuLevel(), source.gray);
  if (source.depth_m) made.depth_m[0] = CpuLevel(CpuLevel(), source.depth_m);
  return made;
}

CpuPyramid CpuPreparation::Depth(const Image<float>& finest_m, int levels) const {
  CpuPyramid pyramid{CpuLevel(CpuLevel(), &finest_m)};
  for (int level = 1; level < levels; ++level) {
    const Image<float>& fine = *pyramid.back();
    const Buffer half = Take(fine.width() / 2, fine.height() / 2);
    const simd::HalvedView view{fine.data(), half->data(), fine.width()};
    ForTiles(half->width(), half->height(), kTileRows,
             [&](int begin, int end) { kernels_.halve_depth(view, begin, end); });
    pyramid.push_back(half);
  }
  return pyramid;
}

CpuLevel CpuPreparation::Own(const Image<float>& image) const {
  const auto copy = Take(image.width(), image.height());
  ForTiles(image.width(), image.height(), kTileRows, [&](int begin, int end) {
    const std::size_t row = std::size_t(image.width());
    std::copy_n(image.data() + begin * row, (end - begin) * row, copy->data() + begin * row);
  });
  return copy;
}

namespace {

// A tile of a level's rows.
struct EdgeTile {
  std::size_t level;
  int begin, end;
};

PooledVector<EdgeTile> TilesOf(const PooledVector<simd::EdgeView>& views) {
  PooledVector<EdgeTile> tiles;
  for (std::size_t level = 0; level < views.size(); ++level) {
    const int height = views[level].height;
    for (int y = 0; y < height; y += kTileRows) {
      tiles.push_back({level, y, std::min(height, y + kTileRows)});
    }
  }
  return tiles;
}

// Marks reach into other tiles.
bool ReachesOut(const simd::EdgeView& view) { return view.marks && view.reach > 0; }

// Calls work(i) for all tiles.
template <typename Work>
void ForTiles(const PooledVector<simd::EdgeView>& views, const PooledVector<EdgeTile>& tiles,
              const Work& work) {
  int pixels = 0;
  for (const simd::EdgeView& view : views) pixels += view.width * view.height;
  if (pixels > kFewPixels) return ParallelFor(int(tiles.size()), std::cref(work));
  for (int i = 0; i < int(tiles.size()); ++i) work(i);
}

}  // namespace

PooledVector<CpuPreparation::Kept> CpuPreparation::AwayFromEdges(const PooledVector<Level>& levels,
                                                                 const Wanted& wanted) const {
  PooledVector<Kept> all;
  PooledVector<Buffer> marks;
  PooledVector<simd::EdgeView> views;
  for (const Level& level : levels) {
    SILT_CHECK(!wanted.intensity || level.intensity != nullptr);
    const int width = level.depth_m->width(), height = level.depth_m->height();
    const auto take = [&](bool needed) { return needed ? Take(width, height) : Buffer(); };
    const Buffer depth_m = take(wanted.depth), inverse_depth = take(wanted.inverse_depth),
                 intensity = take(wanted.intensity);
    marks.push_back(take(level.margin_px > 0));
    views.push_back({width, height, std::clamp(level.margin_px - 1, 0, simd::kMaxEdgeReach),
                     level.depth_m->data(), level.intensity ? level.intensity->data() : nullptr,
                     DataOf(marks.back()), DataOf(depth_m), DataOf(inverse_depth),
                     DataOf(intensity)});
    all.push_back({depth_m, inverse_depth, intensity, 0});
  }
  const PooledVector<EdgeTile> tiles = TilesOf(views);
  const auto mark = [&](int i) {
    kernels_.mark_edges(views[tiles[i].level], tiles[i].begin, tiles[i].end);
  };
  if (std::any_of(views.begin(), views.end(), ReachesOut)) {
    ForTiles(views, tiles, [&](int i) {
      if (ReachesOut(views[tiles[i].level])) mark(i);
    });
  }
  PooledVector<int> measured(tiles.size());
  ForTiles(views, tiles, [&](int i) {
    const simd::EdgeView& view = views[tiles[i].level];
    if (view.marks && !ReachesOut(view)) mark(i);
    measured[i] = kernels_.keep(view, tiles[i].begin, tiles[i].end);
  });
  for (std::size_t i = 0; i < tiles.size(); ++i) all[tiles[i].level].measured += measured[i];
  return all;
}

}  // namespace silt::tracker
