// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/raw_sequence_writer.h"

#include <string>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/raw_sequence.h"

namespace silt {

namespace fs = std::filesystem;

RawSequenceWriter::RawSequenceWriter(fs::path folder, SequenceDescription description)
    : folder_(std::move(folder)), description_(std::move(description)) {
  RequirePinhole(description_, "raw");
}

std::vector<fs::path> RawSequenceWriter::FrameFiles(int number) const {
  return {fs::path("frames") / FrameName(number, ".raw")};
}

std::vector<fs::path> RawSequenceWriter::SequenceFiles() const { return {"frames.txt"}; }

void RawSequenceWriter::Write(int number, const Frame& frame) {
  const SE3d& pose = description_.truth.at(std::size_t(number)).world_from_camera;
  WriteRawFrame(folder_ / FrameFiles(number)[0], {description_.camera, pose, frame});
}

void RawSequenceWriter::Finish() {
  std::string list;
  for (std::size_t i = 0; i < description_.truth.size(); ++i) {
    list += FrameFiles(int(i))[0].string() + "\n";
  }
  WriteFileAtomically(folder_ / "frames.txt", list);
}

}  // namespace silt
