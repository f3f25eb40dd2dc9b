// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "silt/core/color.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

constexpr const char* kMaterial = "[[material]]\nname = 'm'\n";  // two lines
constexpr const char* kBox = "[[box]]\nmaterial = 'm'\nsize = [1, 2, 3]\n";

SceneFile Read(const std::string& toml) {
  const TempFolder folder;
  folder.Write("picture.png", "");
  folder.Write("model.obj", "");
  folder.Write("models.zip", "");
  return ReadSceneFile(folder.Write("scene.toml", toml));
}

TEST(SceneFileTest, ReadsEveryKindOfEntry) {
  const SceneFile file = Read(R"(
name = "Room"
ambient = [0.1, 0.2, 0.3]
exposure = 1.5
[[archive]]
id = "zip"
file = "models.zip"
[[material]]
name = "red"
color = "#ff0080"
[[material]]
name = "carpet"
texture = "picture.png"
tile_m = [0.5, 2]
emission = [1, 2, 3]
cutout = true
two_sided = false
[[box]]
material = "red"
faces = { top = "carpet", left = "carpet" }
size = [1, 2, 3]
at = [4, 5, 6]
yaw_deg = 30
[[quad]]
name = "wall"
material = "carpet"
corner = [1, 0, 0]
u = [2, 0, 0]
v = [0, 0, 3]
[[sphere]]
material = "red"
center = [0, 0, 1]
radius = 0.25
segments = 12
[[cylinder]]
material = "red"
radius = 0.5
height = 2
[[model]]
archive = "zip"
file = "a/b.obj"
size = [1, 1, 2]
up = "z"
mirror = true
rotation = [0, -1, 0, 1, 0, 0, 0, 0, 1]
materials = { Old = "carpet" }
[[model]]
file = "model.obj"
scale = 0.01
[[light]]
center = [0, 0, 2]
u = [1, 0, 0]
v = [0, -1, 0]
radiance = [9, 8, 7]
)");
  EXPECT_EQ(file.name, "Room");
  EXPECT_EQ(file.ambient.z, 0.3);
  EXPECT_EQ(file.exposure, 1.5);
  EXPECT_EQ(file.archives.at("zip").file.filename(), "models.zip");
  ASSERT_EQ(file.materials.size(), 2u);
  EXPECT_EQ(file.materials[0].material.diffuse.x, 1);
  EXPECT_EQ(file.materials[0].material.diffuse.y, 0);
  EXPECT_FLOAT_EQ(file.materials[0].material.diffuse.z, LinearFromSrgb(128 / 255.0f));
  EXPECT_EQ(file.materials[1].material.diffuse.y, 1);  // white under a texture
  EXPECT_EQ(file.materials[1].tile_m->y, 2);
  EXPECT_EQ(file.materials[1].material.emission.z, 3);
  EXPECT_TRUE(file.materials[1].material.cutout);
  EXPECT_FALSE(file.materials[1].material.two_sided);
  EXPECT_TRUE(file.materials[0].material.two_sided);
  EXPECT_EQ(file.boxes.at(0).name, "box 1");
  EXPECT_THAT(file.boxes[0].faces, testing::ElementsAre(1, 0, 0, 0, 1, 0));
  EXPECT_EQ(file.boxes[0].yaw_deg, 30);
  EXPECT_EQ(file.quads.at(0).name, "wall");
  EXPECT_EQ(file.quads[0].v.z, 3);
  EXPECT_EQ(file.spheres.at(0).segments, 12);
  EXPECT_EQ(file.cylinders.at(0).height, 2);
  EXPECT_EQ(file.cylinders[0].at.x, 0);
  ASSERT_EQ(file.models.size(), 2u);
  EXPECT_EQ(file.models[0].file, "a/b.obj");
  EXPECT_TRUE(file.models[0].z_up);
  EXPECT_TRUE(file.models[0].mirror);
  EXPECT_EQ(file.models[0].rotation.row[0].y, -1);
  EXPECT_EQ(file.models[0].materials.at("Old"), 1);
  EXPECT_EQ(file.models[0].size->z, 2);
  EXPECT_FALSE(file.models[1].size.has_value());
  EXPECT_EQ(file.models[1].scale, 0.01);
  EXPECT_EQ(file.models[1].name, "model 2");
  EXPECT_EQ(file.lights.at(0).v.y, -1);
  EXPECT_EQ(file.lights[0].radiance.x, 9);
}

