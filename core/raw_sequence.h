// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "silt/core/recorded_sequence.h"

// silt's own layout, for machines that have neither OpenCV nor PNG. A folder of files, one a frame,
// named by frames.txt line by line. Each file, little-endian and without padding:
//   offset 0   8 characters "SILTRAW1"
//          8   uint32 width, height
//         16   uint32 colour channels (3), depth channels (1, or 0: not measured)
//         24   float64 time_s
//         32   float64 fx fy cx cy, in pixels; pixel centres at integers
//         64   float64 tx ty tz qx qy qz qw of world_from_camera
//        120   8 bytes of 0
//        128   width·height·3 bytes of sRGB, row by row
//              width·height float32 of depth along z in metres; 0: nothing measured
namespace silt {

struct RawFrame {
  PinholeCamera camera;
  SE3d world_from_camera;
  Frame frame;
};

// Both throw silt::Error naming the file; the file is written whole or not at all.
void WriteRawFrame(const std::filesystem::path& file, const RawFrame& frame);
RawFrame ReadRawFrame(const std::filesystem::path& file);

// Reads such a folder. All frames must have one camera.
class RawSequence : public RecordedSequence {
 public:
  explicit RawSequence(const std::filesystem::path& folder);

  const PinholeCamera& camera() const override { return camera_; }
  int size() const override { return int(files_.size()); }
  std::optional<Frame> Next() override;
  std::vector<double> times_s() const override;
  const Trajectory& truth() const override { return truth_; }

 private:
  PinholeCamera camera_;
  std::vector<std::filesystem::path> files_;
  Trajectory truth_;
  std::size_t next_ = 0;
};

}  // namespace silt
