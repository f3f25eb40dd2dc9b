// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/sim/primitives.h"

namespace silt::sim {
namespace {

constexpr double kPi = std::numbers::pi;

struct Bounds {
  Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
};

Bounds BoundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const Vec3f& p : mesh.positions) {
    bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y),
                  std::min(bounds.low.z, p.z)};
    bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y),
                   std::max(bounds.high.z, p.z)};
  }
  return bounds;
}

void ExpectNear(const Vec3f& actual, const Vec3f& expected, float tolerance = 1e-5f) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

// A box of 2 × 4 × 6 in the model's axes, y up; material 0 looks to +z, the front, 1 elsewhere.
Model SampleBox() {
  Model model;
  Box box{{2, 4, 6}, {10, 20, 30}, 0, {}};
  for (Cover& face : box.faces) face.material = 1;
  box.faces[0].material = 0;
  AppendBox(model.mesh, box);
  model.materials.resize(2);
  return model;
}

Mesh Place(const Model& model, const ModelPlacement& placement,
           std::vector<MaterialUse> uses = {{0, false, {}}, {1, false, {}}}) {
  Mesh mesh;
  AppendModel(mesh, model, placement, uses);
  return mesh;
}

double Volume(const Mesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    volume += Dot(mesh.positions[t.vertex[0]],
                  Cross(mesh.positions[t.vertex[1]], mesh.positions[t.vertex[2]])) /
              6.0;
  }
  return volume;
}

Vec3f NormalOfMaterial(const Mesh& mesh, std::uint32_t material) {
  for (const Triangle& t : mesh.triangles) {
    if (t.material == material) return mesh.normals[t.vertex[0]];
  }
  return {};
}

TEST(ModelPlacementTest, TurnsYUpToZUpAndStandsAtItsPlace) {
  ModelPlacement placement;
  placement.at = {1, 2, 3};
  placement.scale = 0.5;
  const Mesh mesh = Place(SampleBox(), placement);
  ExpectNear(BoundsOf(mesh).low, {0.5f, 0.5f, 3});
  ExpectNear(BoundsOf(mesh).high, {1.5f, 3.5f, 5});
  ExpectNear(NormalOfMaterial(mesh, 0), {0, -1, 0});  // the model's +z
  EXPECT_NEAR(Volume(mesh), 48 / 8.0, 1e-4);
}

TEST(ModelPlacementTest, KeepsZUp) {
  ModelPlacement placement;
  placement.z_up = true;
  const Mesh mesh = Place(SampleBox(), placement);
  ExpectNear(BoundsOf(mesh).low, {-1, -2, 0});
  ExpectNear(BoundsOf(mesh).high, {1, 2, 6});
}

TEST(ModelPlacementTest, FitsTheBoundingBoxExactly) {
  Model model;
  AppendSphere(model.mesh, {{5, 6, 7}, 3, 24, {}});
  model.materials.resize(1);
  ModelPlacement placement;
  placement.size = Vec3d{0.5, 1.25, 2};
  placement.at = {1, 1, 1};
  const Mesh mesh = Place(model, placement, {{0, false, {}}});
  ExpectNear(BoundsOf(mesh).low, {0.75f, 0.375f, 1}, 1e-6f);
  ExpectNear(BoundsOf(mesh).high, {1.25f, 1.625f, 3}, 1e-6f);
  // Normals of an ellipsoid: the gradient of (x/a)² + (y/b)² + (z/c)².
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f p = mesh.positions[i] - Vec3f{1, 1, 2};
    const Vec3f gradient{p.x / 0.0625f, p.y / 0.390625f, p.z / 1};
    EXPECT_GT(Dot(mesh.normals[i], Normalized(gradient)), 0.999f);
  }
}

TEST(ModelPlacementTest, FlatModelsStayFlat) {
  Model model;
  AppendQuad(model.mesh, {}, {1, 0, 0}, {0, 1, 0}, {});
  model.materials.resize(1);
  ModelPlacement placement;
  placement.size = Vec3d{2, 0.5, 3};
  const Mesh mesh = Place(model, placement, {{0, false, {}}});
  ExpectNear(BoundsOf(mesh).low, {-1, 0, 0});
  ExpectNear(BoundsOf(mesh).high, {1, 0, 3});
}

