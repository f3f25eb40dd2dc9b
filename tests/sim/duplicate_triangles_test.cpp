// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/duplicate_triangles.h"

#include <gtest/gtest.h>

namespace silt::sim {
namespace {

// Vertices 0–2 and 3–5 lie at the same three places, 6 elsewhere.
Mesh SampleMesh(std::vector<Triangle> triangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.0f, 0},
                    {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = std::move(triangles);
  return mesh;
}

bool Always(const Triangle&) { return true; }

TEST(DuplicateTrianglesTest, KeepsTheFirstWhicheverWayTheyFace) {
  Mesh mesh = SampleMesh({{{0, 1, 2}, 0}, {{4, 3, 5}, 1}, {{1, 2, 0}, 2}, {{0, 1, 6}, 3}});
  RemoveDuplicateTriangles(mesh, Always);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[0].material, 0u);
  EXPECT_EQ(mesh.triangles[0].vertex[1], 1u);
  EXPECT_EQ(mesh.triangles[1].material, 3u);
}

TEST(DuplicateTrianglesTest, PrefersWhatIsVisible) {
  Mesh mesh = SampleMesh({{{0, 1, 2}, 0}, {{0, 1, 6}, 0}, {{4, 3, 5}, 1}, {{3, 4, 5}, 2}});
  RemoveDuplicateTriangles(mesh, [](const Triangle& t) { return t.material > 0; });
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[0].material, 1u);
  EXPECT_EQ(mesh.triangles[1].material, 0u);
}

}  // namespace
}  // namespace silt::sim
