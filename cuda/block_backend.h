// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/cuda/block_pyramids.h"
#include "silt/cuda/linearize_body.h"
#include "silt/cuda/visibility_bodies.h"
#include "silt/tracker/backend.h"

namespace silt::cuda {

// The tracker's backend whose kernels run in blocks of threads, on any machine that offers
//   Array<T>(machine, size) with data() and size(),  Upload(values, array),  Download(array),
//   Run(grid, body):
// a GPU, or a CPU that stands in for one. Sums have the same bits on both but for how they divide
// and take roots; the order of addition depends on the size of the image alone.
template <typename Machine>
class BlockBackend : public tracker::Backend {
 public:
  BlockBackend(std::string name, Machine machine)
      : name_(std::move(name)), machine_(std::move(machine)), imaging_(machine_) {}

  std::string name() const override { return name_; }

  std::unique_ptr<tracker::ReferencePyramid> MakeReference(
      const Image<float>& intensity, const Image<float>& depth_m, const PinholeCamera& camera,
      const tracker::PyramidOptions& options) const override {
    SILT_CHECK(intensity.width() == camera.width && intensity.height() == camera.height);
    SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
    return std::make_unique<Reference>(imaging_, intensity, depth_m, camera, options);
  }

  std::unique_ptr<tracker::CurrentPyramid> MakeCurrent(
      const Image<float>& intensity, const Image<float>& depth_m,
      const tracker::PyramidOptions& options) const override {
    SILT_CHECK(depth_m.empty() ||
               (depth_m.width() == intensity.width() && depth_m.height() == intensity.height()));
    return std::make_unique<Current>(imaging_, intensity, depth_m, options);
  }

  std::unique_ptr<tracker::ReferencePyramid> WithoutHidden(
      const tracker::ImagePair& pair, int level,
      const SE3d& current_from_reference) const override {
    const auto& full = dynamic_cast<const Reference&>(pair.reference);
    if (!pair.current.has_depth()) {
      Picture visible =
          HiddenByItself(full.depth_m[0], full.levels()[0].camera, current_from_reference);
      return std::make_unique<Reference>(
          full, imaging_.template Halvings<HalveDepth>(std::move(visible), level + 1));
    }
    const auto& current = dynamic_cast<const Current&>(pair.current);
    CheckLevel(full, current, level);
    Pyramid depths_m = full.depth_m;
    depths_m[level] = HiddenByCurrent(full.depth_m[level], current.depth_m[level],
                                      WarpOf(full.levels()[level].camera, current_from_reference));
    return std::make_unique<Reference>(full, std::move(depths_m));
  }

  tracker::PhotometricCost Cost(const tracker::ImagePair& pair, int level,
                                const SE3d& current_from_reference) const override {
    return CostOf(Reduce<Residuals::kCost>(pair, level, current_from_reference, {}));
  }

  tracker::NormalEquations Linearize(const tracker::ImagePair& pair, int level,
                                     const SE3d& current_from_reference,
                                     const tracker::ResidualNorm& norm) const override {
    if (norm.use_depth) {
      return EquationsOf(
          Reduce<Residuals::kRobustWithDepth>(pair, level, current_from_reference, norm), norm);
    }
    return EquationsOf(norm.robust()
                           ? Reduce<Residuals::kRobust>(pair, level, current_from_reference, norm)
                           : Reduce<Residuals::kSquares>(pair, level, current_from_reference, norm),
                       norm);
  }

 private:
  using Reference = BlockReference<Machine>;
  using Current = BlockCurrent<Machine>;
  using Picture = BlockImage<Machine>;
  using Pyramid = typename BlockImaging<Machine>::Pyramid;
  using Doubles = typename Machine::template Array<double>;
  static constexpr int kPixelsPerThread = 4;

  static kernel::Warp<float> WarpOf(const PinholeCamera& camera, const SE3d& pose) {
    return kernel::Warp<float>(kernel::Warp<double>(pose, camera));
  }

  static void CheckLevel(const Reference& reference, const Current& current, int level) {
    SILT_CHECK(level >= 0 && level < int(reference.depth_m.size()));
    SILT_CHECK(level < int(current.intensity.size()));
    SILT_CHECK(current.intensity[level].width == reference.depth_m[level].width &&
               current.intensity[level].height == reference.depth_m[level].height);
  }

