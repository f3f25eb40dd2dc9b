// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/icl_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "silt/core/error.h"

namespace silt {
namespace {

using testing::HasSubstr;

const SE3d kPose{Quaterniond::Exp({0.3, -1.2, 0.7}), {1.5, -2.5, 0.25}};

// A camera at rest on POV-Ray's origin looks along its z with y up: silt's y and z.
TEST(IclCamera, AxesAreAsDocumented) {
  const IclCamera camera = ParseIclCamera(
      "cam_pos      = [1, 2, 3]';\ncam_dir      = [0, 0, 1]';\ncam_up       = [0, 1, 0]';\n"
      "cam_right    = [1.33, 0, 0]';\n",
      "test");
  const SE3d& pose = camera.world_from_camera;
  EXPECT_LT(Norm(pose.translation - Vec3d{1, 3, 2}), 1e-12);
  EXPECT_LT(Norm(pose.rotation * Vec3d{0, 0, 1} - Vec3d{0, 1, 0}), 1e-12);
  EXPECT_LT(Norm(pose.rotation * Vec3d{0, -1, 0} - Vec3d{0, 0, 1}), 1e-12);
  EXPECT_LT(Norm(pose.rotation * Vec3d{1, 0, 0} - Vec3d{1, 0, 0}), 1e-12);
  EXPECT_NEAR(640 / camera.width, 481.2, 0.01);
}

TEST(IclCamera, PublishedFileIsUnderstood) {
  // Frame 0 of a published trajectory, whose unit is a centimetre.
  const IclCamera camera = ParseIclCamera(
      "cam_pos      = [149.376, 451.41, -285.9]';\ncam_dir      = [0.421738, -0.409407, "
      "0.809026]';\ncam_up       = [-0.0482194, 0.880868, 0.470899]';\ncam_lookat   = [0, 0, "
      "1]';\ncam_sky      = [0, 1, 0]';\ncam_right    = [1.20423, 0.316017, -0.467833]';\n"
      "cam_fpoint   = [0, 0, 10]';\ncam_angle    = 90;\n",
      "scene_00_0000.txt");
  EXPECT_NEAR(640 / camera.width, 481.2, 0.05);
  EXPECT_NEAR(480 / camera.height, 480, 0.05);
  const Vec3d forward = camera.world_from_camera.rotation * Vec3d{0, 0, 1};
  EXPECT_LT(Norm(forward - Vec3d{0.421738, 0.809026, -0.409407}), 1e-5);
  const Vec3d across = camera.world_from_camera.rotation * Vec3d{1, 0, 0};
  EXPECT_LT(Norm(1.33 * across - Vec3d{1.20423, -0.467833, 0.316017}), 5e-3);
}

TEST(IclCamera, FormatAndParseAreInverse) {
  const IclCamera camera = ParseIclCamera(FormatIclCamera({kPose, 1.25, 0.75}), "test");
  EXPECT_LT(Norm(camera.world_from_camera.translation - kPose.translation), 1e-8);
  EXPECT_LT(RotationAngle(camera.world_from_camera.rotation.Conjugate() * kPose.rotation), 1e-8);
  EXPECT_NEAR(camera.width, 1.25, 1e-8);
  EXPECT_NEAR(camera.height, 0.75, 1e-8);
}

TEST(IclCamera, AxesThereAndBackAreTheSame) {
  const SE3d back = SiltFromIcl(IclFromSilt(kPose));
  EXPECT_LT(Norm(back.translation - kPose.translation), 1e-12);
  EXPECT_LT(RotationAngle(back.rotation.Conjugate() * kPose.rotation), 1e-7);
  EXPECT_GT(Norm(IclFromSilt(kPose).translation - kPose.translation), 1);
}

TEST(IclCamera, RefusesWhatIsNoCamera) {
  const std::string whole = FormatIclCamera({kPose});
  for (const char* name : {"cam_pos", "cam_dir", "cam_up", "cam_right"}) {
    std::string text = whole;
    text.replace(text.find(name), 5, "moved");
    try {
      ParseIclCamera(text, "file.txt");
      ADD_FAILURE() << name;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(std::string("file.txt: has no line \"") + name));
    }
  }
  EXPECT_THROW(ParseIclCamera("", "file.txt"), Error);
}

}  // namespace
}  // namespace silt
