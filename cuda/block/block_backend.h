// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/cuda/block/block_alignments.h"
#include "silt/cuda/block/block_pyramids.h"
#include "silt/cuda/block/linearize_body.h"
#include "silt/cuda/block/visibility_bodies.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/pixel_sums.h"

namespace silt::cuda {

// The tracker's backend whose kernels run in blocks of threads, on any machine that offers
//   Array<T>(machine, size) with data() and size(),  Upload(values, array),  Download(array),
//   StartDownload(array), a Coming<T> whose Take() waits for it,  Run(grid, body),  and for whole
//   alignments (BlockAlignments) ResidentBlocks<Body>(),  kStartsOfGroup,  Timer, RunGroups(groups,
//   blocks, body, &timer):
// a GPU, or a CPU that stands in for one. Sums have the same bits on both but for how they divide
// and take roots; the order of addition depends on the size of the image alone.
template <typename Machine>
class BlockBackend : public tracker::Backend {
 public:
  BlockBackend(std::string name, Machine machine)
      : name_(std::move(name)), machine_(std::move(machine)), imaging_(machine_) {}

  std::string name() const override { return name_; }

  void CheckHas(const tracker::AlignmentOptions& options, int joint) const override {
    if (joint > kMaxReferences) {
      throw Error("keyframes.joint: backend " + name_ + " aligns with at most " +
                  std::to_string(kMaxReferences) + " keyframes at once; use backend cpu, or " +
                  std::to_string(kMaxReferences));
    }
    if (options.interpolant != tracker::Interpolant::kBilinear) {
      throw Error("alignment.interpolant: backend " + name_ +
                  " interpolates bilinearly alone; use backend cpu, or interpolant bilinear");
    }
    if (options.reference_gradient > 0) {
      throw Error("alignment.reference_gradient: backend " + name_ +
                  " takes gradients from the current image alone; use backend cpu, or 0");
    }
    if (options.affine_brightness) {
      throw Error("alignment.affine_brightness: backend " + name_ +
                  " does not have it; use backend cpu, or leave it out");
    }
  }

  std::unique_ptr<tracker::ReferencePyramid> MakeReference(
      const Image<float>& intensity, const Image<float>& depth_m, const PinholeCamera& camera,
      const tracker::PyramidOptions& options) const override {
    SILT_CHECK(intensity.width() == camera.width && intensity.height() == camera.height);
    SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
    const Pyramid depths_m = Depths(depth_m, options);
    return std::make_unique<Reference>(
        imaging_, Intensities(imaging_.Upload(intensity), options), depths_m,
        imaging_.WithoutEdges(depths_m, options.depth_edge_margin_px), camera,
        options.depth_edge_margin_px);
  }

  std::unique_ptr<tracker::CurrentPyramid> MakeCurrent(
      const Image<float>& intensity, const Image<float>& depth_m,
      const tracker::PyramidOptions& options) const override {
    SILT_CHECK(depth_m.empty() ||
               (depth_m.width() == intensity.width() && depth_m.height() == intensity.height()));
    return std::make_unique<Current>(imaging_, Intensities(imaging_.Upload(intensity), options),
                                     Depths(depth_m, options), options);
  }

  std::unique_ptr<tracker::CurrentPyramid> MakeCurrentOfColour(
      const Image<Rgb8>& rgb, const Image<float>& depth_m,
      const tracker::PyramidOptions& options) const override {
    SILT_CHECK(depth_m.empty() ||
               (depth_m.width() == rgb.width() && depth_m.height() == rgb.height()));
    return std::make_unique<Current>(imaging_, Intensities(imaging_.Gray(rgb), options),
                                     Depths(depth_m, options), options);
  }

  // What the current image has stays where it is. Smaller pictures that keyframes have been asked
  // for, this one will be too: they are counted by then.
  std::unique_ptr<tracker::ReferencePyramid> MakeReferenceOfCurrent(
      const tracker::CurrentPyramid& image, const Image<float>& depth_m,
      const PinholeCamera& camera, const tracker::PyramidOptions& options) const override {
    SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
    const auto& current = dynamic_cast<const Current&>(image);
    const Pyramid whole_m = current.has_depth() ? current.depth_m : Depths(depth_m, options);
    auto reference = std::make_unique<Reference>(
        imaging_, current.whole_intensity, whole_m,
        current.has_depth() ? current.kept_m
                            : imaging_.WithoutEdges(whole_m, options.depth_edge_margin_px),
        camera, options.depth_edge_margin_px);
    for (const typename Reference::SmallKey& key : small_keys_.All()) SmallOf(*reference, key);
    return reference;
  }

