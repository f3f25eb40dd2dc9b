// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/face_ties.h"

#include <gtest/gtest.h>

#include "scene_builder.h"

namespace silt::sim {
namespace {

// A room of quads that look inward, 4 × 4 × 3 m, and what each test puts into it. The floor is
// "room" too.
class FaceTies : public testing::Test {
 protected:
  FaceTies() {
    builder_.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
    builder_.AddMaterial(Vec3f{0.2f, 0.2f, 0.2f});
    builder_.AddQuad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0);
    builder_.AddQuad({0, 0, 3}, {0, 4, 0}, {4, 0, 0}, 0);
    builder_.AddQuad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}, 0);
    builder_.AddQuad({4, 4, 0}, {0, -4, 0}, {0, 0, 3}, 0);
    builder_.AddQuad({4, 0, 0}, {-4, 0, 0}, {0, 0, 3}, 0);
    builder_.AddQuad({0, 4, 0}, {4, 0, 0}, {0, 0, 3}, 0);
    EndInstance("room");
  }
  void EndInstance(const std::string& name) {
    auto& instances = builder_.scene.instances;
    const std::uint32_t first =
        instances.empty() ? 0 : instances.back().first_triangle + instances.back().triangle_count;
    instances.push_back({name, first, std::uint32_t(builder_.scene.mesh.triangles.size()) - first});
  }
  std::vector<Tie> Ties() const {
    return FindVisibleTies(builder_.scene, TriangleTree(builder_.scene.mesh));
  }

  SceneBuilder builder_;
};

TEST_F(FaceTies, SolidsThatStandOnEachOtherAreNone) {
  builder_.AddBox({1, 1, 0}, {2, 2, 0.5f}, 1);
  EndInstance("box");
  builder_.AddBox({1.1f, 1.2f, 0.5f}, {2.2f, 1.8f, 0.6f}, 0);
  EndInstance("book");
  builder_.AddBox({0, 1, 1}, {0.1f, 2, 2}, 0);
  EndInstance("shelf at the wall");
  EXPECT_TRUE(Ties().empty());
}

// Rays from within a box must not take what sticks into it for the open.
TEST_F(FaceTies, NorDoThingsThatStickIntoSolidsMakeThemOne) {
  builder_.AddBox({1, 1, 0}, {2, 2, 0.5f}, 1);
  EndInstance("box");
  builder_.AddQuad({0.5f, 0.5f, 0.01f}, {2, 0, 0}, {0, 2, 0}, 0);
  EndInstance("sheet");
  EXPECT_TRUE(Ties().empty());
}

TEST_F(FaceTies, ARugInTheFloorIsOne) {
  builder_.AddQuad({1, 1, 0}, {1, 0, 0}, {0, 2, 0}, 1);
  EndInstance("rug");
  const auto ties = Ties();
  ASSERT_EQ(ties.size(), 1u);
  EXPECT_EQ(ties[0].first_instance, 0);
  EXPECT_EQ(ties[0].second_instance, 1);
  EXPECT_NEAR(ties[0].area_m2, 2, 1e-4);
  EXPECT_TRUE(ties[0].materials_differ);
  EXPECT_NEAR(ties[0].middle.z, 0, 1e-6);
}

TEST_F(FaceTies, TwoSheetsBackToBackAreOne) {
  builder_.AddQuad({1, 1, 1}, {1, 0, 0}, {0, 0, 1}, 1);
  builder_.AddQuad({1, 1, 1}, {0, 0, 1}, {1, 0, 0}, 1);
  EndInstance("paper");
  const auto ties = Ties();
  ASSERT_EQ(ties.size(), 1u);
  EXPECT_EQ(ties[0].first_instance, 1);
  EXPECT_EQ(ties[0].second_instance, 1);
  EXPECT_FALSE(ties[0].materials_differ);
}

TEST_F(FaceTies, BoxesThatInterpenetrateWithFlushFacesAreOne) {
  builder_.AddBox({1, 1, 1}, {2, 1.1f, 1.1f}, 1);
  EndInstance("rail");
  builder_.AddBox({1, 1, 1}, {1.1f, 2, 1.1f}, 1);
  EndInstance("other rail");
  const auto ties = Ties();
  ASSERT_EQ(ties.size(), 1u);
  // The outer corner: two faces on top and below, and one each at the two sides.
  EXPECT_NEAR(ties[0].area_m2, 0.04, 1e-4);
}

TEST_F(FaceTies, WhatOnlyRaysFromOutsideMeetIsNone) {
  builder_.AddQuad({1, 1, 3}, {1, 0, 0}, {0, 1, 0}, 1);  // on the ceiling, seen from above
  builder_.AddQuad({1, 1, 0}, {0, 1, 0}, {1, 0, 0}, 1);  // below the floor
  EndInstance("insulation");
  // They are sheets, so that their backs are seen from within as well.
  EXPECT_EQ(Ties().size(), 1u);
  builder_.AddBox({0.5f, 0.5f, 2.9f}, {2.5f, 2.5f, 3.1f}, 0);
  EndInstance("beam");
  builder_.AddBox({0.5f, 0.5f, -0.1f}, {2.5f, 2.5f, 0.1f}, 0);
  EndInstance("plinth");
  EXPECT_TRUE(Ties().empty());
}

TEST(FaceTiesOutdoors, ARugUnderTheSkyIsOne) {
  SceneBuilder builder;
  builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
  builder.AddQuad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0);
  builder.AddQuad({1, 1, 0}, {1, 0, 0}, {0, 1, 0}, 0);
  builder.scene.instances = {{"ground", 0, 2}, {"rug", 2, 2}};
  EXPECT_EQ(FindVisibleTies(builder.scene, TriangleTree(builder.scene.mesh)).size(), 1u);
}

}  // namespace
}  // namespace silt::sim
