// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/io/sequence_writer.h"

namespace silt {

// The layout that nerfstudio, instant-ngp and most radiance fields read:
//   transforms.json    intrinsics, and for each frame its files and transform_matrix
//   images/000000.png  colours
//   depth/000000.png   along z, 16 bits, 1000 per metre, as nerfstudio expects
// transform_matrix is camera to world with OpenGL's camera axes (x right, y up, z backwards); the
// world is silt's, z up. Its pixels are squares [u, u + 1]: their centres lie at halves, so that
// cx and cy are silt's plus ½.
class NerfstudioSequenceWriter : public SequenceWriter {
 public:
  NerfstudioSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  std::filesystem::path folder_;
  SequenceDescription description_;
};

}  // namespace silt
