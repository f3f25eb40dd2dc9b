// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/keyframe.h"

namespace silt::tracker {

// A tracker's pyramids of both images, and the backend that they lie in.
struct HeldImages {
  const Backend& backend;
  ImagePair images;
};

// The images of one initial estimate (§3.2).
struct InitializerInput {
  const Keyframe& keyframe;             // what is computed of it may be kept under keyframe.id
  const Frame& current;                 // its depth may be missing
  const Image<float>& intensity;        // of current.rgb, in [0, 1]
  const PinholeCamera& camera;          // of both
  std::uint64_t seed = 0;               // of random draws, together with frame_index
  int frame_index = 0;                  // of the current frame, from 0
  SE3d expected = {};                   // current_from_keyframe, as far as it can be foretold
  std::optional<HeldImages> held = {};  // where there are any
};

struct InitialEstimate {
  std::optional<SE3d> current_from_keyframe;  // nothing where there is no trustworthy estimate
  int matches = 0;                            // that passed the checks of §3.2
  int inliers = 0;                            // of them, of the pose
  double milliseconds = 0;
};

// Where the refinement starts from. One object serves one tracker, so keyframe ids are its own.
class Initializer {
 public:
  virtual ~Initializer() = default;
  // A pure function of the input, however often and in whatever order it is called.
  virtual InitialEstimate Estimate(const InitializerInput& input) = 0;
  // The same estimate as alignments that a backend can run together with the refinement, so that
  // nothing waits for it in between; nothing where it is not to be had so.
  virtual std::optional<CoarseStart> StartOf(const InitializerInput&) const { return std::nullopt; }
  // Whether it looks at intensities, the keyframe's and the current ones, although `backend` holds
  // both images; else they may be empty.
  virtual bool needs_intensities(const Backend& /*backend*/) const { return true; }
};

}  // namespace silt::tracker
