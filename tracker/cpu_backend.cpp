// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_backend.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/cpu_reduction.h"
#include "silt/tracker/visibility.h"

namespace silt::tracker {
namespace {

using Pyramid = std::vector<Image<float>>;

template <typename Halve>
Pyramid MakePyramid(const Image<float>& finest, int levels, const Halve& halve) {
  Pyramid pyramid{finest};
  for (int level = 1; level < levels; ++level) pyramid.push_back(halve(pyramid.back()));
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

class CpuReference : public ReferencePyramid {
 public:
  CpuReference(const Image<float>& finest_intensity, const Image<float>& finest_depth_m,
               PinholeCamera camera, int levels)
      : intensity(std::make_shared<Pyramid>(IntensityPyramid(finest_intensity, levels))),
        depth_m(DepthPyramid(finest_depth_m, levels)) {
    for (const Image<float>& depth : depth_m) {
      levels_.push_back({camera, int(std::count_if(depth.begin(), depth.end(), IsMeasured))});
      camera = camera.Halved();
    }
  }

  // `other` with depths of its own, down to a level.
  CpuReference(const CpuReference& other, const Image<float>& finest_depth_m, int level)
      : intensity(other.intensity), depth_m(DepthPyramid(finest_depth_m, level + 1)) {
    levels_ = other.levels_;
  }

  const std::shared_ptr<const Pyramid> intensity;
  const Pyramid depth_m;
};

class CpuCurrent : public CurrentPyramid {
 public:
  CpuCurrent(const Image<float>& finest_intensity, int levels)
      : intensity(IntensityPyramid(finest_intensity, levels)) {}

  const Pyramid intensity;
};

class CpuBackend : public Backend {
 public:
  explicit CpuBackend(SimdLevel level) : reduction_(level) {}

  std::string name() const override { return "cpu"; }

  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>& intensity,
                                                  const Image<float>& depth_m,
                                                  const PinholeCamera& camera,
                                                  int levels) const override {
    SILT_CHECK(intensity.width() == camera.width && intensity.height() == camera.height);
    SILT_CHECK(depth_m.width() == camera.width && depth_m.height() == camera.height);
    return std::make_unique<CpuReference>(intensity, depth_m, camera, levels);
  }

  std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>& intensity,
                                              int levels) const override {
    return std::make_unique<CpuCurrent>(intensity, levels);
  }

  std::unique_ptr<ReferencePyramid> WithoutHidden(
      const ReferencePyramid& reference, int level,
      const SE3d& current_from_reference) const override {
    const auto& full = dynamic_cast<const CpuReference&>(reference);
    const Image<float> visible =
        VisibleDepth(full.depth_m[0], full.levels()[0].camera, current_from_reference);
    return std::make_unique<CpuReference>(full, visible, level);
  }

  PhotometricCost Cost(const ImagePair& pair, int level,
                       const SE3d& current_from_reference) const override {
    return reduction_.Cost(Images(pair, level), current_from_reference);
  }

  NormalEquations Linearize(const ImagePair& pair, int level,
                            const SE3d& current_from_reference) const override {
    return reduction_.Equations(Images(pair, level), current_from_reference);
  }

 private:
  static LevelImages Images(const ImagePair& pair, int level) {
    const auto& reference = dynamic_cast<const CpuReference&>(pair.reference);
    const auto& current = dynamic_cast<const CpuCurrent&>(pair.current);
    SILT_CHECK(level >= 0 && level < int(reference.depth_m.size()));
    SILT_CHECK(level < int(current.intensity.size()));
    const PinholeCamera& camera = reference.levels()[level].camera;
    SILT_CHECK(current.intensity[level].width() == camera.width &&
               current.intensity[level].height() == camera.height);
    return {camera, (*reference.intensity)[level], reference.depth_m[level],
            current.intensity[level]};
  }

  CpuReduction reduction_;
};

}  // namespace

std::unique_ptr<Backend> MakeCpuBackend(SimdLevel level) {
  return std::make_unique<CpuBackend>(level);
}

}  // namespace silt::tracker