  bool halves_what_it_holds() const override { return true; }

  tracker::OwnedPair MakeHalved(const tracker::ImagePair& pair, int halvings, bool with_depth,
                                const tracker::PyramidOptions& options) const override {
    const auto& reference = dynamic_cast<const Reference&>(pair.reference);
    const auto& current = dynamic_cast<const Current&>(pair.current);
    const typename Reference::SmallKey key{halvings, options.levels, options.depth_edge_margin_px};
    small_keys_.Add(key);
    return {SmallOf(reference, key),
            std::make_unique<Current>(imaging_,
                                      imaging_.template HalvingsFrom<HalveIntensity>(
                                          current.whole_intensity, halvings, options.levels),
                                      with_depth && current.has_depth()
                                          ? imaging_.template HalvingsFrom<HalveDepth>(
                                                current.depth_m, halvings, options.levels)
                                          : Pyramid{},
                                      options)};
  }

  std::unique_ptr<tracker::ReferencePyramid> WithoutHidden(
      const tracker::ImagePair& pair, int level,
      const SE3d& current_from_reference) const override {
    const auto& full = dynamic_cast<const Reference&>(pair.reference);
    if (!pair.current.has_depth()) {
      Picture visible = HiddenByItself(full.depth_m[0], full.camera(0), current_from_reference);
      return std::make_unique<Reference>(
          full, imaging_.template Halvings<HalveDepth>(std::move(visible), level + 1));
    }
    const auto& current = dynamic_cast<const Current&>(pair.current);
    CheckLevel(full, current, level);
    Pyramid depths_m = full.depth_m;
    depths_m[level] = HiddenByCurrent(full.depth_m[level], current.depth_m[level],
                                      WarpOf(full.camera(level), current_from_reference));
    return std::make_unique<Reference>(full, std::move(depths_m));
  }

  tracker::PhotometricCost Cost(const tracker::ImagePair& pair, int level,
                                const SE3d& current_from_reference) const override {
    return Costs(pair, level, {current_from_reference}).front();
  }

  std::vector<tracker::PhotometricCost> Costs(const tracker::ImagePair& pair, int level,
                                              const std::vector<SE3d>& poses) const override {
    std::vector<tracker::PhotometricCost> costs;
    for (const ImageSums& image : Reduce(Residuals::kCost, pair, level, poses, {})) {
      costs.push_back(tracker::CostOf(image.sums));
    }
    return costs;
  }

  tracker::NormalEquations Linearize(const tracker::ImagePair& pair, int level,
                                     const SE3d& current_from_reference,
                                     const tracker::ResidualNorm& norm) const override {
    return EquationsOf(
        Reduce(ResidualsOf(norm), pair, level, {current_from_reference}, norm).front(), norm);
  }

  std::vector<tracker::FinishedAlignment> Run(const tracker::AlignmentJobs& jobs) const override {
    for (const tracker::AlignmentJob& job : jobs) {
      if (!Alignments::CanRun(job)) return {};
    }
    return jobs.empty() ? std::vector<tracker::FinishedAlignment>{}
                        : Alignments(machine_).Run(jobs);
  }
  bool runs_alignments() const override { return true; }

  std::unique_ptr<tracker::DeviceClock> StartClock() const override {
    return std::make_unique<Clock>(machine_);
  }

 private:
  using Alignments = BlockAlignments<Machine>;
  using Reference = BlockReference<Machine>;
  using Current = BlockCurrent<Machine>;
  using Picture = BlockImage<Machine>;
  using Pyramid = typename BlockImaging<Machine>::Pyramid;
  using Doubles = typename Machine::template Array<double>;

