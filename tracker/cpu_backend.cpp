// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_backend.h"

#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/tracker/cpu_preparation.h"
#include "silt/tracker/cpu_reduction.h"
#include "silt/tracker/spline_coefficients.h"
#include "silt/tracker/visibility.h"

namespace silt::tracker {
namespace {

// Depth edges go at each level, so that what they mix at a coarse one does not reach a fine one.
// A coarse pixel is wider: half the margin does.
int MarginAt(std::size_t level, const PyramidOptions& options) {
  const int margin_px = options.depth_edge_margin_px;
  return level == 0 ? margin_px : (margin_px + 1) / 2;
}

using Source = CpuPreparation::Source;

// Those levels of the pyramids that something is aligned at.
PooledVector<CpuPreparation::Level> LevelsOf(const CpuPreparation::Pyramids& made,
                                             const PyramidOptions& options) {
  PooledVector<CpuPreparation::Level> levels;
  for (std::size_t level = options.finest; level < made.depth_m.size(); ++level) {
    levels.push_back(
        {made.depth_m[level].get(), made.intensity[level].get(), MarginAt(level, options)});
  }
  return levels;
}

class CpuReference : public ReferencePyramid, public Pooled {
 public:
  CpuReference(const CpuPreparation& prepare, const Source& source, PinholeCamera camera,
               const PyramidOptions& options)
      : finest(options.finest), depth_m(options.levels) {
    auto made = prepare.Make(source, options.levels, finest);
    CpuPreparation::Wanted wanted;
    wanted.depth = true;
    auto kept = prepare.AwayFromEdges(LevelsOf(made, options), wanted);
    intensity = std::move(made.intensity);
    for (int level = 0; level < options.levels; ++level) {
      if (level < finest) intensity[level] = nullptr;
      if (level >= finest) depth_m[level] = std::move(kept[level - finest].depth_m);
      levels_.push_back({camera, level < finest ? 0 : kept[level - finest].measured});
      camera = camera.Halved();
    }
    if (finest == 0 && source.gray) intensity[0] = prepare.Own(*source.gray);
  }

  // `other` with depths of its own.
  CpuReference(const CpuReference& other, CpuPyramid depths_m)
      : finest(other.finest), intensity(other.intensity), depth_m(std::move(depths_m)) {
    levels_ = other.levels_;
  }

  const PyramidLevels& levels() const override { return levels_; }

  const int finest;  // of the levels that are kept; those above it are null
  CpuPyramid intensity;
  CpuPyramid depth_m;

 private:
  PyramidLevels levels_;
};

// An intensity beside a depth edge is NaN, so that nothing is compared with it.
class CpuCurrent : public CurrentPyramid, public Pooled {
 public:
  CpuCurrent(const CpuPreparation& prepare, const Source& source, const PyramidOptions& options)
      : interpolant(options.interpolant) {
    auto made = prepare.Make(source, options.levels, options.finest);
    if (interpolant == Interpolant::kBSpline) TakeCoefficients(options.finest, &made.intensity);
    has_depth_ = source.depth_m != nullptr;
    CpuPreparation::Wanted wanted;
    wanted.inverse_depth = options.inverse_depth;
    wanted.intensity = options.depth_edge_margin_px > 0;
    auto kept = prepare.AwayFromEdges(LevelsOf(made, options), wanted);
    intensity = std::move(made.intensity);
    depth_m = std::move(made.depth_m);
    inverse_depth.resize(wanted.inverse_depth ? depth_m.size() : 0);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const std::size_t level = options.finest + i;
      if (wanted.inverse_depth) inverse_depth[level] = std::move(kept[i].inverse_depth);
      if (wanted.intensity) intensity[level] = std::move(kept[i].intensity);
    }
    for (int level = 0; level < options.finest; ++level) {
      intensity[level] = nullptr;
      if (has_depth_) depth_m[level] = nullptr;
    }
    OwnFinest(prepare, source);
  }

  static void TakeCoefficients(int finest, CpuPyramid* intensity) {
    for (std::size_t level = finest; level < intensity->size(); ++level) {
      CpuLevel& at = (*intensity)[level];
      at = std::make_shared<const Image<float>>(SplineCoefficients(*at));
    }
  }

  // What is still the source's.
  void OwnFinest(const CpuPreparation& prepare, const Source& source) {
    if (intensity[0].get() == source.gray && source.gray) intensity[0] = prepare.Own(*source.gray);
    if (has_depth_ && depth_m[0]) depth_m[0] = prepare.Own(*source.depth_m);
  }

