// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/cuda/block/pyramid_bodies.h"
#include "silt/tracker/backend.h"

namespace silt::cuda {

// An image in a machine's memory. Levels are shared between pyramids that differ in some of them.
template <typename Machine>
struct BlockImage {
  using Floats = typename Machine::template Array<float>;
  int width = 0, height = 0;
  std::shared_ptr<Floats> pixels;

  BlockImage(const Machine& machine, int columns, int rows)
      : width(columns),
        height(rows),
        pixels(std::make_shared<Floats>(machine, std::size_t(columns) * std::size_t(rows))) {}
  int size() const { return width * height; }
  float* data() const { return pixels->data(); }
};

// How many depths of each level are measured. They are counted where the depths lie, while the host
// goes on; whoever looks first waits.
template <typename Machine>
class MeasuredCounts {
 public:
  using Coming = typename Machine::template Coming<int>;

  MeasuredCounts(const DepthLevels& levels, Coming of_blocks)
      : levels_(levels), of_blocks_(std::move(of_blocks)) {}

  int Of(std::size_t level) const {
    std::call_once(summed_, [this] {
      const std::vector<int> of_blocks = of_blocks_.Take();
      for (int i = 0; i < int(of_blocks.size()); ++i)
        counts_[std::size_t(levels_.LevelOf(i))] += of_blocks[i];
    });
    return counts_[level];
  }

 private:
  const DepthLevels levels_;
  mutable std::once_flag summed_;
  mutable Coming of_blocks_;
  mutable std::array<int, tracker::kMaxPyramidLevels> counts_{};
};

// Makes images of images on a machine, as the CPU backend does.
template <typename Machine>
class BlockImaging {
 public:
  using Picture = BlockImage<Machine>;
  using Pyramid = std::vector<Picture>;

  explicit BlockImaging(const Machine& machine) : machine_(machine) {}

  Picture Upload(const Image<float>& image) const {
    Picture picture(machine_, image.width(), image.height());
    machine_.Upload(image.data(), *picture.pixels);
    return picture;
  }

  Picture Gray(const Image<Rgb8>& rgb) const {
    typename Machine::template Array<Rgb8> colors(machine_, rgb.size());
    machine_.Upload(rgb.data(), colors);
    Picture gray(machine_, rgb.width(), rgb.height());
    Each(gray.size(), ConvertToGray{colors.data(), gray.data()});
    return gray;
  }

  template <typename Halve>
  Pyramid Halvings(Picture finest, int levels) const {
    Pyramid pyramid{std::move(finest)};
    while (int(pyramid.size()) < levels) {
      const Picture& fine = pyramid.back();
      Picture half(machine_, fine.width / 2, fine.height / 2);
      Each(half.size(), Halve{fine.data(), fine.width, half.data(), half.width});
      pyramid.push_back(std::move(half));
    }
    return pyramid;
  }

  // The levels of Halvings from `first` on, made of a pyramid that may end before.
  template <typename Halve>
  Pyramid HalvingsFrom(const Pyramid& finer, int first, int levels) const {
    const int last = std::min(first, int(finer.size()) - 1);
    Pyramid pyramid = Halvings<Halve>(finer[last], first - last + levels);
    pyramid.erase(pyramid.begin(), pyramid.begin() + (first - last));
    return pyramid;
  }

  // Without what lies nearer than `margin_px` to a depth edge; a coarse level takes half of it.
  Pyramid WithoutEdges(const Pyramid& depth_m, int margin_px) const {
    if (margin_px == 0) return depth_m;
    Pyramid kept;
    for (const Picture& depth : depth_m) {
      kept.push_back(WithoutEdges(depth, (kept.empty() ? margin_px : (margin_px + 1) / 2) - 1));
    }
    return kept;
  }

  Picture ClearedIntensity(const Picture& intensity, const Picture& depth_m,
                           const Picture& kept_m) const {
    Picture cleared(machine_, intensity.width, intensity.height);
    Each(cleared.size(),
         ClearIntensity{depth_m.data(), kept_m.data(), intensity.data(), cleared.data()});
    return cleared;
  }

  Picture Inverse(const Picture& depth_m) const {
    Picture inverse(machine_, depth_m.width, depth_m.height);
    Each(inverse.size(), InvertDepth{depth_m.data(), inverse.data()});
    return inverse;
  }

  // How many depths of each level are measured.
  std::shared_ptr<const MeasuredCounts<Machine>> Measured(const Pyramid& depths_m) const {
    SILT_CHECK(!depths_m.empty() && depths_m.size() <= std::size_t(tracker::kMaxPyramidLevels));
    DepthLevels levels{};
    for (const Picture& depth_m : depths_m) {
      const int level = levels.count++;
      levels.depth_m[level] = depth_m.data();
      levels.size[level] = depth_m.size();
      levels.first_block[level + 1] =
          levels.first_block[level] + GridFor(depth_m.size(), 16).blocks;
    }
    const int blocks = levels.first_block[levels.count];
    typename Machine::template Array<int> counts(machine_, std::size_t(blocks));
    machine_.Run(Grid{blocks, kThreads}, CountMeasured{levels, counts.data()});
    return std::make_shared<const MeasuredCounts<Machine>>(levels, machine_.StartDownload(counts));
  }

