// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/trajectory.h"
#include "silt/sim/camera_path.h"
#include "silt/sim/renderer.h"

namespace silt::sim {

// Which instants of a path become frames: see FrameTimes in camera_path.h.
struct SequenceTiming {
  double fps = 60;
  double start_s = 0;     // on the path's clock
  double duration_s = 0;  // 0: to the end of the path
};

// Frames of a camera that follows a path. A frame's time is that of the path, and its noise depends
// on that time and not on where the sequence starts: a stretch is a part of the whole.
class RenderedSequence : public FrameSource {
 public:
  // Throws silt::Error where the timing leaves the path.
  RenderedSequence(std::shared_ptr<const Renderer> renderer, std::shared_ptr<const CameraPath> path,
                   const SequenceTiming& timing);

  const PinholeCamera& camera() const override { return renderer_->options().camera; }
  int size() const override { return int(ground_truth_.size()); }
  std::optional<Frame> Next() override;

  // Frame `index` in [0, size()), in any order; Next() returns the same.
  Frame At(int index) const;
  // The true pose of each frame, at mid-exposure.
  const Trajectory& GroundTruth() const { return ground_truth_; }

 private:
  std::shared_ptr<const Renderer> renderer_;
  std::shared_ptr<const CameraPath> path_;
  Trajectory ground_truth_;
  int first_frame_ = 0;  // of the whole path's frames
  int next_ = 0;
};

}  // namespace silt::sim
