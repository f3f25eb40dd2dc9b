// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sample_model.h"
#include "silt/core/parallel.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// Materials m and picture, and the sample sheet as a plain file and in an archive.
class SceneTest : public testing::Test {
 protected:
  SceneTest() {
    folder_.Write("picture.png", SamplePng());
    folder_.Write("sheet.obj", SampleObj());
    folder_.Write("sheet.mtl", SampleMtl());
    folder_.Write("sheets.zip", ZipOf({{"d/sheet.obj", SampleObj()},
                                       {"d/sheet.mtl", SampleMtl()},
                                       {"d/picture.png", SamplePng(true)}}));
  }

  Scene Load(const std::string& objects) {
    return LoadScene(folder_.Write("scene.toml",
                                   "[[archive]]\nid = 'zip'\nfile = 'sheets.zip'\n"
                                   "[[material]]\nname = 'm'\ncolor = '#ffffff'\n"
                                   "[[material]]\nname = 'picture'\ntexture = 'picture.png'\n" +
                                       objects));
  }
  std::string LoadError(const std::string& objects) {
    return ErrorOf([&] { Load(objects); });
  }

  TempFolder folder_;
};

const Material& MaterialOf(const Scene& scene, std::size_t instance) {
  return scene.materials.at(
      scene.mesh.triangles.at(scene.instances.at(instance).first_triangle).material);
}

TEST_F(SceneTest, CollectsInstancesInOrder) {
  const Scene scene = Load(
      "[[box]]\nname = 'a'\nmaterial = 'm'\nsize = [1, 1, 1]\n"
      "[[quad]]\nname = 'b'\nmaterial = 'picture'\ncorner = [0, 0, 0]\nu = [1, 0, 0]\n"
      "v = [0, 1, 0]\n[[model]]\nname = 'c'\nfile = 'sheet.obj'\n"
      "[[light]]\nname = 'd'\ncenter = [0, 0, 2]\nu = [0.5, 0, 0]\nv = [0, -0.5, 0]\n"
      "radiance = [3, 2, 1]\n");
  ASSERT_EQ(scene.instances.size(), 4u);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.instances[i].name, std::string(1, char('a' + i)));
    EXPECT_EQ(scene.instances[i].first_triangle, next);
    next += scene.instances[i].triangle_count;
  }
  EXPECT_EQ(next, scene.mesh.triangles.size());
  EXPECT_EQ(scene.instances[0].triangle_count, 12u);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(SceneTest, LightsAreSeenAndShineToUCrossV) {
  const Scene scene = Load(
      "[[box]]\nmaterial = 'm'\nsize = [1, 1, 1]\n[[light]]\ncenter = [0, 0, 2]\n"
      "u = [0.5, 0, 0]\nv = [0, -0.25, 0]\nradiance = [3, 2, 1]\n");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].half_v.y, -0.25f);
  const Material& material = MaterialOf(scene, 1);
  EXPECT_EQ(material.emission.x, 3);
  EXPECT_EQ(material.diffuse.x, 0);
  EXPECT_FALSE(material.two_sided);
  const Triangle& t = scene.mesh.triangles[scene.instances[1].first_triangle];
  EXPECT_EQ(scene.mesh.normals[t.vertex[0]].z, -1);
  EXPECT_EQ(scene.mesh.positions[t.vertex[0]].x, -0.5f);
  EXPECT_EQ(scene.mesh.positions[t.vertex[0]].y, 0.25f);
}