TEST(SceneFileTest, HasDefaults) {
  const SceneFile file = Read(std::string(kMaterial) + kBox);
  EXPECT_THAT(file.name, testing::StartsWith("silt_SceneFileTest"));  // the folder's
  EXPECT_EQ(file.exposure, 1);
  EXPECT_EQ(file.ambient.x, 0.2);
  EXPECT_EQ(file.materials.at(0).material.diffuse.x, 0.5f);
  EXPECT_EQ(file.boxes.at(0).at.z, 0);
}

TEST(SceneFileTest, ReadsReflection) {
  const SceneFile file = Read(std::string(kMaterial) + "specular = 0.04\nmetallic = 0.5\n" +
                              "roughness = 0.3\n[[material]]\nname = 'n'\nmirror = true\n" + kBox);
  EXPECT_EQ(file.materials[0].material.specular, 0.04f);
  EXPECT_EQ(file.materials[0].material.metallic, 0.5f);
  EXPECT_EQ(file.materials[0].material.roughness, 0.3f);
  EXPECT_TRUE(file.materials[0].material.reflects());
  EXPECT_TRUE(file.materials[1].material.mirror);
  EXPECT_FALSE(Read(std::string(kMaterial) + kBox).materials[0].material.reflects());
}

TEST(SceneFileTest, ReadsTheEnvironment) {
  const std::string rest = std::string(kMaterial) + kBox;
  const SceneFile sky = Read(rest + "[environment]\nzenith = [1, 2, 3]\nhorizon = [4, 5, 6]\n" +
                             "ground = [0, 0, 0.5]\n");
  EXPECT_EQ(sky.environment->sky.horizon.y, 5);
  EXPECT_TRUE(sky.environment->file.empty());
  const SceneFile file =
      Read(rest + "[environment]\nfile = 'model.obj'\nstrength = 2\nyaw_deg = -90\n");
  EXPECT_EQ(file.environment->strength, 2);
  EXPECT_EQ(file.environment->yaw_deg, -90);
  EXPECT_THAT(ErrorOf([&] {
                Read("ambient = [1, 1, 1]\n" + rest + "[environment]\nfile = 'model.obj'\n");
              }),
              HasSubstr(":1: ambient and [environment] exclude each other"));
}

struct BadScene {
  const char* after_material;  // its first line is line 3 of the file
  const char* message;         // after the file's name
};
void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.message; }

class SceneFileBadTest : public testing::TestWithParam<BadScene> {};

