// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace silt::sim {
namespace {

constexpr double kPi = std::numbers::pi;

// Twice the area, pointing to the front.
Vec3d AreaNormal(const Mesh& mesh, const Triangle& t) {
  const Vec3d a = mesh.positions[t.vertex[0]].Cast<double>();
  const Vec3d b = mesh.positions[t.vertex[1]].Cast<double>();
  const Vec3d c = mesh.positions[t.vertex[2]].Cast<double>();
  return Cross(b - a, c - a);
}

double Area(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += 0.5 * Norm(AreaNormal(mesh, t));
  return area;
}

// By the divergence theorem: positive for a closed surface that is seen from outside.
double Volume(const Mesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    volume += Dot(mesh.positions[t.vertex[0]].Cast<double>(), AreaNormal(mesh, t)) / 6;
  }
  return volume;
}

void ExpectUnitNormalsInFront(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.texcoords.size(), mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3d front = AreaNormal(mesh, t);
    ASSERT_GT(Norm(front), 0);
    for (const std::uint32_t v : t.vertex) {
      EXPECT_NEAR(Norm(mesh.normals[v]), 1, 1e-6);
      EXPECT_GT(Dot(mesh.normals[v].Cast<double>(), front), 0);
    }
  }
}

Vec2f LargestTexcoord(const Mesh& mesh) {
  Vec2f largest;
  for (const Vec2f& at : mesh.texcoords) {
    largest = {std::max(largest.x, at.x), std::max(largest.y, at.y)};
  }
  return largest;
}

TEST(PrimitivesTest, QuadLooksAlongUCrossV) {
  Mesh mesh;
  AppendQuad(mesh, {1, 2, 3}, {2, 0, 0}, {0, 0, 3}, {7, {}});
  ExpectUnitNormalsInFront(mesh);
  EXPECT_NEAR(Area(mesh), 6, 1e-6);
  EXPECT_EQ(mesh.normals[0].y, -1);
  EXPECT_EQ(mesh.triangles[1].material, 7u);
  // The picture's upper right corner.
  EXPECT_EQ(mesh.positions[2].x, 3);
  EXPECT_EQ(mesh.positions[2].z, 6);
  EXPECT_EQ(mesh.texcoords[2].x, 1);
  EXPECT_EQ(mesh.texcoords[2].y, 1);
  EXPECT_EQ(mesh.texcoords[1].y, 0);
}

TEST(PrimitivesTest, QuadRepeatsItsPicture) {
  Mesh mesh;
  AppendQuad(mesh, {}, {2, 0, 0}, {0, 0, 3}, {0, Vec2f{0.5f, 2}});
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).x, 4);
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).y, 1.5f);
}

TEST(PrimitivesTest, BoxIsClosedAndSeenFromOutside) {
  Mesh mesh;
  AppendBox(mesh, {{2, 3, 4}, {10, 20, 30}, 0.7, {}});
  ExpectUnitNormalsInFront(mesh);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(Area(mesh), 2 * (6 + 8 + 12), 1e-4);
  EXPECT_NEAR(Volume(mesh), 24, 1e-3);
}

TEST(PrimitivesTest, BoxStandsOnItsPlaceWithItsFacesInOrder) {
  Mesh mesh;
  Box box{{2, 4, 6}, {1, 1, 1}, 0, {}};
  for (std::uint32_t i = 0; i < 6; ++i) box.faces[i].material = i;
  AppendBox(mesh, box);
  const Vec3f outward[6] = {{0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  for (const Triangle& t : mesh.triangles) {
    const Vec3f& n = mesh.normals[t.vertex[0]];
    EXPECT_NEAR(Dot(n, outward[t.material]), 1, 1e-6) << t.material;
    for (const std::uint32_t v : t.vertex) {
      const Vec3f from_middle = mesh.positions[v] - Vec3f{1, 1, 4};
      EXPECT_NEAR(std::abs(from_middle.x), 1, 1e-6);
      EXPECT_NEAR(std::abs(from_middle.y), 2, 1e-6);
      EXPECT_NEAR(std::abs(from_middle.z), 3, 1e-6);
      EXPECT_GT(Dot(from_middle, n), 0);
      // Pictures on the sides stand upright.
      if (t.material >= 2) {
        EXPECT_EQ(mesh.texcoords[v].y, from_middle.z > 0 ? 1 : 0);
      }
    }
  }
}

TEST(PrimitivesTest, BoxTurnsCounterClockwise) {
  Mesh mesh;
  AppendBox(mesh, {{2, 0.2, 1}, {}, kPi / 2, {}});
  float largest_y = 0;
  for (const Vec3f& p : mesh.positions) largest_y = std::max(largest_y, p.y);
  EXPECT_NEAR(largest_y, 1, 1e-6);
  // The front, −y before, looks to +x now.
  EXPECT_NEAR(mesh.normals[8].x, 1, 1e-6);
}

TEST(PrimitivesTest, SphereApproachesItsAreaAndVolume) {
  Mesh mesh;
  AppendSphere(mesh, {{1, 2, 3}, 2, 96, {5, {}}});
  ExpectUnitNormalsInFront(mesh);
  EXPECT_NEAR(Area(mesh), 16 * kPi, 0.003 * 16 * kPi);
  EXPECT_NEAR(Volume(mesh), 32 * kPi / 3, 0.003 * 32 * kPi / 3);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f from_center = mesh.positions[i] - Vec3f{1, 2, 3};
    EXPECT_NEAR(Norm(from_center), 2, 1e-5);
    EXPECT_NEAR(Norm(from_center - 2.0f * mesh.normals[i]), 0, 1e-5);
  }
  EXPECT_EQ(mesh.triangles.front().material, 5u);
}

TEST(PrimitivesTest, SphereClosesItsPicture) {
  Mesh mesh;
  AppendSphere(mesh, {{}, 1, 16, {0, Vec2f{1, 1}}});
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).x, 6);  // 2π, rounded
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).y, float(kPi));
}

TEST(PrimitivesTest, CylinderApproachesItsAreaAndVolume) {
  Mesh mesh;
  AppendCylinder(mesh, {{1, 2, 3}, 0.5, 2, 128, {}});
  ExpectUnitNormalsInFront(mesh);
  EXPECT_NEAR(Area(mesh), 2.5 * kPi, 0.001 * 2.5 * kPi);
  EXPECT_NEAR(Volume(mesh), 0.5 * kPi, 0.001 * 0.5 * kPi);
  for (const Vec3f& p : mesh.positions) EXPECT_TRUE(p.z == 3 || p.z == 5);
}

TEST(PrimitivesTest, CylinderRepeatsItsPicture) {
  Mesh mesh;
  AppendCylinder(mesh, {{}, 0.5, 3, 16, {0, Vec2f{1, 1.5f}}});
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).x, 3);  // π, rounded
  EXPECT_FLOAT_EQ(LargestTexcoord(mesh).y, 2);
}

TEST(PrimitivesTest, AppendsToWhatIsThere) {
  Mesh mesh;
  AppendSphere(mesh, {{}, 1, 8, {0, {}}});
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  AppendBox(mesh, {{1, 1, 1}, {}, 0, {}});
  for (std::size_t i = triangles; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i].vertex) EXPECT_GE(v, vertices);
  }
}

}  // namespace
}  // namespace silt::sim
