// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::sim {

// When light is let in. A frame's time and pose are those in the middle of the exposure of the
// picture's middle.
struct Shutter {
  double exposure_s = 0;  // of each row; 0: an instant
  int time_samples = 16;  // at least so many instants where exposure_s > 0
  // Rolling: each row is exposed so much later than the one above it, 0 or more; 0: all at once.
  double row_time_s = 0;

  // When row y of `height` is in the middle of its exposure, relative to the frame's time.
  double RowTime(int y, int height) const { return row_time_s * (y - 0.5 * (height - 1)); }
};

}  // namespace silt::sim