TEST(ModelPlacementTest, YawTurnsTheFrontCounterClockwise) {
  ModelPlacement placement;
  placement.yaw_rad = kPi / 2;
  placement.size = Vec3d{1, 2, 3};
  const Mesh mesh = Place(SampleBox(), placement);
  ExpectNear(NormalOfMaterial(mesh, 0), {1, 0, 0});
  ExpectNear(BoundsOf(mesh).high, {1, 0.5f, 3});
}

TEST(ModelPlacementTest, MirrorKeepsSurfacesOutward) {
  Model model = SampleBox();
  AppendBox(model.mesh, {{1, 1, 1}, {11.5, 20, 30}, 0, {}});  // sticks out to +x
  ModelPlacement placement;
  placement.mirror = true;
  const Mesh mesh = Place(model, placement);
  EXPECT_NEAR(Volume(mesh), 49, 1e-3);
  for (const Triangle& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t.vertex[0]];
    const Vec3f front = Cross(mesh.positions[t.vertex[1]] - a, mesh.positions[t.vertex[2]] - a);
    EXPECT_GT(Dot(front, mesh.normals[t.vertex[0]]), 0);
  }
  // The large box, the higher one, lies on the right now.
  float left = 9;
  for (const Vec3f& p : mesh.positions) {
    if (p.z > 3) left = std::min(left, p.x);
  }
  EXPECT_NEAR(left, -0.5f, 1e-5);
  EXPECT_NEAR(BoundsOf(mesh).low.x, -1.5f, 1e-5);
}

TEST(ModelPlacementTest, RotationComesFirst) {
  ModelPlacement placement;
  placement.rotation = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // the model's x becomes its y
  const Mesh mesh = Place(SampleBox(), placement);
  ExpectNear(BoundsOf(mesh).high, {2, 3, 2});
}

TEST(ModelPlacementTest, DroppedMaterialsCountForTheBoundingBox) {
  ModelPlacement placement;
  placement.size = Vec3d{1, 1, 1};
  const Mesh mesh = Place(SampleBox(), placement, {{4, false, {}}, {0, true, {}}});
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[0].material, 4u);
  ExpectNear(BoundsOf(mesh).low, {-0.5f, -0.5f, 0});
  ExpectNear(BoundsOf(mesh).high, {0.5f, -0.5f, 1});
}

TEST(ModelPlacementTest, ProjectsTiledMaterialsAtTrueSize) {
  ModelPlacement placement;
  placement.size = Vec3d{2, 3, 4};
  const MaterialUse tiled{0, false, Vec2f{0.5f, 0.25f}};
  const Mesh mesh = Place(SampleBox(), placement, {tiled, tiled});
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t.vertex[i], b = t.vertex[(i + 1) % 3];
      const Vec3f edge = mesh.positions[b] - mesh.positions[a];
      const float u = (mesh.texcoords[b].x - mesh.texcoords[a].x) * 0.5f;
      const float v = (mesh.texcoords[b].y - mesh.texcoords[a].y) * 0.25f;
      EXPECT_NEAR(std::hypot(u, v), Norm(edge), 1e-5);
      // Upright on the sides.
      if (std::abs(mesh.normals[a].z) < 0.5f) {
        EXPECT_NEAR(v, edge.z, 1e-5);
      }
    }
    // Not mirrored: seen from the front, u × v points to the viewer.
    const Vec2f e1 = mesh.texcoords[t.vertex[1]] - mesh.texcoords[t.vertex[0]];
    const Vec2f e2 = mesh.texcoords[t.vertex[2]] - mesh.texcoords[t.vertex[0]];
    EXPECT_GT(e1.x * e2.y - e1.y * e2.x, 0);
  }
}

TEST(ModelPlacementTest, SharesVerticesOfUntiledMaterials) {
  const Model model = SampleBox();
  EXPECT_EQ(Place(model, {}).positions.size(), model.mesh.positions.size());
}

}  // namespace
}  // namespace silt::sim
