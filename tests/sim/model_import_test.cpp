// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_model.h"
#include "silt/core/color.h"
#include "silt/sim/archive_io.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Model Import(const std::filesystem::path& file) {
  return ImportModel(FolderSource(), file.string());
}

Vec3f FrontOf(const Mesh& mesh, const Triangle& t) {
  const Vec3f a = mesh.positions[t.vertex[0]];
  return Normalized(Cross(mesh.positions[t.vertex[1]] - a, mesh.positions[t.vertex[2]] - a));
}

const Material& MaterialOf(const Model& model, std::size_t triangle) {
  return model.materials.at(model.mesh.triangles.at(triangle).material).surface;
}

void ExpectSampleSheet(const Model& model) {
  EXPECT_THAT(model.warnings, IsEmpty());
  ASSERT_EQ(model.mesh.triangles.size(), 2u);
  for (const Triangle& t : model.mesh.triangles) {
    EXPECT_NEAR(FrontOf(model.mesh, t).z, 1, 1e-6);
    for (const std::uint32_t v : t.vertex) {
      const Vec3f& p = model.mesh.positions[v];
      EXPECT_NEAR(model.mesh.normals[v].z, 1, 1e-6);
      EXPECT_NEAR(model.mesh.texcoords[v].x, p.x / 2, 1e-6);
      EXPECT_NEAR(model.mesh.texcoords[v].y, p.y, 1e-6);
    }
  }
  const Material& paper = MaterialOf(model, 0);
  EXPECT_EQ(paper.name, "paper");
  EXPECT_NEAR(paper.diffuse.y, LinearFromSrgb(0.25f), 1e-6);
  EXPECT_TRUE(model.picture_replaces_diffuse);
  ASSERT_EQ(paper.texture, 0);
  EXPECT_EQ(DecodePicture(model.pictures.at(0))(0, 0), (Rgba8{255, 0, 0, 255}));
}

TEST(ModelImportTest, ReadsObjWithItsMaterialAndPicture) {
  const TempFolder folder;
  folder.Write("sheet.mtl", SampleMtl());
  folder.Write("picture.png", SamplePng());
  ExpectSampleSheet(Import(folder.Write("sheet.obj", SampleObj())));
}

TEST(ModelImportTest, ReadsTheSameFromAnArchive) {
  const TempFolder folder;
  const Archive archive(folder.Write("a.zip", ZipOf({{"things/sheet/sheet.obj", SampleObj()},
                                                     {"things/sheet/sheet.mtl", SampleMtl()},
                                                     {"things/sheet/picture.png", SamplePng()}})));
  ExpectSampleSheet(ImportModel(archive, "things/sheet/sheet.obj"));
}

TEST(ModelImportTest, ResolvesPathsAsArtistsWriteThem) {
  for (const char* const path : {"..\\Shared\\PICTURE.png", "../shared/./picture.PNG \t",
                                 "C:/Documents and Settings/me/picture.png"}) {
    const TempFolder folder;
    const bool beside = path[0] == 'C';
    const Archive archive(folder.Write(
        "a.zip", ZipOf({{"sheet/sheet.obj", SampleObj()},
                        {"sheet/Sheet.MTL", SampleMtl(path)},
                        {beside ? "sheet/picture.png" : "shared/picture.png", SamplePng()}})));
    ExpectSampleSheet(ImportModel(archive, "sheet/sheet.obj"));
  }
}

TEST(ModelImportTest, MissingPartsAreWarnings) {
  const TempFolder folder;
  const auto obj = folder.Write("sheet.obj", SampleObj());
  const Model without_material = Import(obj);
  EXPECT_THAT(without_material.warnings, Contains(HasSubstr("sheet.mtl: no such file")));
  EXPECT_EQ(without_material.mesh.triangles.size(), 2u);

  folder.Write("sheet.mtl", SampleMtl());
  const Model without_picture = Import(obj);
  EXPECT_THAT(without_picture.warnings,
              Contains(HasSubstr("material 'paper' lacks its picture 'picture.png'")));
  EXPECT_EQ(MaterialOf(without_picture, 0).texture, -1);
  EXPECT_NEAR(MaterialOf(without_picture, 0).diffuse.x, LinearFromSrgb(0.5f), 1e-6);
}

