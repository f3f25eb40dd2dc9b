// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/euroc_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "posed_image.h"
#include "silt/core/error.h"
#include "silt/core/io/euroc_sequence_writer.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class EurocSequenceTest : public testing::Test {
 protected:
  void SetUp() override {
    EurocSequenceWriter writer(folder_.path(), description_);
    WriteBox(writer, description_);
  }
  void Overwrite(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / ("mav0/" + name)) << text;
  }
  // Puts `after` in the place of `before` in cam0/sensor.yaml.
  void Edit(const std::string& before, const std::string& after) const {
    std::string text = ReadText(folder_ / "mav0/cam0/sensor.yaml");
    text.replace(text.find(before), before.size(), after);
    Overwrite("cam0/sensor.yaml", text);
  }
  std::string ErrorOfReading() const {
    try {
      EurocSequence sequence(folder_.path());
      while (sequence.Next()) {
      }
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  SequenceFolder folder_;
  const SequenceDescription description_ = BoxDescription(3);
};

TEST_F(EurocSequenceTest, ReadsWhatWasWritten) {
  EurocSequence sequence(folder_.path());
  ASSERT_EQ(sequence.size(), 3);
  EXPECT_EQ(sequence.camera().fx, kBoxCamera.fx);
  EXPECT_EQ(sequence.camera().height, kBoxCamera.height);
  for (const StampedPose& truth : description_.truth) {
    const Frame expected = BoxFrame(truth.world_from_camera, truth.time_s);
    const std::optional<Frame> frame = sequence.Next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->time_s, truth.time_s, 1e-9);
    EXPECT_EQ(frame->rgb, expected.rgb);  // gray, as the box is
    EXPECT_NEAR(frame->depth_m(20, 30), expected.depth_m(20, 30), 1.01e-4);
  }
  EXPECT_FALSE(sequence.Next());
  for (std::size_t i = 0; i < 3; ++i) {
    const SE3d gap =
        sequence.truth()[i].world_from_camera.Inverse() * description_.truth[i].world_from_camera;
    EXPECT_LT(Norm(gap.translation) + RotationAngle(gap.rotation), 1e-8);
  }
}

// Of the published sequences: times of 19 digits, a body that is not the camera, no depth.
TEST_F(EurocSequenceTest, MovesStatesFromTheBodyToTheCamera) {
  fs::remove_all(folder_ / "mav0/depth0");
  Overwrite("cam0/data.csv",
            "#timestamp [ns],filename\n1403636579763555584,0000000000000000000.png\r\n");
  Overwrite("state_groundtruth_estimate0/data.csv",
            "#timestamp, p\n1403636579763555584, 1, 2, 3, 1, 0, 0, 0, 0.1\n");
  Edit("[1.0, 0.0, 0.0, 0.0,\n         0.0, 1.0, 0.0, 0.0,",
       "[0.0, -1.0, 0.0, 0.5,\n         1.0, 0.0, 0.0, 0.25,");
  EurocSequence sequence(folder_.path());
  EXPECT_NEAR(sequence.times_s()[0], 1403636579.763555584, 1e-6);
  const SE3d& pose = sequence.truth()[0].world_from_camera;
  EXPECT_LT(Norm(pose.translation - Vec3d{1.5, 2.25, 3}), 1e-12);
  EXPECT_LT(Norm(pose.rotation * Vec3d{1, 0, 0} - Vec3d{0, 1, 0}), 1e-12);
  EXPECT_TRUE(sequence.Next()->depth_m.empty());
}

TEST_F(EurocSequenceTest, BadCamerasAreNamed) {
  Edit("coefficients: [0", "coefficients: [-0.28");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("cam0/sensor.yaml: the lens has distortion"));
  Edit("coefficients: [-0.28, 0", "coefficients: [0");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("needs distortion_coefficients: [4 numbers]"));
  Edit("intrinsics: [120.3", "intrinsics: [-120.3");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("focal lengths must be positive"));
  Edit("intrinsics: [-120.3", "intrinsics: [a");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("'a' is not a number"));
  Overwrite("cam0/sensor.yaml", "");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("needs intrinsics"));
}

TEST_F(EurocSequenceTest, BadListsAreNamedWithTheirLine) {
  const std::string states = ReadText(folder_ / "mav0/state_groundtruth_estimate0/data.csv");
  Overwrite("state_groundtruth_estimate0/data.csv", "#\n0,1,2,3,2,0,0,0\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("data.csv:2: the quaternion is not of norm 1"));
  Overwrite("state_groundtruth_estimate0/data.csv", "#\n0,1,2,3,1,0,0\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("data.csv:2: expected 8 columns"));
  Overwrite("state_groundtruth_estimate0/data.csv", "0,1,2,3,1,0,0,0\n0,1,2,3,1,0,0,0\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("data.csv:2: time does not increase"));
  Overwrite("state_groundtruth_estimate0/data.csv", states);
  Edit("[1.0, 0.0", "[2.0, 0.0");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("T_BS is no rigid motion"));
  Edit("[2.0, 0.0", "[1.0, 0.0");
  Overwrite("cam0/data.csv", "0.5,a.png\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("cam0/data.csv:1: '0.5' is no time in nanoseconds"));
  Overwrite("cam0/data.csv", "5,a.png\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("a.png: no such image"));
  Overwrite("cam0/data.csv", "# none\n");
  EXPECT_THAT(ErrorOfReading(), HasSubstr("lists no image"));
}

}  // namespace
}  // namespace silt
