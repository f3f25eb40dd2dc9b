// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_backend.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/cpu_reduction.h"
#include "silt/tracker/depth_edges.h"
#include "silt/tracker/visibility.h"

namespace silt::tracker {
namespace {

// Levels are shared between pyramids that differ in some of them.
using Level = std::shared_ptr<const Image<float>>;
using Pyramid = std::vector<Level>;

Level Share(Image<float> image) { return std::make_shared<const Image<float>>(std::move(image)); }

template <typename Halve>
Pyramid MakePyramid(const Image<float>& finest, int levels, const Halve& halve) {
  Pyramid pyramid{Share(finest)};
  for (int level = 1; level < levels; ++level) pyramid.push_back(Share(halve(*pyramid.back())));
  return pyramid;
}

Pyramid IntensityPyramid(const Image<float>& finest, int levels) {
  return MakePyramid(finest, levels,
                     [](const Image<float>& image) { return HalvedIntensity(image); });
}

Pyramid DepthPyramid(const Image<float>& finest_m, int levels) {
  return MakePyramid(finest_m, levels,
                     [](const Image<float>& depth) { return HalvedDepth(depth); });
}

// Depth edges go at each level, so that what they mix at a coarse one does not reach a fine one.
// A coarse pixel is wider: half the margin does.
Pyramid EdgelessPyramid(const Pyramid& depth_m, int margin_px) {
  if (margin_px == 0) return depth_m;
  Pyramid kept;
  for (const Level& level : depth_m) {
    kept.push_back(
        Share(WithoutDepthEdges(*level, kept.empty() ? margin_px : (margin_px + 1) / 2)));
  }
  return kept;
}

class CpuReference : public ReferencePyramid {
 public:
  CpuReference(const Image<float>& finest_intensity, const Image<float>& finest_depth_m,
               PinholeCamera camera, const PyramidOptions& options)
      : intensity(IntensityPyramid(finest_intensity, options.levels)),
        depth_m(EdgelessPyramid(DepthPyramid(finest_depth_m, options.levels),
                                options.depth_edge_margin_px)) {
    for (const Level& depth : depth_m) {
      levels_.push_back({camera, int(std::count_if(depth->begin(), depth->end(), IsMeasured))});
      camera = camera.Halved();
    }
  }

  // `other` with depths of its own.
  CpuReference(const CpuReference& other, Pyramid depths_m)
      : intensity(other.intensity), depth_m(std::move(depths_m)) {
    levels_ = other.levels_;
  }

  const Pyramid intensity;
  const Pyramid depth_m;
};

// An intensity beside a depth edge is NaN, so that nothing is compared with it.
class CpuCurrent : public CurrentPyramid {
 public:
  CpuCurrent(const Image<float>& finest_intensity, const Image<float>& finest_depth_m,
             const PyramidOptions& options)
      : intensity(IntensityPyramid(finest_intensity, options.levels)) {
    has_depth_ = !finest_depth_m.empty();
    if (!has_depth_) return;
    depth_m = DepthPyramid(finest_depth_m, options.levels);
    const Pyramid kept = EdgelessPyramid(depth_m, options.depth_edge_margin_px);
    for (std::size_t level = 0; level < intensity.size(); ++level) {
      if (options.inverse_depth) inverse_depth.push_back(Share(Inverse(*kept[level])));
      if (kept[level] == depth_m[level]) continue;
      intensity[level] = Share(WithoutEdges(*intensity[level], *depth_m[level], *kept[level]));
    }
  }

  Pyramid intensity;
  Pyramid depth_m;        // empty without a depth
  Pyramid inverse_depth;  // without the edges; empty unless asked for

 private:
  static Image<float> Inverse(Image<float> depth_m) {
    ParallelFor(depth_m.height(), [&](int y) {
      float* row = depth_m.row(y);
      for (int x = 0; x < depth_m.width(); ++x) {
        row[x] = IsMeasured(row[x]) ? 1 / row[x] : std::numeric_limits<float>::quiet_NaN();
      }
    });
    return depth_m;
  }

  static Image<float> WithoutEdges(Image<float> values, const Image<float>& depth,
                                   const Image<float>& kept) {
    ParallelFor(values.height(), [&](int y) {
      for (int x = 0; x < values.width(); ++x) {
        const bool edge = kept(x, y) == 0 && depth(x, y) != 0;
        values(x, y) = edge ? std::numeric_limits<float>::quiet_NaN() : values(x, y);
      }
    });
    return values;
  }
};

class CpuBackend : public Backend {
 public:
  explicit CpuBackend(SimdLevel level) : reduction_(level) {}

  std::string name() const override { return "cpu"; }

  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>& intensity,
                                                  const Image<float>& depth_m,
                                                  const PinholeCamera& camera,
                                                  const PyramidOptions& options) const override {
    SILT_CHECK(intensity.width() == camera.width && intensity.height() == camera.height);
    SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
    return std::make_unique<CpuReference>(intensity, depth_m, camera, options);
  }

  std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>& intensity,
                                              const Image<float>& depth_m,
                                              const PyramidOptions& options) const override {
    SILT_CHECK(depth_m.empty() ||
               (depth_m.width() == intensity.width() && depth_m.height() == intensity.height()));
    return std::make_unique<CpuCurrent>(intensity, depth_m, options);
  }

  std::unique_ptr<ReferencePyramid> WithoutHidden(
      const ImagePair& pair, int level, const SE3d& current_from_reference) const override {
    const auto& full = dynamic_cast<const CpuReference&>(pair.reference);
    if (!pair.current.has_depth()) {
      const Image<float> visible =
          VisibleDepth(*full.depth_m[0], full.levels()[0].camera, current_from_reference);
      return std::make_unique<CpuReference>(full, DepthPyramid(visible, level + 1));
    }
    Pyramid depths = full.depth_m;
    depths[level] = Share(reduction_.VisibleDepth(Images(pair, level), current_from_reference));
    return std::make_unique<CpuReference>(full, std::move(depths));
  }

  PhotometricCost Cost(const ImagePair& pair, int level,
                       const SE3d& current_from_reference) const override {
    return reduction_.Cost(Images(pair, level), current_from_reference);
  }

  NormalEquations Linearize(const ImagePair& pair, int level, const SE3d& current_from_reference,
                            const ResidualNorm& norm) const override {
    return reduction_.Equations(Images(pair, level), current_from_reference, norm);
  }

 private:
  static LevelImages Images(const ImagePair& pair, int level) {
    const auto& reference = dynamic_cast<const CpuReference&>(pair.reference);
    const auto& current = dynamic_cast<const CpuCurrent&>(pair.current);
    SILT_CHECK(level >= 0 && level < int(reference.depth_m.size()));
    SILT_CHECK(level < int(current.intensity.size()));
    const PinholeCamera& camera = reference.levels()[level].camera;
    SILT_CHECK(current.intensity[level]->width() == camera.width &&
               current.intensity[level]->height() == camera.height);
    return {camera,
            *reference.intensity[level],
            *reference.depth_m[level],
            *current.intensity[level],
            current.has_depth() ? current.depth_m[level].get() : nullptr,
            current.inverse_depth.empty() ? nullptr : current.inverse_depth[level].get()};
  }

  CpuReduction reduction_;
};

}  // namespace

std::unique_ptr<Backend> MakeCpuBackend(SimdLevel level) {
  return std::make_unique<CpuBackend>(level);
}

}  // namespace silt::tracker