TEST(ModelImportTest, KnowsEmissionAndTransparency) {
  const TempFolder folder;
  folder.Write("m.mtl",
               "newmtl lamp\nKd 1 1 1\nKe 0.5 0 1\nnewmtl glass\nKd 1 1 1\nd 0.2\n"
               "newmtl leaf\nmap_Kd leaf.png\nmap_d mask.png\n");
  folder.Write("leaf.png", SamplePng());
  folder.Write("mask.png", SamplePng(true));
  const Model model = Import(folder.Write("m.obj",
                                          "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                          "usemtl lamp\nf 1 2 3\nusemtl glass\nf 1 2 3\n"
                                          "usemtl leaf\nf 1 2 3\n"));
  const auto find = [&](const std::string& name) {
    return *std::find_if(model.materials.begin(), model.materials.end(),
                         [&](const ModelMaterial& m) { return m.surface.name == name; });
  };
  EXPECT_NEAR(find("lamp").surface.emission.x, LinearFromSrgb(0.5f), 1e-6);
  EXPECT_EQ(find("lamp").surface.emission.z, 1);
  EXPECT_FALSE(find("lamp").invisible);
  EXPECT_TRUE(find("glass").invisible);
  EXPECT_TRUE(find("leaf").surface.cutout);
  const auto picture = std::size_t(find("leaf").surface.texture);
  EXPECT_EQ(DecodePicture(model.pictures.at(picture))(1, 1).a, 0);
}

TEST(ModelImportTest, KnowsReflection) {
  const TempFolder folder;
  folder.Write("m.mtl",
               "newmtl varnish\nKd 1 1 1\nKs 0.735 0.735 0.735\nNs 30\nillum 2\n"
               "newmtl chalk\nKd 1 1 1\nKs 1 1 1\nNs 30\nillum 1\n"
               "newmtl dull\nKd 1 1 1\nKs 0 0 0\nNs 30\nillum 2\n");
  const Model model = Import(folder.Write("m.obj",
                                          "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                          "usemtl varnish\nf 1 2 3\nv 0 0 1\nusemtl chalk\n"
                                          "f 1 2 4\nusemtl dull\nf 2 3 4\n"));
  const auto find = [&](const std::string& name) {
    return std::find_if(model.materials.begin(), model.materials.end(),
                        [&](const ModelMaterial& m) { return m.surface.name == name; })
        ->surface;
  };
  EXPECT_NEAR(find("varnish").specular, 0.08f * LinearFromSrgb(0.735f), 1e-5);
  EXPECT_NEAR(find("varnish").roughness, 0.5f, 1e-5);
  EXPECT_FALSE(find("chalk").reflects());
  EXPECT_FALSE(find("dull").reflects());
}

TEST(ModelImportTest, MaterialFilesMayBeBroken) {
  for (const char* const mtl :
       {"", "\n", "Kd 1 0 0\nd 0.5\n", "onewmtl paper\nKd 1 0 0\n", "newmtl", "Kd"}) {
    const TempFolder folder;
    folder.Write("sheet.mtl", mtl);
    EXPECT_EQ(Import(folder.Write("sheet.obj", SampleObj())).mesh.triangles.size(), 2u) << mtl;
  }
  const TempFolder folder;
  folder.Write("sheet.mtl", "newmtl a\nKd");
  const auto obj = folder.Write("sheet.obj", SampleObj());
  EXPECT_THAT(ErrorOf([&] { Import(obj); }), HasSubstr("sheet.obj: assimp cannot read it"));
  folder.Write("sheet.mtl", "Kd 1 0 0\n\t newmtl paper\nKd 0 1 0\n");
  const Model model = Import(obj);
  EXPECT_EQ(MaterialOf(model, 0).name, "paper");
  EXPECT_EQ(MaterialOf(model, 0).diffuse.y, 1);
}