  Pyramid Intensities(Picture finest, const tracker::PyramidOptions& options) const {
    return imaging_.template Halvings<HalveIntensity>(std::move(finest), options.levels);
  }
  // All of them; empty where `depth_m` is.
  Pyramid Depths(const Image<float>& depth_m, const tracker::PyramidOptions& options) const {
    if (depth_m.empty()) return {};
    return imaging_.template Halvings<HalveDepth>(imaging_.Upload(depth_m), options.levels);
  }

  // Of the keyframe as it is, where that has such levels itself.
  std::unique_ptr<const Reference> SmallOf(const Reference& reference,
                                           const typename Reference::SmallKey& key) const {
    const auto [halvings, levels, edge_margin_px] = key;
    if (halvings == 0 && levels <= int(reference.depth_m.size()) &&
        edge_margin_px == reference.edge_margin_px) {
      return std::make_unique<const Reference>(reference, std::size_t(levels));
    }
    return reference.Small(key, [&] {
      PinholeCamera camera = reference.camera(0);
      for (int i = 0; i < halvings; ++i) camera = camera.Halved();
      const Pyramid depths_m =
          imaging_.template HalvingsFrom<HalveDepth>(reference.whole_depth_m, halvings, levels);
      return std::make_unique<const Reference>(
          imaging_,
          imaging_.template HalvingsFrom<HalveIntensity>(reference.intensity, halvings, levels),
          depths_m, imaging_.WithoutEdges(depths_m, edge_margin_px), camera, edge_margin_px);
    });
  }

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

  // The sums at each pose.
  std::vector<ImageSums> Reduce(Residuals kind, const tracker::ImagePair& pair, int level,
                                const std::vector<SE3d>& poses,
                                const tracker::ResidualNorm& norm) const {
    const auto& reference = dynamic_cast<const Reference&>(pair.reference);
    const auto& current = dynamic_cast<const Current&>(pair.current);
    CheckLevel(reference, current, level);
    SILT_CHECK(!norm.use_depth || !current.inverse_depth.empty());
    const int width = reference.depth_m[level].width, height = reference.depth_m[level].height;
    // No pixel of a smaller image has four pixels around it.
    if (width < 2 || height < 2) return std::vector<ImageSums>(poses.size());
    const float* inverse_depth = norm.use_depth ? current.inverse_depth[level].data() : nullptr;
    PixelPass pass{{},
                   reference.intensity[level].data(),
                   reference.depth_m[level].data(),
                   {current.intensity[level].data(), width, height},
                   {inverse_depth, width, height},
                   tracker::FloatNorm<kernel::RobustNorm<float>>(norm.intensity),
                   tracker::FloatNorm<kernel::RobustNorm<float>>(norm.inverse_depth)};
    typename Machine::template Array<ImageSums> images(machine_, poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      pass.warp = WarpOf(reference.camera(level), poses[i]);
      StartReduction(kind, pass, TilingOf(width, height), images.data() + i);
    }
    return machine_.Download(images);
  }

  void StartReduction(Residuals kind, const PixelPass& pass, const Tiling& tiling,
                      ImageSums* image) const {
    Doubles unit_sums(machine_, std::size_t(tiling.units()) * kSums);
    Doubles tile_sums(machine_, std::size_t(tiling.tiles) * kSums);
    machine_.Run({tiling.units(), kThreads}, LinearizeBody{pass, kind, tiling, unit_sums.data()});
    machine_.Run({1, kThreads}, AddUnits{tiling, unit_sums.data(), tile_sums.data(), image});
  }

  class Clock : public tracker::DeviceClock {
   public:
    explicit Clock(const Machine& machine) : machine_(machine) { machine_.Start(&timer_); }
    double Milliseconds() override {
      machine_.Stop(&timer_);
      return timer_.Milliseconds();
    }

   private:
    const Machine machine_;
    typename Machine::Timer timer_;
  };

  // What was asked for since the backend is there.
  class SmallKeys {
   public:
    using Key = typename Reference::SmallKey;
    void Add(const Key& key) {
      const std::lock_guard lock(mutex_);
      keys_.insert(key);
    }
    std::set<Key> All() const {
      const std::lock_guard lock(mutex_);
      return keys_;
    }

   private:
    mutable std::mutex mutex_;
    std::set<Key> keys_;
  };

  std::string name_;
  Machine machine_;
  BlockImaging<Machine> imaging_;
  mutable SmallKeys small_keys_;
};

}  // namespace silt::cuda
