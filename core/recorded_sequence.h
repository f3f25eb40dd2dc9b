// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/frame.h"
#include "silt/core/trajectory.h"

namespace silt {

// Frames that lie on disk, with the true poses that were recorded beside them.
class RecordedSequence : public FrameSource {
 public:
  // The time of each frame that Next() delivers, in order.
  virtual std::vector<double> times_s() const = 0;
  // At times of its own; empty where none was recorded.
  virtual const Trajectory& truth() const = 0;
};

}  // namespace silt