TEST_P(SceneFileBadTest, NamesTheLine) {
  const std::string message =
      ErrorOf([] { Read(std::string(kMaterial) + GetParam().after_material); });
  EXPECT_THAT(message, HasSubstr(std::string("scene.toml:") + GetParam().message));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneFileBadTest,
    testing::Values(
        BadScene{"", "1: the scene is empty"},
        BadScene{"color = '#12345g'\n", "3: color must look like \"#rrggbb\""},
        BadScene{"color = '#123'\n", "3: color must look like \"#rrggbb\""},
        BadScene{"color = [0, 0, 1.5]\n", "3: color must lie in 0..1"},
        BadScene{"color = 3\n", "3: color must be an array of 3"},
        BadScene{"colour = '#123456'\n", "3: unknown key 'colour'"},
        BadScene{"texture = 'none.png'\n", "3: texture names no file"},
        BadScene{"texture = '.'\n", "3: texture names no file"},
        BadScene{"tile_m = [1, 0]\n", "3: tile_m must be above 0"},
        BadScene{"tile_m = 1\n", "3: tile_m must be an array of 2"},
        BadScene{"emission = [-1, 0, 0]\n", "3: emission must not be negative"},
        BadScene{"specular = 1.5\n", "3: specular must lie in 0..1"},
        BadScene{"metallic = -1\n", "3: metallic must lie in 0..1"},
        BadScene{"roughness = 'x'\n", "3: roughness must be a"},
        BadScene{"mirror = 1\n", "3: mirror must be"},
        BadScene{"mirror = true\nroughness = 0.1\n", "4: roughness does not go with mirror"},
        BadScene{"[environment]\nzenith = [1, 1, 1]\n", "3: horizon is missing"},
        BadScene{"[environment]\nfile = 'none.hdr'\n", "4: file names no file"},
        BadScene{"[environment]\nfile = 'model.obj'\nstrength = 0\n",
                 "5: strength must be above 0"},
        BadScene{"[environment]\nfile = 'model.obj'\nzenith = [1, 1, 1]\n",
                 "5: unknown key 'zenith'"},
        BadScene{"[[material]]\nname = 'm'\n", "4: name is taken"},
        BadScene{"[[material]]\n", "3: name is missing"},
        BadScene{"[[box]]\nsize = [1, 1, 1]\n", "3: material is missing"},
        BadScene{"[[box]]\nmaterial = 'x'\n", "4: material names no [[material]]"},
        BadScene{"[[box]]\nmaterial = 'm'\nsize = [1, 1, 0]\n", "5: size must be above 0"},
        BadScene{"[[box]]\nmaterial = 'm'\nfaces = { roof = 'm' }\n", "5: faces has no 'roof'"},
        BadScene{"[[box]]\nmaterial = 'm'\nfaces = { top = 'x' }\n", "5: faces names no"},
        BadScene{"[[boxes]]\nmaterial = 'm'\n", "3: unknown key 'boxes'"},
        BadScene{"[box]\nmaterial = 'm'\n", "3: box must be written as [[box]]"},
        BadScene{"[[quad]]\nmaterial = 'm'\ncorner = [0, 0, 0]\nu = [1, 0, 0]\nv = [2, 0, 0]\n",
                 "7: v must span an area"},
        BadScene{"[[quad]]\nmaterial = 'm'\ncorner = [0, 0, 0]\nu = [0, 0, 0]\nv = [2, 0, 0]\n",
                 "7: v must span an area"},
        BadScene{"[[sphere]]\nmaterial = 'm'\ncenter = [0, 0, 0]\nradius = -1\n",
                 "6: radius must be above 0"},
        BadScene{"[[sphere]]\nmaterial = 'm'\ncenter = [0, 0, 0]\nradius = 1\nsegments = 2\n",
                 "7: segments must lie in 3..1024"},
        BadScene{"[[cylinder]]\nmaterial = 'm'\nradius = 1\n", "3: height is missing"},
        BadScene{"[[model]]\nfile = 'none.obj'\n", "4: file names no file"},
        BadScene{"[[model]]\narchive = 'x'\nfile = 'a.obj'\n", "4: archive names no [[archive]]"},
        BadScene{"[[model]]\nfile = 'model.obj'\nup = 'x'\n", "5: up must be"},
        BadScene{"[[model]]\nfile = 'model.obj'\nscale = 0\n", "5: scale must be above 0"},
        BadScene{"[[model]]\nfile = 'model.obj'\nsize = [1, 1, 1]\nscale = 1\n",
                 "6: scale and size exclude each other"},
        BadScene{"[[model]]\nfile = 'model.obj'\nrotation = [2, 0, 0, 0, 1, 0, 0, 0, 1]\n",
                 "5: rotation must be a rotation matrix"},
        BadScene{"[[model]]\nfile = 'model.obj'\nrotation = [-1, 0, 0, 0, 1, 0, 0, 0, 1]\n",
                 "5: rotation must be a rotation matrix"},
        BadScene{"[[model]]\nfile = 'model.obj'\nmaterials = { a = 'x' }\n",
                 "5: materials names no [[material]]"},
        BadScene{"[[archive]]\nid = 'a'\nfile = 'none.zip'\n", "5: file names no file"},
        BadScene{"[[archive]]\nid = 'a'\nfile = 'models.zip'\n[[archive]]\nid = 'a'\n"
                 "file = 'models.zip'\n",
                 "7: id is taken"},
        BadScene{"[[light]]\ncenter = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 1, 0]\n",
                 "3: radiance is missing"},
        BadScene{"[[light]]\ncenter = [0, 0, inf]\n", "4: center must be an array of 3 finite"}));

TEST(SceneFileTest, ChecksItsHead) {
  const std::string rest = std::string(kMaterial) + kBox;
  EXPECT_THAT(ErrorOf([&] { Read("exposure = 0\n" + rest); }), HasSubstr(":1: exposure must be"));
  EXPECT_THAT(ErrorOf([&] { Read("\nambient = [0, -1, 0]\n" + rest); }),
              HasSubstr(":2: ambient must not be negative"));
  EXPECT_THAT(ErrorOf([&] { Read("nmae = 'x'\n" + rest); }), HasSubstr(":1: unknown key 'nmae'"));
}

TEST(SceneFileTest, ReportsMissingFiles) {
  EXPECT_THAT(ErrorOf([] { ReadSceneFile("/nowhere/scene.toml"); }),
              HasSubstr("/nowhere/scene.toml: no such file"));
}

}  // namespace
}  // namespace silt::sim
