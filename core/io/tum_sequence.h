// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/trajectory.h"

// A sequence on disk in the layout of the TUM RGB-D benchmark:
//   rgb/ depth/ rgb.txt depth.txt associations.txt groundtruth.txt camera.txt
// camera.txt, which TUM keeps on its web page, holds one line `fx fy cx cy width height`.
namespace silt {

// Writes frames as they come; the lists and the trajectory appear with Finish(), so that a folder
// that has them is whole; those of an earlier sequence go with the first frame.
class TumSequenceWriter {
 public:
  TumSequenceWriter(std::filesystem::path folder, const PinholeCamera& camera);

  // Writes the frame's images, named by its number.
  void Write(const Frame& frame, const SE3d& world_from_camera);
  void Finish();

 private:
  std::filesystem::path folder_;
  PinholeCamera camera_;
  Trajectory ground_truth_;
};

// One frame's files and time.
struct TumEntry {
  double time_s = 0;
  std::filesystem::path rgb, depth;  // depth may be empty: not measured for this frame
};

struct TumSequenceOptions {
  double association_tolerance_s = 0.02;
  double depth_per_metre = 5000;
  int take_every = 1;  // 3 makes 20 fps of 60
};

// Reads a folder as a source of frames. Without associations.txt, rgb.txt and depth.txt are
// associated by time. Throws silt::Error with file and line.
class TumSequence : public FrameSource {
 public:
  // `camera` replaces camera.txt; without a focal length the file is asked for, and without a width
  // the first image.
  TumSequence(const std::filesystem::path& folder, const TumSequenceOptions& options = {},
              const PinholeCamera& camera = {});

  const PinholeCamera& camera() const override { return camera_; }
  int size() const override { return int(entries_.size()); }
  std::optional<Frame> Next() override;
  const std::vector<TumEntry>& entries() const { return entries_; }

 private:
  TumSequenceOptions options_;
  PinholeCamera camera_;
  std::vector<TumEntry> entries_;
  std::size_t next_ = 0;
};

}  // namespace silt
