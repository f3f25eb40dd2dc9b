// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"
#include "silt/sim/path_file.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

// A wall in the plane x = 1 and a box, beside the line from (0, 0, 1) to (2, 0, 1).
Scene WallAndBox() {
  SceneBuilder builder;
  builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
  builder.AddQuad({1, -3, 0}, {0, 2, 0}, {0, 0, 2}, 0);
  builder.AddBox({0.4f, 0.1f, 0.5f}, {0.6f, 0.3f, 1.5f}, 0);
  builder.scene.instances = {{"wall", 0, 2}, {"box", 2, 12}};
  return builder.scene;
}

CameraPath LineAt(double y) {
  const std::string at = std::to_string(y);
  return ParseCameraPath(
      "[line]\nfrom = [0, " + at + ", 1]\nto = [2, " + at + ", 1]\nduration_s = 4\n", "line.toml");
}

TEST(PathCheck, FindsTheWallThatThePathCrosses) {
  const PathCheck check = CheckPath(LineAt(-2), WallAndBox(), {});
  ASSERT_EQ(check.contacts.size(), 1u);
  const PathContact& contact = check.contacts[0];
  EXPECT_TRUE(check.Crosses());
  EXPECT_TRUE(contact.crosses);
  EXPECT_EQ(contact.instance, "wall");
  EXPECT_NEAR(contact.nearest_s, 2, 0.02);
  EXPECT_NEAR(contact.start_s, 1.9, 0.02);  // 5 cm before, at 0.5 m/s
  EXPECT_NEAR(contact.end_s, 2.1, 0.02);
  EXPECT_EQ(contact.distance_m, 0);
  EXPECT_THAT(Describe(contact), HasSubstr("at 2.0"));
  EXPECT_THAT(Describe(contact), HasSubstr("crosses 'wall'"));
}

TEST(PathCheck, MeasuresHowNearItComes) {
  const PathCheck check = CheckPath(LineAt(0.07), WallAndBox(), {});
  ASSERT_EQ(check.contacts.size(), 1u);
  EXPECT_FALSE(check.Crosses());
  EXPECT_EQ(check.contacts[0].instance, "box");
  EXPECT_NEAR(check.contacts[0].distance_m, 0.03, 1e-6);
  EXPECT_NEAR(check.contacts[0].start_s, 0.72, 0.02);  // √(50² − 30²) mm before the corner
  EXPECT_THAT(Describe(check.contacts[0]), HasSubstr("only 30 mm from 'box'"));
  EXPECT_TRUE(CheckPath(LineAt(0.04), WallAndBox(), {}).contacts.empty());
  EXPECT_EQ(CheckPath(LineAt(0.04), WallAndBox(), {.clearance_m = 0.1}).contacts.size(), 1u);
  EXPECT_TRUE(CheckPath(LineAt(0.07), WallAndBox(), {.clearance_m = 0}).contacts.empty());
}

TEST(PathCheck, FindsCrossingsWithoutClearance) {
  const PathCheck check = CheckPath(LineAt(0.2), WallAndBox(), {.clearance_m = 0});
  ASSERT_EQ(check.contacts.size(), 2u);  // in and out, half a second apart
  for (const PathContact& contact : check.contacts) EXPECT_TRUE(contact.crosses);
  EXPECT_NEAR(check.contacts[0].nearest_s, 0.8, 0.02);
  EXPECT_NEAR(check.contacts[1].nearest_s, 1.2, 0.02);
}

TEST(PathCheck, LooksAtTheStretchThatItIsGiven) {
  EXPECT_TRUE(CheckPath(LineAt(-2), WallAndBox(), {.start_s = 2.2}).contacts.empty());
  EXPECT_TRUE(CheckPath(LineAt(-2), WallAndBox(), {.duration_s = 1.8}).contacts.empty());
  EXPECT_EQ(CheckPath(LineAt(-2), WallAndBox(), {.duration_s = 2.2}).contacts.size(), 1u);
}

TEST(PathCheck, RefusesOptionsOutOfRange) {
  const auto refused = [](const PathCheckOptions& options) {
    return ErrorOf([&] { CheckPath(LineAt(0), WallAndBox(), options); });
  };
  EXPECT_THAT(refused({.clearance_m = -1}), HasSubstr("clearance"));
  EXPECT_THAT(refused({.clearance_m = NAN}), HasSubstr("clearance"));
  EXPECT_THAT(refused({.start_s = -1}), HasSubstr("start"));
  EXPECT_THAT(refused({.start_s = 5}), HasSubstr("lasts 4.0"));
  EXPECT_THAT(refused({.start_s = 2, .duration_s = 3}), HasSubstr("lasts 4.0"));
}

TEST(PathCheck, KnowsTheInstanceOfATriangle) {
  const Scene scene = WallAndBox();
  EXPECT_EQ(InstanceOf(scene, 1).name, "wall");
  EXPECT_EQ(InstanceOf(scene, 2).name, "box");
  EXPECT_EQ(InstanceOf(scene, 13).name, "box");
}

}  // namespace
}  // namespace silt::sim
