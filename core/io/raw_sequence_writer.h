// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/io/sequence_writer.h"

namespace silt {

// silt's own layout, which core/raw_sequence.h states and reads.
class RawSequenceWriter : public SequenceWriter {
 public:
  RawSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  std::filesystem::path folder_;
  SequenceDescription description_;
};

}  // namespace silt
