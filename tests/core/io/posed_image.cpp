// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "posed_image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace silt {

void ExpectSame(const PosedImage& found, const SequenceDescription& written, std::size_t number,
                const Frame& frame, double depth_step_m) {
  SCOPED_TRACE("frame " + std::to_string(number));
  const PinholeCamera& camera = written.camera;
  EXPECT_NEAR(found.fx, camera.fx, 1e-9);
  EXPECT_NEAR(std::abs(found.fy), camera.fy, 1e-9);
  EXPECT_NEAR(found.cx, camera.cx, 1e-9);
  EXPECT_NEAR(found.cy, camera.cy, 1e-9);
  EXPECT_EQ(found.lens, written.lens);
  // The reader's camera axes in silt's, which have y down and z forward; nine digits at least.
  const SE3d& pose = written.truth[number].world_from_camera;
  const Mat3d rotation = pose.rotation.Matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& row = found.rotation.row[i];
    EXPECT_NEAR(row.x, rotation.row[i].x, 5e-9);
    EXPECT_NEAR(found.y_sign() * row.y, rotation.row[i].y, 5e-9);
    EXPECT_NEAR(found.z_sign * row.z, rotation.row[i].z, 5e-9);
  }
  EXPECT_LT(Norm(found.position - pose.translation), 1e-9);
  EXPECT_EQ(found.rgb, frame.rgb);
  ASSERT_EQ(found.depth_m.size(), frame.depth_m.size());
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    ASSERT_NEAR(found.depth_m.data()[i], frame.depth_m.data()[i], 0.5 * depth_step_m + 1e-6);
  }
}

SequenceFolder::SequenceFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "silt-seq-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make " + pattern);
  path_ = pattern;
}

std::string ReadText(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace silt