  template <typename Function>
  void Each(int n, const Function& function) const {
    if (n > 0) machine_.Run(GridFor(n), ForEach<Function>{n, function});
  }

 private:
  Picture WithoutEdges(const Picture& depth_m, int reach) const {
    const int width = depth_m.width, height = depth_m.height;
    typename Machine::template Array<unsigned char> edge(machine_, std::size_t(depth_m.size()));
    Picture kept(machine_, width, height);
    Each(kept.size(), MarkEdges{depth_m.data(), width, height, edge.data()});
    Each(kept.size(), ClearEdges{depth_m.data(), edge.data(), width, height, reach, kept.data()});
    return kept;
  }

  const Machine& machine_;
};

// An intensity beside a depth edge is NaN, so that nothing is compared with it.
template <typename Machine>
class BlockCurrent : public tracker::CurrentPyramid {
 public:
  using Pyramid = typename BlockImaging<Machine>::Pyramid;

  // Without depths, `depths_m` is empty.
  BlockCurrent(const BlockImaging<Machine>& imaging, Pyramid intensities, Pyramid depths_m,
               const tracker::PyramidOptions& options)
      : whole_intensity(std::move(intensities)),
        intensity(whole_intensity),
        depth_m(std::move(depths_m)) {
    has_depth_ = !depth_m.empty();
    if (!has_depth_) return;
    kept_m = imaging.WithoutEdges(depth_m, options.depth_edge_margin_px);
    for (std::size_t level = 0; level < intensity.size(); ++level) {
      if (options.inverse_depth) inverse_depth.push_back(imaging.Inverse(kept_m[level]));
      if (options.depth_edge_margin_px == 0) continue;
      intensity[level] = imaging.ClearedIntensity(intensity[level], depth_m[level], kept_m[level]);
    }
  }

  const Pyramid whole_intensity;
  Pyramid intensity;
  Pyramid depth_m, kept_m;  // all, and without the edges; empty without a depth
  Pyramid inverse_depth;    // without the edges; empty unless asked for
};

template <typename Machine>
class BlockReference : public tracker::ReferencePyramid {
 public:
  using Pyramid = typename BlockImaging<Machine>::Pyramid;

  // All depths, and those that are `margin_px` away from their edges.
  BlockReference(const BlockImaging<Machine>& imaging, Pyramid intensities, Pyramid whole_depths_m,
                 Pyramid depths_m, PinholeCamera camera, int margin_px)
      : intensity(std::move(intensities)),
        whole_depth_m(std::move(whole_depths_m)),
        depth_m(std::move(depths_m)),
        edge_margin_px(margin_px),
        measured_(imaging.Measured(depth_m)) {
    while (levels_.size() < depth_m.size()) {
      levels_.push_back({camera, 0});
      camera = camera.Halved();
    }
  }

  // `other` with depths of its own, of as many levels.
  BlockReference(const BlockReference& other, Pyramid depths_m)
      : intensity(other.intensity),
        whole_depth_m(other.whole_depth_m),
        depth_m(std::move(depths_m)),
        edge_margin_px(other.edge_margin_px),
        measured_(other.measured_),
        levels_(other.Uncounted(other.levels_.size())) {}

  // The finest levels of `other`.
  BlockReference(const BlockReference& other, std::size_t levels)
      : intensity(other.intensity.begin(), other.intensity.begin() + levels),
        whole_depth_m(other.whole_depth_m.begin(), other.whole_depth_m.begin() + levels),
        depth_m(other.depth_m.begin(), other.depth_m.begin() + levels),
        edge_margin_px(other.edge_margin_px),
        measured_(other.measured_),
        levels_(other.Uncounted(levels)) {}

  const tracker::PyramidLevels& levels() const override {
    std::call_once(counted_, [this] {
      for (std::size_t i = 0; i < levels_.size(); ++i) {
        levels_[i].measured_pixels = measured_->Of(i);
      }
    });
    return levels_;
  }
  // Without a wait.
  const PinholeCamera& camera(int level) const { return levels_[std::size_t(level)].camera; }

  // Smaller pictures of this one, which every frame asks for. `make` makes them; the key is all
  // that they depend on.
  using SmallKey = std::array<int, 3>;
  template <typename Make>
  std::unique_ptr<const BlockReference> Small(const SmallKey& key, const Make& make) const {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<const BlockReference>& small = small_[key];
    if (!small) small = make();
    return std::make_unique<const BlockReference>(*small, small->depth_m);
  }

  const Pyramid intensity, whole_depth_m, depth_m;
  const int edge_margin_px;

 private:
  // Leaves alone what another thread may be writing.
  tracker::PyramidLevels Uncounted(std::size_t levels) const {
    tracker::PyramidLevels uncounted;
    for (std::size_t i = 0; i < levels; ++i) uncounted.push_back({levels_[i].camera, 0});
    return uncounted;
  }

  const std::shared_ptr<const MeasuredCounts<Machine>> measured_;
  mutable std::once_flag counted_;
  mutable tracker::PyramidLevels levels_;
  mutable std::mutex mutex_;
  mutable std::map<SmallKey, std::unique_ptr<const BlockReference>> small_;
};

}  // namespace silt::cuda
