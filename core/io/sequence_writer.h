// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/imu_sample.h"
#include "silt/core/lens.h"
#include "silt/core/trajectory.h"

namespace silt {

// All of a sequence but its images.
struct SequenceDescription {
  PinholeCamera camera;
  Trajectory truth;          // time and true pose of each frame, in order
  ImuRecording imu;          // at the camera's centre, with the camera's axes; may be empty
  LensDistortion lens = {};  // that the images are seen through
};

// Writes a sequence into a folder, in one of the field's layouts. Frames may come in any order and
// more than once; each of their files is written whole or not at all. What holds for the sequence
// (lists, camera, poses) appears with Finish(), so that a folder that has it is whole. All throw
// silt::Error naming the file.
class SequenceWriter {
 public:
  virtual ~SequenceWriter() = default;

  // The files that frame `number` (from 0) consists of, relative to the folder.
  virtual std::vector<std::filesystem::path> FrameFiles(int number) const = 0;
  // Those that Finish() writes.
  virtual std::vector<std::filesystem::path> SequenceFiles() const = 0;
  virtual void Write(int number, const Frame& frame) = 0;
  virtual void Finish() = 0;
};

// Whether all files of a frame are there.
bool HasFrame(const std::filesystem::path& folder, const SequenceWriter& writer, int number);

// Throws silt::Error where there is a lens, for a layout that knows pinholes alone.
void RequirePinhole(const SequenceDescription& description, const char* format);

// "000012" + extension.
std::string FrameName(int number, const char* extension);

}  // namespace silt
