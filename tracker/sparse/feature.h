// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::tracker {

// A point of an image that can be found again in another one, whoever has found it.
struct Feature {
  Vec2d pixel;           // centre, sub-pixel; pixel centres at integers
  double scale = 0;      // in pixels, in a unit of the detector's own
  double angle_rad = 0;  // dominant gradient direction, from x towards y
  // What it looks like, one of the two: numbers of Euclidean norm 1, or bits, eight to a byte.
  std::vector<float> descriptor;
  std::vector<std::uint8_t> bits;
};

// SURF is the paper's.
enum class FeatureKind { kSurf, kSift, kOrb, kAkaze };

struct FeatureOptions {
  FeatureKind kind = FeatureKind::kSurf;
  int max_features = 700;  // the strongest are kept
  // Least determinant of the Hessian, on 8-bit intensities. dlib's default of 30 finds 180 features
  // in a ray-traced 640×480 office with plain walls, 1 finds 590, for 5 ms more.
  double surf_threshold = 1;
  // Of the others on the same account, below OpenCV's own of 0.04, 20 and 1e-3.
  double sift_contrast = 0.01;
  int orb_fast_threshold = 5;
  double akaze_threshold = 1e-4;

  // Throws silt::Error where an option is out of range.
  void Validate() const;
};

// Features of an image of intensities in [0, 1], strongest first. The same for any number of
// threads.
std::vector<Feature> DetectFeatures(const Image<float>& intensity,
                                    const FeatureOptions& options = {});

}  // namespace silt::tracker
