// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_reduction.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/warp.h"
#include "silt/tracker/pixel_sums.h"

namespace silt::tracker {
namespace {

// Waking another thread takes longer than the sums over so few pixels.
constexpr int kFewPixels = 5000;

simd::Kernels KernelsOf(SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::kAvx512) return simd::Avx512Kernels();
  if (level == SimdLevel::kAvx2) return simd::Avx2Kernels();
#endif
  SILT_CHECK(level == SimdLevel::kBaseline);
  return simd::BaselineKernels();
}

simd::LevelView ViewOf(const LevelImages& images, const SE3d& current_from_reference,
                       const ResidualNorm& norm = {}) {
  const kernel::Warp<float> warp(kernel::Warp<double>(current_from_reference, images.camera));
  const bool spline = images.interpolant == Interpolant::kBSpline;
  const Vec3f* r = warp.rotation.row;
  const Vec3f& t = warp.translation;
  return {images.camera.width,
          images.camera.height,
          images.reference_intensity.data(),
          images.reference_depth_m.data(),
          images.current_intensity.data(),
          images.current_depth_m ? images.current_depth_m->data() : nullptr,
          images.current_inverse_depth ? images.current_inverse_depth->data() : nullptr,
          {r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z},
          {t.x, t.y, t.z},
          warp.camera.fx,
          warp.camera.fy,
          warp.camera.cx,
          warp.camera.cy,
          warp.inverse_fx,
          warp.inverse_fy,
          FloatNorm<simd::RobustBounds>(norm.intensity),
          FloatNorm<simd::RobustBounds>(norm.inverse_depth),
          float(norm.brightness.gain),
          float(norm.brightness.offset),
          norm.fit_brightness,
          float(norm.reference_gradient),
          images.interpolant != Interpolant::kBilinear,
          spline ? 1.0f : 0.0f,
          spline ? 0.0f : 0.5f};
}

using Sums = std::array<double, kAllSumCount>;

// Adds the lanes of a tile in order.
void AddTo(Sums* total, const simd::LaneSums& tile) {
  for (int k = 0; k < kAllSumCount; ++k) {
    for (const double lane : tile.value[k]) (*total)[k] += lane;
  }
}

int Tiles(const simd::LevelView& view) { return (view.height + kTileRows - 1) / kTileRows; }

// Calls work(tile, begin, end) for all tiles of rows; by reference, so that no std::function needs
// memory for it.
template <typename Work>
void ForTiles(const simd::LevelView& view, const Work& work) {
  const auto tile = [&](int i) {
    work(i, i * kTileRows, std::min(view.height, (i + 1) * kTileRows));
  };
  if (view.width * view.height > kFewPixels) return ParallelFor(Tiles(view), std::cref(tile));
  for (int i = 0; i < Tiles(view); ++i) tile(i);
}

using Scatter = std::array<double, 21>;

void AddStripes(const Sums* tile_sums, int tiles, Scatter* total) {
  for (int first = 0; first < tiles; first += TilesOfStripe(tiles)) {
    for (int k = 0; k < int(total->size()); ++k) {
      (*total)[k] += ScatterOf(tile_sums->data(), tiles, first, k, kAllSumCount);
    }
  }
}

// Sums over all rows: tile by tile in parallel, then the tiles in order.
Sums Reduce(simd::AddRows add_rows, const simd::LevelView& view, Scatter* scatter = nullptr) {
  Sums total{};
  // No pixel of a smaller image has all the pixels around it that it needs.
  const int least = view.cubic ? 4 : 2;
  if (view.width < least || view.height < least) return total;
  // Those of usual images need no memory to be found for them.
  std::array<Sums, 64> few{};
  std::vector<Sums> many(Tiles(view) > int(few.size()) ? Tiles(view) : 0);
  Sums* const tiles = many.empty() ? few.data() : many.data();
  ForTiles(view, [&](int i, int begin, int end) {
    simd::LaneSums tile;
    add_rows(view, begin, end, &tile);
    AddTo(&tiles[i], tile);
  });
  for (int i = 0; i < Tiles(view); ++i) {
    for (int k = 0; k < kAllSumCount; ++k) total[k] += tiles[i][k];
  }
  if (scatter) AddStripes(tiles, Tiles(view), scatter);
  return total;
}

simd::AddRows KernelFor(const simd::Kernels& kernels, const ResidualNorm& norm) {
  if (norm.use_depth) return kernels.add_depth_equations;
  return norm.robust() ? kernels.add_robust_equations : kernels.add_equations;
}

}  // namespace

CpuReduction::CpuReduction(SimdLevel level) : kernels_(KernelsOf(level)) {}

PhotometricCost CpuReduction::Cost(const LevelImages& images,
                                   const SE3d& current_from_reference) const {
  return CostOf(Reduce(kernels_.add_cost, ViewOf(images, current_from_reference)).data());
}

NormalEquations CpuReduction::Equations(const LevelImages& images,
                                        const SE3d& current_from_reference,
                                        const ResidualNorm& norm) const {
  SILT_CHECK(!norm.use_depth || images.current_inverse_depth != nullptr);
  SILT_CHECK(!norm.fit_brightness || norm.robust());
  std::array<double, 21> scatter{};
  const Sums sums =
      Reduce(KernelFor(kernels_, norm), ViewOf(images, current_from_reference, norm), &scatter);
  NormalEquations equations = EquationsOf(sums.data(), norm);
  equations.scatter = scatter;
  if (norm.fit_brightness) {
    equations.brightness = FitBrightness(sums.data() + kBrightnessSum, norm.brightness);
  }
  return equations;
}

void CpuReduction::CopyVisibleDepth(const LevelImages& images, const SE3d& current_from_reference,
                                    Image<float>* visible_m) const {
  SILT_CHECK(images.current_depth_m != nullptr);
  const simd::LevelView view = ViewOf(images, current_from_reference);
  SILT_CHECK(visible_m->width() == view.width && visible_m->height() == view.height);
  ForTiles(view, [&](int, int begin, int end) {
    kernels_.copy_visible(view, begin, end, visible_m->data());
  });
}

}  // namespace silt::tracker