TEST_F(SceneTest, ModelsOfFilesAndArchivesAgree) {
  const Scene scene = Load(
      "[[model]]\nfile = 'sheet.obj'\nsize = [4, 1, 1]\n"
      "[[model]]\narchive = 'zip'\nfile = 'd/sheet.obj'\nsize = [4, 1, 1]\n"
      "[[model]]\narchive = 'zip'\nfile = 'd/sheet.obj'\nat = [1, 1, 1]\n");
  ASSERT_EQ(scene.instances.size(), 3u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3f a = scene.mesh.positions[scene.mesh.triangles[i].vertex[corner]];
      const Vec3f b = scene.mesh.positions[scene.mesh.triangles[2 + i].vertex[corner]];
      EXPECT_EQ(Norm(a - b), 0);
    }
  }
  // The scene's own picture.png is the plain model's as well; the archive has another.
  EXPECT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(MaterialOf(scene, 0).diffuse.y, 1);  // the picture replaces Kd
  EXPECT_FALSE(MaterialOf(scene, 0).cutout);     // its picture is opaque
  EXPECT_TRUE(MaterialOf(scene, 1).cutout);
  EXPECT_EQ(&MaterialOf(scene, 1), &MaterialOf(scene, 2));
}

TEST_F(SceneTest, TexturesAreThoseOfTheirMaterials) {
  const Scene scene = Load(
      "[[quad]]\nmaterial = 'picture'\ncorner = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 1, 0]\n"
      "[[model]]\narchive = 'zip'\nfile = 'd/sheet.obj'\n");
  const Texture& opaque = scene.textures.at(std::size_t(MaterialOf(scene, 0).texture));
  const Texture& holed = scene.textures.at(std::size_t(MaterialOf(scene, 1).texture));
  EXPECT_NEAR(opaque.Alpha(0.75f, 0.25f), 1, 1e-6);
  EXPECT_NEAR(holed.Alpha(0.75f, 0.25f), 0, 1e-6);
  EXPECT_NEAR(opaque.Sample(0.25f, 0.75f, 0).x, 1, 1e-6);  // red above
  EXPECT_NEAR(opaque.Sample(0.25f, 0.25f, 0).z, 1, 1e-6);  // blue below
}

TEST_F(SceneTest, GltfColoursMultiplyTheirPicture) {
  folder_.Write("t.gltf", SampleGltf());
  const Scene scene = Load("[[model]]\nfile = 't.gltf'\n");
  EXPECT_NEAR(MaterialOf(scene, 0).diffuse.y, 0.25f, 1e-6);
  EXPECT_GE(MaterialOf(scene, 0).texture, 0);
}

TEST_F(SceneTest, ReplacesMaterialsOfModels) {
  const Scene named = Load("[[model]]\nfile = 'sheet.obj'\nmaterials = { paper = 'm' }\n");
  EXPECT_EQ(MaterialOf(named, 0).name, "m");
  const Scene all = Load("[[model]]\nfile = 'sheet.obj'\nmaterials = { '*' = 'm' }\n");
  EXPECT_EQ(MaterialOf(all, 0).name, "m");
  EXPECT_THAT(LoadError("[[model]]\nfile = 'sheet.obj'\nmaterials = { wood = 'm' }\n"),
              HasSubstr("scene.toml:11: the model has no material 'wood'; it has"));
}

TEST_F(SceneTest, MissingPicturesOfModelsAreWarnings) {
  folder_.Write("sheet.mtl", SampleMtl("none.png"));
  const Scene missing = Load("[[model]]\nfile = 'sheet.obj'\n");
  EXPECT_THAT(missing.warnings, Contains(HasSubstr("none.png")));
  EXPECT_EQ(MaterialOf(missing, 0).texture, -1);
  folder_.Write("sheet.mtl", SampleMtl("bad.png"));
  folder_.Write("bad.png", "bad");
  const Scene damaged = Load("[[model]]\nfile = 'sheet.obj'\n");
  EXPECT_THAT(damaged.warnings, Contains(HasSubstr("bad.png: is not an image")));
  EXPECT_EQ(MaterialOf(damaged, 0).texture, -1);
  EXPECT_LT(MaterialOf(damaged, 0).diffuse.y, 0.1f);  // Kd, since there is no picture
}

