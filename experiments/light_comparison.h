// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/experiments/json.h"
#include "silt/sim/lit_scene.h"

// Baked light against path-traced light, and two bakes against each other, in pictures.
namespace silt::experiments {

struct LightView {
  std::string name;
  SE3d world_from_camera;
};

// A view at the middle of each of `views` equal parts of the paths beside a scene, which share
// them.
std::vector<LightView> ViewsAlong(const std::string& scene, const std::vector<std::string>& paths,
                                  int views);

struct PathReference {
  int width = 160, samples_per_pixel = 4096;
  bool reflection = false;  // matt surfaces else, as baked light sees them
  std::uint64_t seed = 0;
};

// What the paths of two seeds found, half of the samples each: their mean is the reference, and
// their difference tells its noise.
struct ReferencePicture {
  Image<Vec3f> half[2];
  Image<Vec3f> Mean() const;
};
ReferencePicture TraceReference(const sim::LitScene& scene, const LightView& view,
                                std::uint32_t number, const PathReference& reference);

// The same view by baked light, in pixels of 32 × 32 places, or fewer if they are many.
Image<Vec3f> RenderBaked(const std::shared_ptr<const sim::LitScene>& scene, const LightView& view,
                         int width);

// Differences after the response of an 8-bit sRGB camera but not rounded, in its steps (1/255).
struct LightDifference {
  double mean = 0;             // of |Δ| over pixels and colours
  double percentile_99 = 0;    // of the same
  double bias = 0;             // mean of Δ, baked − traced
  double reference_noise = 0;  // standard error of the reference, root mean square
  double rms = 0;  // of Δ, without the reference's share: √mean (Δ₁ Δ₂) of both halves
};
LightDifference Compare(const std::vector<Image<Vec3f>>& baked,
                        const std::vector<ReferencePicture>& reference, double exposure);
// Root mean square of the differences between two sets of pictures, in the same steps.
double RmsDifference(const std::vector<Image<Vec3f>>& a, const std::vector<Image<Vec3f>>& b,
                     double exposure);

// Signed differences × 8 about middle gray, to be looked at.
Image<Rgb8> DifferencePicture(const Image<Vec3f>& baked, const Image<Vec3f>& reference,
                              double exposure);

Json ToJson(const LightDifference& difference);

}  // namespace silt::experiments
