// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/io/sequence_writer.h"
#include "silt/core/recorded_sequence.h"

// A sequence on disk in the layout of the TUM RGB-D benchmark:
//   rgb/ depth/ rgb.txt depth.txt associations.txt groundtruth.txt camera.txt
// camera.txt, which TUM keeps on its web page, holds one line `fx fy cx cy width height`, and
// `k1 k2 p1 p2 k3` behind them where there is a lens (core/lens.h).
namespace silt {

// The lists of an earlier sequence go with the first frame.
class TumSequenceWriter : public SequenceWriter {
 public:
  TumSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  std::filesystem::path folder_;
  SequenceDescription description_;
  bool begun_ = false;
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
class TumSequence : public RecordedSequence {
 public:
  // `camera` replaces camera.txt; without a focal length the file is asked for, and without a width
  // the first image. With fy < 0, as ICL-NUIM's TUM folders have it, the true poses are taken to be
  // in that dataset's axes (icl_camera.h) and the camera's fy is turned positive.
  TumSequence(const std::filesystem::path& folder, const TumSequenceOptions& options = {},
              const PinholeCamera& camera = {});

  const PinholeCamera& camera() const override { return camera_; }
  int size() const override { return int(entries_.size()); }
  std::optional<Frame> Next() override;
  std::vector<double> times_s() const override;
  // Of groundtruth.txt, if there is one.
  const Trajectory& truth() const override { return truth_; }
  const std::vector<TumEntry>& entries() const { return entries_; }

 private:
  TumSequenceOptions options_;
  PinholeCamera camera_;
  std::vector<TumEntry> entries_;
  Trajectory truth_;
  std::size_t next_ = 0;
};

}  // namespace silt
