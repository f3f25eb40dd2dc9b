// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/io/sequence_writer.h"

namespace silt {

// A point, seen at the centre of a pixel of one image.
struct ColmapPoint {
  long long id = 0;
  int x = 0, y = 0;
  Vec3d position;  // in world coordinates
  Rgb8 color;
};

// A COLMAP model in text, as it and Gaussian splatting read it:
//   images/000000.png       colours
//   depth/000000.png        an addition: along z, 16 bits, 5000 per metre
//   sparse/0/cameras.txt    one camera: PINHOLE, or FULL_OPENCV with a lens
//   sparse/0/images.txt     camera from world (the inverse of silt's poses), and observed points
//   sparse/0/points3D.txt   points of known depth on a grid of every kPointFrames-th frame, each
//                           observed by that frame
// COLMAP's pixels are squares [u, u + 1]: their centres lie at halves, so that cx and cy, and the
// places of points, are silt's plus ½.
class ColmapSequenceWriter : public SequenceWriter {
 public:
  static constexpr int kPointFrames = 10, kPointPixels = 16;

  ColmapSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  std::vector<ColmapPoint> PointsOf(int number, long long first_id) const;

  std::filesystem::path folder_;
  SequenceDescription description_;
};

}  // namespace silt
