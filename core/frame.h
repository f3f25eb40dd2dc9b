// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "silt/core/camera.h"
#include "silt/core/image.h"

namespace silt {

// What a range camera delivers at one instant.
struct Frame {
  double time_s = 0;     // mid-exposure
  Image<Rgb8> rgb;       // sRGB-encoded, 8 bits
  Image<float> depth_m;  // along z, in metres; 0 or non-finite: no measurement; may be empty
};

// Where a tracker gets its frames from, one after the other: a renderer, a folder, a camera.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const PinholeCamera& camera() const = 0;
  // How many frames Next() will deliver in all.
  virtual int size() const = 0;
  // The next frame, or nothing after the last. Throws silt::Error where a frame cannot be had.
  virtual std::optional<Frame> Next() = 0;
};

}  // namespace silt
