// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "silt/core/io/sequence_writer.h"
#include "silt/core/recorded_sequence.h"

// The layout in which ICL-NUIM publishes its original frames. For frame 12:
//   scene_00_0012.png     colours
//   scene_00_0012.depth   text: distances from the camera's centre along the ray (not z), in
//                         metres, row by row
//   scene_00_0012.txt     POV-Ray's camera: cam_pos, cam_dir, cam_up, cam_right, …
// Its axes are POV-Ray's, see icl_camera.h. The principal point is the middle of the image.
namespace silt {

// Adds scene.gt.freiburg, the poses in ICL-NUIM's axes as lines `time tx ty tz qx qy qz qw`, since
// the camera files know no time.
class IclSequenceWriter : public SequenceWriter {
 public:
  // Throws silt::Error where the principal point is not the middle of the image.
  IclSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  std::filesystem::path folder_;
  SequenceDescription description_;
};

// Reads such a folder, with or without .depth files. Without *.gt.freiburg, or where that has
// another number of lines than there are frames, frame k has the time k/30 s.
class IclSequence : public RecordedSequence {
 public:
  explicit IclSequence(const std::filesystem::path& folder);

  const PinholeCamera& camera() const override { return camera_; }
  int size() const override { return int(truth_.size()); }
  std::optional<Frame> Next() override;
  std::vector<double> times_s() const override;
  const Trajectory& truth() const override { return truth_; }

 private:
  std::filesystem::path folder_;
  PinholeCamera camera_;
  Trajectory truth_;
  int next_ = 0;
};

}  // namespace silt
