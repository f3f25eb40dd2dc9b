// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/sim/lit_scene.h"

// Whether pictures, depths, poses and intrinsics of a sequence tell the same story: a picture
// warped by the truth onto another must match it, but for the sampling of pixels and for
// quantisation.
namespace silt::experiments {

// A picture with all that is known of it.
struct TrueView {
  Image<float> luma;     // in levels: [0, 255]
  Image<float> depth_m;  // along z; 0: nothing
  SE3d world_from_camera;
};

// |ΔI| in levels of every pixel of `onto` that `from` shows too, where `from` is looked up by its
// cubic spline at the place that depth and poses give.
struct PhotoDifferences {
  std::vector<float> all;
  std::vector<float> at_gradients;  // where |∇I| is 0.5 to 2 levels per pixel
  std::size_t hidden = 0;           // pixels that `from` does not show
};
PhotoDifferences ComparePictures(const PinholeCamera& camera, const TrueView& onto,
                                 const TrueView& from);

// How far apart the places lie, in metres along z, that the depth of `onto` and the exact ray from
// the other view find on one line of sight, wherever both see the same triangle. Pixels whose
// triangle is hidden there by another one are counted alone; how far that one lies before it does
// not matter.
struct DepthDifferences {
  std::vector<double> m;
  std::size_t hidden = 0;
};
DepthDifferences CompareDepths(const sim::LitScene& scene, const PinholeCamera& camera,
                               const TrueView& onto, const SE3d& world_from_other);

}  // namespace silt::experiments
