// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_reduction.h"

#include <algorithm>
#include <vector>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/sums.h"
#include "silt/tracker/simd.h"

namespace silt::tracker {
namespace {

using Batch = FloatBatch;
using BatchMask = kernel::Mask<Batch>;

// Rows of a tile: the unit of work of a thread, and of the order of summation.
constexpr int kTileRows = 8;

double LaneSum(const Batch& batch) {
  alignas(64) float lanes[kLanes];
  batch.store_aligned(lanes);
  double sum = 0;
  for (float lane : lanes) sum += double(lane);
  return sum;
}

// The sums of a row are those of its lanes, in single precision; these add up rows and tiles.
void AddTo(PhotometricCost* total, const kernel::CostSums<Batch>& row) {
  total->sum += 0.5 * LaneSum(row.squares);
  total->pixels += std::int64_t(LaneSum(row.count));
}

void AddTo(NormalEquations* total, const kernel::Sums<Batch>& row) {
  for (int i = 0; i < kernel::kHessianSize; ++i) total->hessian[i] += LaneSum(row.hessian[i]);
  for (int i = 0; i < kernel::kGradientSize; ++i) total->gradient[i] += LaneSum(row.gradient[i]);
  AddTo(&total->cost, row.cost);
}

void AddTo(PhotometricCost* total, const PhotometricCost& tile) {
  total->sum += tile.sum;
  total->pixels += tile.pixels;
}

void AddTo(NormalEquations* total, const NormalEquations& tile) {
  for (int i = 0; i < kernel::kHessianSize; ++i) total->hessian[i] += tile.hessian[i];
  for (int i = 0; i < kernel::kGradientSize; ++i) total->gradient[i] += tile.gradient[i];
  AddTo(&total->cost, tile.cost);
}

// Batch k of a row; lanes beyond its end are 0, which as a depth is no measurement.
Batch LoadRow(const float* row, int x, int width) {
  if (x + kLanes <= width) return Batch::load_unaligned(row + x);
  alignas(64) float lanes[kLanes] = {};
  std::copy(row + x, row + width, lanes);
  return Batch::load_aligned(lanes);
}

Batch LaneIndices() {
  alignas(64) float lanes[kLanes];
  for (int i = 0; i < kLanes; ++i) lanes[i] = float(i);
  return Batch::load_aligned(lanes);
}

struct LevelKernel {
  explicit LevelKernel(const LevelImages& level, const SE3d& current_from_reference)
      : images(level),
        warp(kernel::Warp<double>(current_from_reference, level.camera)),
        sampler{level.current_intensity.data(), level.camera.width, level.camera.height} {}

  kernel::ReferencePixel<Batch> Pixels(int x, int y) const {
    const int width = images.camera.width;
    return {Batch(float(x)) + lane_indices, Batch(float(y)),
            LoadRow(images.reference_depth_m.row(y), x, width),
            LoadRow(images.reference_intensity.row(y), x, width)};
  }

  kernel::CostSums<Batch> CostOfRow(int y) const {
    kernel::CostSums<Batch> sums;
    for (int x = 0; x < images.camera.width; x += kLanes) {
      BatchMask valid;
      const Batch residual = kernel::Residual(warp, sampler, Pixels(x, y), &valid);
      sums.Add(residual, valid);
    }
    return sums;
  }

  kernel::Sums<Batch> EquationsOfRow(int y) const {
    kernel::Sums<Batch> sums;
    for (int x = 0; x < images.camera.width; x += kLanes) {
      sums.Add(kernel::Linearize(warp, sampler, Pixels(x, y)));
    }
    return sums;
  }

  const LevelImages& images;
  kernel::Warp<Batch> warp;
  BatchSampler sampler;
  Batch lane_indices = LaneIndices();
};

// Adds sums_of_row(y) over all rows: tile by tile in parallel, then the tiles in order.
template <typename Total, typename SumsOfRow>
Total ReduceRows(int rows, const SumsOfRow& sums_of_row) {
  std::vector<Total> tiles((rows + kTileRows - 1) / kTileRows);
  ParallelFor(int(tiles.size()), [&](int tile) {
    const int end = std::min(rows, (tile + 1) * kTileRows);
    for (int y = tile * kTileRows; y < end; ++y) AddTo(&tiles[tile], sums_of_row(y));
  });
  Total total;
  for (const Total& tile : tiles) AddTo(&total, tile);
  return total;
}

// No pixel of a smaller image has four pixels around it.
bool HoldsTaps(const PinholeCamera& camera) { return camera.width >= 2 && camera.height >= 2; }

}  // namespace

PhotometricCost ReduceCost(const LevelImages& images, const SE3d& current_from_reference) {
  if (!HoldsTaps(images.camera)) return {};
  const LevelKernel level(images, current_from_reference);
  return ReduceRows<PhotometricCost>(images.camera.height,
                                     [&](int y) { return level.CostOfRow(y); });
}

NormalEquations ReduceEquations(const LevelImages& images, const SE3d& current_from_reference) {
  if (!HoldsTaps(images.camera)) return {};
  const LevelKernel level(images, current_from_reference);
  return ReduceRows<NormalEquations>(images.camera.height,
                                     [&](int y) { return level.EquationsOfRow(y); });
}

}  // namespace silt::tracker
