// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_reduction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/warp.h"

namespace silt::tracker {
namespace {

// Rows of a tile: the unit of work of a thread, and of the order of summation.
constexpr int kTileRows = 8;

simd::Kernels KernelsOf(SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::kAvx512) return simd::Avx512Kernels();
  if (level == SimdLevel::kAvx2) return simd::Avx2Kernels();
#endif
  SILT_CHECK(level == SimdLevel::kBaseline);
  return simd::BaselineKernels();
}

// 1/x², where 0 stands for infinity.
float InverseSquare(double x) { return x > 0 ? float(1 / (x * x)) : 0.0f; }

simd::RobustBounds FloatBounds(const RobustBounds& bounds) {
  return {InverseSquare(bounds.gradient), InverseSquare(bounds.scale),
          float(std::sqrt(bounds.weight))};
}

simd::LevelView ViewOf(const LevelImages& images, const SE3d& current_from_reference,
                       const ResidualNorm& norm = {}) {
  const kernel::Warp<float> warp(kernel::Warp<double>(current_from_reference, images.camera));
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
          FloatBounds(norm.intensity),
          FloatBounds(norm.inverse_depth)};
}

using Sums = std::array<double, simd::kSumCount>;

// Adds the lanes of a tile in order.
void AddTo(Sums* total, const simd::LaneSums& tile) {
  for (int k = 0; k < simd::kSumCount; ++k) {
    for (const double lane : tile.value[k]) (*total)[k] += lane;
  }
}

// Sums over all rows: tile by tile in parallel, then the tiles in order.
Sums Reduce(simd::AddRows add_rows, const simd::LevelView& view) {
  Sums total{};
  const int rows = view.height;
  // No pixel of a smaller image has four pixels around it.
  if (view.width < 2 || rows < 2) return total;
  std::vector<Sums> tiles((rows + kTileRows - 1) / kTileRows);
  ParallelFor(int(tiles.size()), [&](int i) {
    simd::LaneSums tile;
    add_rows(view, i * kTileRows, std::min(rows, (i + 1) * kTileRows), &tile);
    AddTo(&tiles[i], tile);
  });
  for (const Sums& tile : tiles) {
    for (int k = 0; k < simd::kSumCount; ++k) total[k] += tile[k];
  }
  return total;
}

PhotometricCost CostOf(const Sums& sums) {
  return {0.5 * sums[simd::kSquaresSum], std::int64_t(sums[simd::kCountSum]),
          sums[simd::kSquaresSum]};
}

simd::AddRows KernelFor(const simd::Kernels& kernels, const ResidualNorm& norm) {
  if (norm.use_depth) return kernels.add_depth_equations;
  return norm.robust() ? kernels.add_robust_equations : kernels.add_equations;
}

}  // namespace

CpuReduction::CpuReduction(SimdLevel level) : kernels_(KernelsOf(level)) {}

PhotometricCost CpuReduction::Cost(const LevelImages& images,
                                   const SE3d& current_from_reference) const {
  return CostOf(Reduce(kernels_.add_cost, ViewOf(images, current_from_reference)));
}

NormalEquations CpuReduction::Equations(const LevelImages& images,
                                        const SE3d& current_from_reference,
                                        const ResidualNorm& norm) const {
  SILT_CHECK(!norm.use_depth || images.current_inverse_depth != nullptr);
  const Sums sums = Reduce(KernelFor(kernels_, norm), ViewOf(images, current_from_reference, norm));
  NormalEquations equations;
  std::copy_n(sums.begin(), equations.hessian.size(), equations.hessian.begin());
  std::copy_n(sums.begin() + equations.hessian.size(), equations.gradient.size(),
              equations.gradient.begin());
  equations.cost = CostOf(sums);
  if (!norm.robust()) return equations;
  equations.intensity = {sums[simd::kRobustSum], std::int64_t(sums[simd::kCountSum])};
  equations.inverse_depth = {sums[simd::kDepthRobustSum], std::int64_t(sums[simd::kDepthCountSum])};
  equations.cost.sum = 0.5 * (norm.intensity.weight * equations.intensity.squares +
                              norm.inverse_depth.weight * equations.inverse_depth.squares);
  return equations;
}

Image<float> CpuReduction::VisibleDepth(const LevelImages& images,
                                        const SE3d& current_from_reference) const {
  SILT_CHECK(images.current_depth_m != nullptr);
  const simd::LevelView view = ViewOf(images, current_from_reference);
  Image<float> visible(view.width, view.height);
  ParallelFor((view.height + kTileRows - 1) / kTileRows, [&](int i) {
    const int end = std::min(view.height, (i + 1) * kTileRows);
    kernels_.copy_visible(view, i * kTileRows, end, visible.data());
  });
  return visible;
}

}  // namespace silt::tracker
