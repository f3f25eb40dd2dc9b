// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_transfer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/random.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

Model SampleOfEverything() {
  Model model;
  model.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
  model.mesh.texcoords = {{0, 0}, {1, 0}, {0.25f, 1}};
  model.mesh.triangles = {{{0, 1, 2}, 1}};
  ModelMaterial paint;
  paint.surface.name = "paint";
  paint.surface.diffuse = {0.1f, 0.2f, 0.3f};
  paint.surface.texture = 1;
  paint.surface.emission = {1, 2, 3};
  paint.surface.cutout = true;
  paint.surface.two_sided = false;
  paint.surface.specular = 0.04f;
  paint.surface.metallic = 0.5f;
  paint.surface.roughness = 0.7f;
  paint.surface.mirror = true;
  paint.invisible = true;
  model.materials = {{}, paint};
  EncodedPicture file;
  file.place = "a.zip(b.png)";
  file.colour = std::make_shared<const std::string>(std::string("\0\1png", 5));
  file.opacity_place = "c.png";
  file.opacity = std::make_shared<const std::string>("mask");
  EncodedPicture texels;
  texels.place = "d";
  texels.texels = Image<Rgba8>(2, 1);
  texels.texels(1, 0) = {1, 2, 3, 4};
  model.pictures = {file, texels};
  model.picture_replaces_diffuse = false;
  model.warnings = {"one", ""};
  return model;
}

TEST(ModelTransfer, ReturnsTheSameModel) {
  const std::string bytes = ModelToBytes(SampleOfEverything());
  const Model model = ModelFromBytes(bytes);
  EXPECT_EQ(ModelToBytes(model), bytes);
  EXPECT_EQ(model.mesh.texcoords[2].x, 0.25f);
  EXPECT_EQ(model.mesh.triangles[0].material, 1u);
  const ModelMaterial& paint = model.materials.at(1);
  EXPECT_EQ(paint.surface.name, "paint");
  EXPECT_EQ(paint.surface.emission.z, 3);
  EXPECT_EQ(paint.surface.roughness, 0.7f);
  EXPECT_TRUE(paint.surface.mirror);
  EXPECT_TRUE(paint.invisible);
  EXPECT_FALSE(paint.surface.two_sided);
  EXPECT_EQ(*model.pictures.at(0).colour, std::string("\0\1png", 5));
  EXPECT_EQ(*model.pictures.at(0).opacity, "mask");
  EXPECT_EQ(model.pictures.at(1).colour, nullptr);
  EXPECT_EQ(model.pictures.at(1).texels(1, 0), (Rgba8{1, 2, 3, 4}));
  EXPECT_FALSE(model.picture_replaces_diffuse);
  EXPECT_EQ(model.warnings, (std::vector<std::string>{"one", ""}));
}

TEST(ModelTransfer, RefusesWhatIsNotWhole) {
  const std::string bytes = ModelToBytes(SampleOfEverything());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(ModelFromBytes(std::string_view(bytes).substr(0, size)), Error) << size;
  }
  EXPECT_THAT(ErrorOf([&] { ModelFromBytes(bytes + "x"); }), HasSubstr("follows"));
}

TEST(ModelTransfer, RefusesWhatLeadsNowhere) {
  const auto refused = [](const auto& change) {
    Model model = SampleOfEverything();
    change(model);
    return ErrorOf([&] { ModelFromBytes(ModelToBytes(model)); });
  };
  EXPECT_THAT(refused([](Model& m) { m.mesh.triangles[0].vertex[2] = 3; }), HasSubstr("vertex"));
  EXPECT_THAT(refused([](Model& m) { m.mesh.triangles[0].material = 2; }), HasSubstr("material"));
  EXPECT_THAT(refused([](Model& m) { m.mesh.normals.pop_back(); }), HasSubstr("normals"));
  EXPECT_THAT(refused([](Model& m) { m.mesh.positions[1].y = NAN; }), HasSubstr("finite"));
  EXPECT_THAT(refused([](Model& m) { m.mesh.texcoords[1].y = INFINITY; }), HasSubstr("finite"));
  EXPECT_THAT(refused([](Model& m) { m.materials[1].surface.texture = 2; }), HasSubstr("picture"));
  EXPECT_THAT(refused([](Model& m) { m.materials[1].surface.texture = -2; }), HasSubstr("picture"));
  EXPECT_THAT(refused([](Model& m) { m.materials[1].surface.diffuse.x = NAN; }),
              HasSubstr("colour"));
}

// Whatever the bytes, the answer is a model or an error.
TEST(ModelTransfer, SurvivesAnyBytes) {
  const std::string bytes = ModelToBytes(SampleOfEverything());
  const CounterRandom random(1);
  int refused = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    std::string broken = bytes;
    for (std::uint64_t k = 0; k < 1 + i % 3; ++k) {
      const std::uint64_t bits = random.Bits(4 * i + k);
      broken[std::size_t(bits >> 16) % broken.size()] = char(bits & 0xff);
    }
    try {
      ModelFromBytes(broken);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace silt::sim