TEST_F(SceneTest, ErrorsNameTheLineOfTheScene) {
  EXPECT_THAT(LoadError("[[model]]\narchive = 'zip'\nfile = 'd/none.obj'\n"),
              testing::AllOf(HasSubstr("scene.toml:12: "),
                             HasSubstr("sheets.zip(d/none.obj): no such file")));
  folder_.Write("broken.obj", "hello");
  EXPECT_THAT(LoadError("[[box]]\nmaterial = 'm'\nsize = [1, 1, 1]\n"
                        "[[model]]\nfile = 'broken.obj'\n"),
              testing::AllOf(HasSubstr("scene.toml:14: "), HasSubstr("broken.obj: ")));
  folder_.Write("picture.png", "bad");
  EXPECT_THAT(LoadError("[[box]]\nmaterial = 'm'\nsize = [1, 1, 1]\n"),
              testing::AllOf(HasSubstr("scene.toml:9: "), HasSubstr("picture.png: is not")));
  folder_.Write("sheets.zip", "bad");
  EXPECT_THAT(LoadError("[[model]]\narchive = 'zip'\nfile = 'd/sheet.obj'\n"),
              testing::AllOf(HasSubstr("scene.toml:3: "), HasSubstr("is not an archive")));
}

TEST_F(SceneTest, OfSeveralErrorsTheFirstIsReported) {
  std::string models;
  for (int i = 0; i < 20; ++i) {
    folder_.Write(std::to_string(i) + ".obj", "bad");
    models += "[[model]]\nfile = '" + std::to_string(i) + ".obj'\n";
  }
  EXPECT_THAT(LoadError(models), HasSubstr("/0.obj"));
}

TEST_F(SceneTest, DoesNotDependOnTheNumberOfThreads) {
  std::string models;
  for (int i = 0; i < 8; ++i) {
    const std::string name = "copy" + std::to_string(i) + ".obj";
    folder_.Write(name, SampleObj());
    models += "[[model]]\nfile = '" + name + "'\nsize = [1, 1, " + std::to_string(i + 1) + "]\n";
  }
  SetThreadCount(1);
  const Scene one = Load(models);
  SetThreadCount(0);
  const Scene many = Load(models);
  ASSERT_EQ(one.mesh.positions.size(), many.mesh.positions.size());
  for (std::size_t i = 0; i < one.mesh.positions.size(); ++i) {
    EXPECT_EQ(Norm(one.mesh.positions[i] - many.mesh.positions[i]), 0);
  }
  EXPECT_EQ(one.materials.size(), many.materials.size());
  EXPECT_EQ(one.textures.size(), many.textures.size());
}

TEST_F(SceneTest, LoadsFurnitureOfSweetHome3d) {
  const std::filesystem::path library = "/usr/share/sweethome3d/furniture/Scopia.sh3f";
  if (!std::filesystem::exists(library)) GTEST_SKIP() << "sweethome3d-furniture is not installed";
  const Scene scene = Load("[[archive]]\nid = 'scopia'\nfile = '" + library.string() +
                           "'\n[[model]]\narchive = 'scopia'\n"
                           "file = 'scopia/little_lamp1/little_lamp1.obj'\n"
                           "size = [0.3, 0.2, 0.5]\nat = [0, 0, 1]\n");
  float low = 9, high = 0;
  for (const Vec3f& p : scene.mesh.positions) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  EXPECT_NEAR(low, 1, 1e-6);
  EXPECT_NEAR(high, 1.5, 1e-6);
}

TEST_F(SceneTest, RefusesWhatIsTooFarAway) {
  const std::string message = ErrorOf([&] {
    Load("[[box]]\nname = 'moon'\nmaterial = 'm'\nsize = [1, 1, 1]\nat = [3.8e8, 0, 0]\n");
  });
  EXPECT_THAT(message, HasSubstr("'moon' reaches farther than 1000 km"));
}

}  // namespace
}  // namespace silt::sim