  Picture HiddenByCurrent(const Picture& depth_m, const Picture& current_depth_m,
                          const kernel::Warp<float>& warp) const {
    Picture visible(machine_, depth_m.width, depth_m.height);
    imaging_.Each(visible.size(), HideBehindCurrent{warp, depth_m.data(), current_depth_m.data(),
                                                    depth_m.width, depth_m.height, visible.data()});
    return visible;
  }

  Picture HiddenByItself(const Picture& depth_m, const PinholeCamera& camera,
                         const SE3d& current_from_reference) const {
    const kernel::Warp<float> warp = WarpOf(camera, current_from_reference);
    const int width = depth_m.width, height = depth_m.height;
    const kernel::CellGrid cells = kernel::CellsOf(width, height);
    Picture nearest(machine_, cells.columns, cells.rows);
    Picture spread(machine_, cells.columns, cells.rows);
    Picture visible(machine_, width, height);
    imaging_.Each(nearest.size(), EmptyCells{nearest.data()});
    imaging_.Each(visible.size(), FillCells{warp, depth_m.data(), width, height, nearest.data()});
    imaging_.Each(spread.size(), SpreadCells{nearest.data(), cells, spread.data()});
    imaging_.Each(visible.size(), HideBehindCells{warp, depth_m.data(), spread.data(), width,
                                                  height, visible.data()});
    return visible;
  }

  static float InverseSquare(double x) { return x > 0 ? float(1 / (x * x)) : 0.0f; }
  static kernel::RobustNorm<float> NormOf(const tracker::RobustBounds& bounds) {
    return {InverseSquare(bounds.gradient), InverseSquare(bounds.scale),
            float(std::sqrt(bounds.weight))};
  }

  template <Residuals kKind>
  std::vector<double> Reduce(const tracker::ImagePair& pair, int level,
                             const SE3d& current_from_reference,
                             const tracker::ResidualNorm& norm) const {
    const auto& reference = dynamic_cast<const Reference&>(pair.reference);
    const auto& current = dynamic_cast<const Current&>(pair.current);
    CheckLevel(reference, current, level);
    SILT_CHECK(!norm.use_depth || !current.inverse_depth.empty());
    const Picture& depth_m = reference.depth_m[level];
    const int width = depth_m.width, height = depth_m.height;
    // No pixel of a smaller image has four pixels around it.
    if (width < 2 || height < 2) return std::vector<double>(kSums);
    const float* inverse_depth = norm.use_depth ? current.inverse_depth[level].data() : nullptr;
    const Grid grid = GridFor(depth_m.size(), kPixelsPerThread);
    Doubles block_sums(machine_, std::size_t(grid.blocks) * kSums), sums(machine_, kSums);
    machine_.Run(
        grid, LinearizeBody<kKind>{WarpOf(reference.levels()[level].camera, current_from_reference),
                                   width,
                                   height,
                                   reference.intensity[level].data(),
                                   depth_m.data(),
                                   {current.intensity[level].data(), width, height},
                                   {inverse_depth, width, height},
                                   NormOf(norm.intensity),
                                   NormOf(norm.inverse_depth),
                                   block_sums.data()});
    machine_.Run({1, kThreads}, AddBlocks{block_sums.data(), grid.blocks, sums.data()});
    return machine_.Download(sums);
  }

  static tracker::PhotometricCost CostOf(const std::vector<double>& sums) {
    return {0.5 * sums[kSquaresSum], std::int64_t(sums[kCountSum]), sums[kSquaresSum]};
  }

  static tracker::NormalEquations EquationsOf(const std::vector<double>& sums,
                                              const tracker::ResidualNorm& norm) {
    tracker::NormalEquations equations;
    for (std::size_t k = 0; k < equations.hessian.size(); ++k) equations.hessian[k] = sums[k];
    for (std::size_t k = 0; k < equations.gradient.size(); ++k) {
      equations.gradient[k] = sums[equations.hessian.size() + k];
    }
    equations.cost = CostOf(sums);
    if (!norm.robust()) return equations;
    equations.intensity = {sums[kRobustSum], std::int64_t(sums[kCountSum])};
    equations.inverse_depth = {sums[kDepthRobustSum], std::int64_t(sums[kDepthCountSum])};
    equations.cost.sum = 0.5 * (norm.intensity.weight * equations.intensity.squares +
                                norm.inverse_depth.weight * equations.inverse_depth.squares);
    return equations;
  }

  std::string name_;
  Machine machine_;
  BlockImaging<Machine> imaging_;
};

}  // namespace silt::cuda
