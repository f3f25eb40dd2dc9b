// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"

namespace silt::sim {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

auto ErrorThat(const std::string& says) {
  return Contains(
      AllOf(Field(&SceneFinding::is_error, true), Field(&SceneFinding::message, HasSubstr(says))));
}
auto WarningThat(const std::string& says) {
  return Contains(
      AllOf(Field(&SceneFinding::is_error, false), Field(&SceneFinding::message, HasSubstr(says))));
}

// A floor with a box on it, and light.
Scene FloorAndBox() {
  SceneBuilder builder;
  builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
  builder.AddQuad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0);
  builder.AddBox({1, 1, 0}, {2, 2, 1}, 0);
  builder.scene.instances = {{"floor", 0, 2}, {"box", 2, 12}};
  builder.scene.ambient = {1, 1, 1};
  return builder.scene;
}

TEST(SceneCheck, FindsNothingInAGoodScene) { EXPECT_THAT(CheckScene(FloorAndBox()), IsEmpty()); }

TEST(SceneCheck, PassesOnWhatLoadingWarnedOf) {
  Scene scene = FloorAndBox();
  scene.warnings = {"model lacks its picture"};
  EXPECT_THAT(CheckScene(scene), WarningThat("lacks its picture"));
}

TEST(SceneCheck, DarknessIsAnError) {
  Scene scene = FloorAndBox();
  scene.ambient = {};
  EXPECT_THAT(CheckScene(scene), ErrorThat("nothing lights the scene: add"));
  scene.materials[0].emission = {1, 1, 1};
  EXPECT_THAT(CheckScene(scene), WarningThat("materials that emit are all that lights the scene"));
  scene.lights.push_back({});
  EXPECT_THAT(CheckScene(scene), IsEmpty());
  scene.lights.clear();
  scene.environment = std::make_shared<const Environment>(MakeSky({}));
  EXPECT_THAT(CheckScene(scene), IsEmpty());
}

TEST(SceneCheck, ImpossibleMaterialsAreErrors) {
  Scene scene = FloorAndBox();
  scene.materials[0].name = "chalk";
  scene.materials[0].diffuse.y = 1.2f;
  EXPECT_THAT(CheckScene(scene), ErrorThat("'chalk' reflects more than it receives"));
  scene.materials[0].diffuse.y = NAN;
  EXPECT_THAT(CheckScene(scene), ErrorThat("'chalk' has a colour that is not finite"));
  scene.materials[0].diffuse.y = 1;
  scene.materials[0].specular = 1.5f;
  EXPECT_THAT(CheckScene(scene), ErrorThat("'chalk' has a specular"));
}

TEST(SceneCheck, BrokenGeometryIsAnError) {
  Scene scene = FloorAndBox();
  scene.mesh.positions[scene.mesh.triangles[5].vertex[0]].x = NAN;
  EXPECT_THAT(CheckScene(scene), ErrorThat("'box' has vertices or normals"));
  scene = FloorAndBox();
  scene.mesh.normals[0] = {};
  EXPECT_THAT(CheckScene(scene), ErrorThat("'floor' has vertices or normals"));
  scene = FloorAndBox();
  scene.instances.push_back({"nothing", 14, 0});
  EXPECT_THAT(CheckScene(scene), ErrorThat("'nothing' has no triangle"));
}

TEST(SceneCheck, FlatTrianglesAndTurnedNormalsAreWarnings) {
  Scene scene = FloorAndBox();
  const std::uint32_t first = scene.mesh.triangles[3].vertex[0];
  scene.mesh.triangles[3].vertex[1] = first;
  EXPECT_THAT(CheckScene(scene), WarningThat("'box' has 1 triangle without area"));
  scene = FloorAndBox();
  for (Vec3f& normal : scene.mesh.normals) normal = -normal;
  EXPECT_THAT(CheckScene(scene), WarningThat("'floor' has 2 triangles of 2 whose normals"));
}

TEST(SceneCheck, ThingsInTheAirOrUndergroundAreWarnings) {
  Scene scene = FloorAndBox();
  for (std::uint32_t v = 4; v < scene.mesh.positions.size(); ++v) {
    scene.mesh.positions[v].z += 0.03f;
  }
  EXPECT_THAT(CheckScene(scene), WarningThat("'box' floats"));
  for (std::uint32_t v = 4; v < scene.mesh.positions.size(); ++v) {
    scene.mesh.positions[v].z -= 0.05f;
  }
  EXPECT_THAT(CheckScene(scene), WarningThat("'box' reaches 20 mm below the floor"));
  // A backdrop may be anywhere.
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emission = {1, 1, 1};
  for (std::uint32_t t = 2; t < 14; ++t) scene.mesh.triangles[t].material = 1;
  EXPECT_THAT(CheckScene(scene), IsEmpty());
}

TEST(SceneCheck, FacesInTheSamePlaceAreWarningsThatNameBoth) {
  Scene scene = FloorAndBox();
  const Scene other = FloorAndBox();
  const auto offset = std::uint32_t(scene.mesh.positions.size());
  // The floor once more.
  for (int i = 0; i < 4; ++i) {
    scene.mesh.positions.push_back(other.mesh.positions[std::size_t(i)]);
    scene.mesh.normals.push_back({0, 0, 1});
    scene.mesh.texcoords.push_back({});
  }
  for (int t = 0; t < 2; ++t) {
    Triangle copy = other.mesh.triangles[std::size_t(t)];
    for (std::uint32_t& v : copy.vertex) v += offset;
    scene.mesh.triangles.push_back(copy);
  }
  scene.instances.push_back({"carpet", 14, 2});
  EXPECT_THAT(CheckScene(scene), WarningThat("'floor' and 'carpet' have faces in the same place"));
}

TEST(SceneCheck, TellsOfErrorsFirst) {
  Scene scene = FloorAndBox();
  scene.warnings = {"a", "b"};
  scene.ambient = {};
  const auto findings = CheckScene(scene);
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_TRUE(findings[0].is_error);
}

}  // namespace
}  // namespace silt::sim
