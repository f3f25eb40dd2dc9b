// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/icl_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "posed_image.h"
#include "silt/core/error.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// As the code published with the frames reads them (getcamK, computeRT, compute3Dpositions), in
// POV-Ray's left-handed axes.
PosedImage ReadAsPublished(const fs::path& folder, int number) {
  char name[32];
  std::snprintf(name, sizeof name, "scene_00_%04d", number);
  Vec3d position, direction, up, right;
  std::ifstream camera(folder / (std::string(name) + ".txt"));
  for (std::string line; std::getline(camera, line);) {
    Vec3d v;
    std::string key = line.substr(0, line.find(' '));
    if (line.find('[') == line.npos) continue;
    std::sscanf(line.c_str() + line.find('['), "[%lf, %lf, %lf]'", &v.x, &v.y, &v.z);
    if (key == "cam_pos") position = v;
    if (key == "cam_dir") direction = v;
    if (key == "cam_up") up = v;
    if (key == "cam_right") right = v;
  }
  const Vec3d z = Normalized(direction), x = Normalized(Cross(up, z)), y = Cross(z, x);
  PosedImage image;
  image.rotation = Transposed(Mat3d{{x, y, z}});
  image.position = position;
  image.gray = GrayFromRgb(ReadRgb(folder / (std::string(name) + ".png")));
  const int width = image.gray.width(), height = image.gray.height();
  image.fx = width * Norm(direction) / Norm(right);
  image.fy = -height * Norm(direction) / Norm(up);
  image.cx = (width + 1) * 0.5 - 1;
  image.cy = (height + 1) * 0.5 - 1;
  image.depth_m = Image<float>(width, height);
  std::ifstream depth(folder / (std::string(name) + ".depth"));
  for (float& ray : image.depth_m) depth >> ray;
  return WithDepthMistaken(image, -1);
}

class IclSequenceTest : public testing::Test {
 protected:
  void Write(int frames) const {
    const SequenceDescription description = BoxDescription(frames);
    IclSequenceWriter writer(folder_.path(), description);
    WriteBox(writer, description);
  }
  std::string ErrorOfReading() const {
    try {
      IclSequence sequence(folder_.path());
      while (sequence.Next()) {
      }
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }
  void Overwrite(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  SequenceFolder folder_;
};

TEST_F(IclSequenceTest, PublishedCodeFindsThePicturesConsistent) {
  Write(4);
  const PosedImage from = ReadAsPublished(folder_.path(), 0),
                   to = ReadAsPublished(folder_.path(), 3);
  EXPECT_NEAR(from.fx, 120.3, 1e-6);
  EXPECT_NEAR(from.fy, -120, 1e-6);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
  EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
  EXPECT_GT(WarpError(WithDepthMistaken(from, 1), WithDepthMistaken(to, 1)), 3 * right);
}

TEST_F(IclSequenceTest, ReadsWhatWasWritten) {
  Write(3);
  const SequenceDescription description = BoxDescription(3);
  IclSequence sequence(folder_.path());
  EXPECT_EQ(sequence.size(), 3);
  EXPECT_NEAR(sequence.camera().fx, kBoxCamera.fx, 1e-6);
  EXPECT_NEAR(sequence.camera().fy, kBoxCamera.fy, 1e-6);
  EXPECT_EQ(sequence.camera().cx, kBoxCamera.cx);
  for (std::size_t i = 0; i < 3; ++i) {
    const StampedPose& truth = description.truth[i];
    const Frame expected = BoxFrame(truth.world_from_camera, truth.time_s);
    const std::optional<Frame> frame = sequence.Next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->time_s, truth.time_s, 1e-9);
    EXPECT_EQ(frame->rgb, expected.rgb);
    for (std::size_t k = 0; k < frame->depth_m.size(); ++k) {
      ASSERT_NEAR(frame->depth_m.data()[k], expected.depth_m.data()[k], 1e-6 * 8);
    }
    const SE3d difference =
        sequence.truth()[i].world_from_camera.Inverse() * truth.world_from_camera;
    EXPECT_LT(Norm(difference.translation), 1e-8);
    EXPECT_LT(RotationAngle(difference.rotation), 1e-8);
  }
  EXPECT_FALSE(sequence.Next());
}

TEST_F(IclSequenceTest, WithoutTimesFramesAreAThirtiethApart) {
  Write(3);
  fs::remove(folder_ / "scene.gt.freiburg");
  EXPECT_EQ(IclSequence(folder_.path()).times_s(), (std::vector<double>{0, 1 / 30.0, 2 / 30.0}));
}

TEST_F(IclSequenceTest, DepthMayBeMissing) {
  Write(1);
  fs::remove(folder_ / "scene_00_0000.depth");
  EXPECT_TRUE(IclSequence(folder_.path()).Next()->depth_m.empty());
}

TEST_F(IclSequenceTest, BadFilesAreNamed) {
  EXPECT_THAT(ErrorOfReading(), HasSubstr("scene_00_0000.png: no such image"));
  Write(2);
  Overwrite("scene_00_0001.depth", "1 2 three");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("scene_00_0001.depth: number 3 of 19200 is none"));
  Overwrite("scene_00_0001.depth", "1 2");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("number 3"));
  Overwrite("scene_00_0001.depth", "1 nan");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("number 2"));
  Overwrite("scene_00_0001.txt", "cam_pos = [1, 2]';\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("scene_00_0001.txt: has no line"));
  Overwrite("scene_00_0001.txt",
            "cam_pos = [1, 2, 3]';\ncam_dir = [0, 0, 1]';\ncam_up = [0, 0, 2]';\n"
            "cam_right = [1, 0, 0]';\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("do not span a camera"));
  fs::remove(folder_ / "scene_00_0001.txt");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("scene_00_0001.txt: cannot be read"));
}

TEST_F(IclSequenceTest, RefusesACameraWhosePrincipalPointIsElsewhere) {
  SequenceDescription description = BoxDescription(1);
  description.camera.cx += 1;
  EXPECT_THROW(IclSequenceWriter(folder_.path(), description), Error);
}

}  // namespace
}  // namespace silt