TEST(ModelImportTest, AModelOfGlassAloneIsOpaque) {
  const TempFolder folder;
  folder.Write("m.mtl", "newmtl glass\nd 0.1\n");
  const Model model = Import(
      folder.Write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\n"));
  EXPECT_FALSE(model.materials.at(model.mesh.triangles.at(0).material).invisible);
  EXPECT_THAT(model.warnings, Contains(HasSubstr("transparent")));
}

TEST(ModelImportTest, ReadsGltfWithAnEmbeddedPicture) {
  const TempFolder folder;
  const Model model = Import(folder.Write("t.gltf", SampleGltf()));
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  const Material& paper = MaterialOf(model, 0);
  EXPECT_NEAR(paper.diffuse.x, 0.5f, 1e-6);  // linear, and multiplied with the picture
  EXPECT_NEAR(paper.diffuse.y, 0.25f, 1e-6);
  EXPECT_FALSE(model.picture_replaces_diffuse);
  EXPECT_FALSE(paper.cutout);  // alphaMode is OPAQUE
  ASSERT_GE(paper.texture, 0);
  const Image<Rgba8> picture = DecodePicture(model.pictures.at(std::size_t(paper.texture)));
  EXPECT_EQ(picture(0, 1), (Rgba8{0, 0, 255, 255}));
  // glTF's texture coordinate (0, 0) is the upper left corner.
  for (const std::uint32_t v : model.mesh.triangles[0].vertex) {
    EXPECT_NEAR(model.mesh.texcoords[v].y, 1 - model.mesh.positions[v].y, 1e-6);
  }
}

TEST(ModelImportTest, MirroredNodesKeepTheirFront) {
  const TempFolder folder;
  const Model plain = Import(folder.Write("a.gltf", SampleGltf()));
  const Model mirrored = Import(folder.Write("b.gltf", SampleGltf("\"scale\":[-2,1,1],")));
  EXPECT_NEAR(FrontOf(plain.mesh, plain.mesh.triangles.at(0)).z, 1, 1e-6);
  EXPECT_NEAR(FrontOf(mirrored.mesh, mirrored.mesh.triangles.at(0)).z, 1, 1e-6);
  float smallest_x = 0;
  for (const Vec3f& p : mirrored.mesh.positions) smallest_x = std::min(smallest_x, p.x);
  EXPECT_EQ(smallest_x, -2);
}

TEST(ModelImportTest, NodesAreFlattened) {
  const TempFolder folder;
  const Model model =
      Import(folder.Write("a.gltf", SampleGltf("\"translation\":[1,2,3],\"scale\":[2,2,2],")));
  Vec3f largest{-9, -9, -9};
  for (const Vec3f& p : model.mesh.positions) {
    largest = {std::max(largest.x, p.x), std::max(largest.y, p.y), std::max(largest.z, p.z)};
  }
  EXPECT_EQ(largest.x, 3);
  EXPECT_EQ(largest.y, 4);
  EXPECT_EQ(largest.z, 3);
}

TEST(ModelImportTest, NormalsFollowShearedNodes) {
  const TempFolder folder;
  const Model model = Import(
      folder.Write("a.gltf", SampleGltf("\"matrix\":[1,0,1,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],")));
  const Triangle& t = model.mesh.triangles.at(0);
  const Vec3f front = FrontOf(model.mesh, t);
  EXPECT_NEAR(front.x, -std::sqrt(0.5f), 1e-6);
  for (const std::uint32_t v : t.vertex) EXPECT_NEAR(Dot(model.mesh.normals[v], front), 1, 1e-6);
}

TEST(ModelImportTest, LeavesOutBrokenTriangles) {
  const TempFolder folder;
  const Model model =
      Import(folder.Write("m.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 2 0 0\nv inf 0 1\n"
                          "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\nf 1 3 6\n"));
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  for (const std::uint32_t v : model.mesh.triangles[0].vertex) {
    EXPECT_NEAR(Norm(model.mesh.normals[v]), 1, 1e-6);
  }
}

TEST(ModelImportTest, BadNormalsBecomeTheTrianglesOwn) {
  const TempFolder folder;
  const Model model = Import(folder.Write(
      "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 1\nvn 0 0 2\nf 1//1 2//2 3//3\n"));
  for (const std::uint32_t v : model.mesh.triangles.at(0).vertex) {
    EXPECT_NEAR(model.mesh.normals[v].z, 1, 1e-6);
  }
}

TEST(ModelImportTest, NormalsDecideWhatIsInFront) {
  const TempFolder folder;
  const Model model =
      Import(folder.Write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n"));
  EXPECT_NEAR(FrontOf(model.mesh, model.mesh.triangles.at(0)).z, -1, 1e-6);
}

TEST(ModelImportTest, MissingNormalsAreSmoothOnlyOverBluntEdges) {
  const TempFolder folder;
  // Two faces that meet at 90° and two that meet at 11°.
  const Model sharp =
      Import(folder.Write("sharp.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n"));
  const Model blunt = Import(
      folder.Write("blunt.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0.2\nf 1 3 2\nf 1 2 4\n"));
  const auto is_face_normal = [](const Model& model) {
    bool all = true;
    for (const Triangle& t : model.mesh.triangles) {
      for (const std::uint32_t v : t.vertex) {
        all = all && Dot(model.mesh.normals[v], FrontOf(model.mesh, t)) > 0.9999f;
      }
    }
    return all;
  };
  EXPECT_TRUE(is_face_normal(sharp));
  EXPECT_FALSE(is_face_normal(blunt));
}

TEST(ModelImportTest, RefusesWhatIsNoModel) {
  const TempFolder folder;
  EXPECT_THAT(ErrorOf([&] { Import(folder.path() / "none.obj"); }),
              HasSubstr("none.obj: no such file"));
  const Archive archive(folder.Write("a.zip", ZipOf({{"a.txt", "x"}})));
  EXPECT_THAT(ErrorOf([&] { ImportModel(archive, "d/none.obj"); }),
              HasSubstr("a.zip(d/none.obj): no such file"));
  for (const char* const name : {"a.obj", "a.gltf", "a.glb", "a.fbx", "a.ply", "a.stl", "a.xyz"}) {
    for (const char* const contents : {"", "hello\nworld\n", "\x01\x02\x03"}) {
      const auto file = folder.Write(name, contents);
      const std::string message = ErrorOf([&] { Import(file); });
      EXPECT_THAT(message, HasSubstr(name));
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST(ModelImportTest, RefusesAModelWithoutSurface) {
  const TempFolder folder;
  EXPECT_THAT(
      ErrorOf([&] { Import(folder.Write("m.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")); }),
      HasSubstr("m.obj"));
}

}  // namespace
}  // namespace silt::sim