  const Interpolant interpolant;
  CpuPyramid intensity;      // coefficients for a B-spline
  CpuPyramid depth_m;        // empty without a depth
  CpuPyramid inverse_depth;  // without the edges; empty unless asked for
};

class CpuBackend : public Backend {
 public:
  explicit CpuBackend(SimdLevel level) : reduction_(level), preparation_(level) {}

  std::string name() const override { return "cpu"; }

  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>& intensity,
                                                  const Image<float>& depth_m,
                                                  const PinholeCamera& camera,
                                                  const PyramidOptions& options) const override {
    return Reference({nullptr, &intensity, &depth_m}, camera, options);
  }

  std::unique_ptr<ReferencePyramid> MakeReferenceOfColour(
      const Image<Rgb8>& rgb, const Image<float>& depth_m, const PinholeCamera& camera,
      const PyramidOptions& options) const override {
    return Reference({&rgb, nullptr, &depth_m}, camera, options);
  }

  std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>& intensity,
                                              const Image<float>& depth_m,
                                              const PyramidOptions& options) const override {
    return Current({nullptr, &intensity, depth_m.empty() ? nullptr : &depth_m}, options);
  }

  std::unique_ptr<CurrentPyramid> MakeCurrentOfColour(
      const Image<Rgb8>& rgb, const Image<float>& depth_m,
      const PyramidOptions& options) const override {
    return Current({&rgb, nullptr, depth_m.empty() ? nullptr : &depth_m}, options);
  }

  std::unique_ptr<ReferencePyramid> WithoutHidden(
      const ImagePair& pair, int level, const SE3d& current_from_reference) const override {
    const auto& full = dynamic_cast<const CpuReference&>(pair.reference);
    if (!pair.current.has_depth()) {
      const int finest = full.finest;
      const Image<float> visible =
          VisibleDepth(*full.depth_m[finest], full.levels()[finest].camera, current_from_reference);
      CpuPyramid depths = preparation_.Depth(visible, level + 1 - finest);
      depths[0] = preparation_.Own(visible);
      depths.insert(depths.begin(), std::size_t(finest), nullptr);
      return std::make_unique<CpuReference>(full, std::move(depths));
    }
    CpuPyramid depths = full.depth_m;
    const LevelImages images = Images(pair, level);
    const auto visible = preparation_.Take(images.camera.width, images.camera.height);
    reduction_.CopyVisibleDepth(images, current_from_reference, visible.get());
    depths[level] = visible;
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
  std::unique_ptr<ReferencePyramid> Reference(const Source& source, const PinholeCamera& camera,
                                              const PyramidOptions& options) const {
    SILT_CHECK(source.width() == camera.width && source.height() == camera.height);
    SILT_CHECK(source.depth_m->width() == camera.width);
    SILT_CHECK(source.depth_m->height() == camera.height);
    return std::make_unique<CpuReference>(preparation_, source, camera, options);
  }

  std::unique_ptr<CurrentPyramid> Current(const Source& source,
                                          const PyramidOptions& options) const {
    SILT_CHECK(!source.depth_m || (source.depth_m->width() == source.width() &&
                                   source.depth_m->height() == source.height()));
    return std::make_unique<CpuCurrent>(preparation_, source, options);
  }

  static LevelImages Images(const ImagePair& pair, int level) {
    const auto& reference = dynamic_cast<const CpuReference&>(pair.reference);
    const auto& current = dynamic_cast<const CpuCurrent&>(pair.current);
    SILT_CHECK(level >= 0 && level < int(reference.depth_m.size()));
    SILT_CHECK(level < int(current.intensity.size()));
    SILT_CHECK(reference.depth_m[level] && current.intensity[level]);
    const PinholeCamera& camera = reference.levels()[level].camera;
    SILT_CHECK(current.intensity[level]->width() == camera.width &&
               current.intensity[level]->height() == camera.height);
    return {camera,
            *reference.intensity[level],
            *reference.depth_m[level],
            *current.intensity[level],
            current.has_depth() ? current.depth_m[level].get() : nullptr,
            current.inverse_depth.empty() ? nullptr : current.inverse_depth[level].get(),
            current.interpolant};
  }

  CpuReduction reduction_;
  CpuPreparation preparation_;
};

}  // namespace

std::unique_ptr<Backend> MakeCpuBackend(SimdLevel level) {
  return std::make_unique<CpuBackend>(level);
}

}  // namespace silt::tracker
