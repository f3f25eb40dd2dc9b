// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_builder.h"

namespace silt::sim {
namespace {

float Linear(const Vec3f& p) { return 1 + 2 * p.x - 3 * p.y + 0.5f * p.z; }

Vec3f PointOn(const Mesh& mesh, std::uint32_t triangle, float u, float v) {
  const std::uint32_t* vertex = mesh.triangles[triangle].vertex;
  return (1 - u - v) * mesh.positions[vertex[0]] + u * mesh.positions[vertex[1]] +
         v * mesh.positions[vertex[2]];
}

float Interpolated(const SurfaceGrid& grid, const SurfaceLookup& at) {
  float sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += at.weight[i] * Linear(grid.samples()[at.sample[i]].position);
  }
  return sum;
}

Mesh Quad(const Vec3f& u, const Vec3f& v) {
  SceneBuilder builder;
  builder.AddQuad({0.1f, 0.2f, 0.3f}, u, v, 0);
  return builder.scene.mesh;
}

// What is linear over the plane is met to the millimetre by which samples on the rim are pulled in.
TEST(SurfaceGrid, LinearFunctionsAreInterpolatedExactly) {
  for (const float spacing : {10.0f, 0.7f, 0.1f, 0.03f}) {
    for (const Mesh& mesh : {Quad({1, 0, 0}, {0, 0.6f, 0.2f}), Quad({0.01f, 0, 0}, {0, 2, 0}),
                             Quad({0, 0.5f, 0}, {0.3f, 0.5f, 0})}) {
      const SurfaceGrid grid(mesh, spacing);
      for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
        for (int i = 0; i <= 300; ++i) {
          const float u = float(i % 20) / 20, v = (1 - u) * float(i / 20) / 15;
          EXPECT_NEAR(Interpolated(grid, grid.Locate(triangle, u, v)),
                      Linear(PointOn(mesh, triangle, u, v)), 5e-3f)
              << spacing << " m, triangle " << triangle << ", " << u << ", " << v;
        }
      }
    }
  }
}

TEST(SurfaceGrid, WeightsAreConvexEverywhere) {
  const SurfaceGrid grid(Quad({1, 0, 0}, {0, 0.6f, 0.2f}), 0.07f);
  for (int i = 0; i < 400; ++i) {
    const float u = float(i % 20) / 19, v = (1 - u) * float(i / 20) / 19;
    const SurfaceLookup at = grid.Locate(std::uint32_t(i % 2), u, v);
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(at.weight[k], -1e-6f);
      EXPECT_LT(at.sample[k], grid.samples().size());
      sum += at.weight[k];
    }
    EXPECT_NEAR(sum, 1, 1e-6f);
  }
}

// The two triangles of a quadrilateral, found at a point of their common edge.
TEST(SurfaceGrid, NeighboursShareTheSamplesOfTheirEdge) {
  const Mesh mesh = Quad({1, 0, 0}, {0, 0.6f, 0});
  const SurfaceGrid grid(mesh, 0.05f);
  for (int i = 0; i <= 40; ++i) {
    const float along = float(i) / 40;  // from vertex 0 to 2; (0 1 2) and (0 2 3)
    const SurfaceLookup a = grid.Locate(0, 0, along), b = grid.Locate(1, along, 0);
    for (std::size_t sample = 0; sample < grid.samples().size(); ++sample) {
      float difference = 0;
      for (int k = 0; k < 4; ++k) {
        if (a.sample[k] == sample) difference += a.weight[k];
        if (b.sample[k] == sample) difference -= b.weight[k];
      }
      EXPECT_NEAR(difference, 0, 1e-5f);
    }
  }
}

// Where a floor meets a wall, its samples lie before the wall and not in it.
TEST(SurfaceGrid, TheRimIsPulledInwardsByAMillimetre) {
  const SurfaceGrid grid(Quad({1, 0, 0}, {0, 0.6f, 0}), 0.1f);
  for (const SurfaceSample& sample : grid.samples()) {
    const float x = sample.position.x - 0.1f, y = sample.position.y - 0.2f;
    const float to_rim = std::min({x, 1 - x, y, 0.6f - y});
    EXPECT_GT(to_rim, 2e-4f);
    EXPECT_TRUE(to_rim < 1.1e-3f || to_rim > 0.02f) << x << ", " << y;
    EXPECT_FLOAT_EQ(sample.position.z, 0.3f);
  }
}

// Shading normals that lean must not pull the rim of a solid inside it.
TEST(SurfaceGrid, TheRimStaysOnTheSurfaceWhateverTheNormals) {
  Mesh mesh = Quad({1, 0, 0}, {0, 0.6f, 0});
  for (Vec3f& normal : mesh.normals) normal = Normalized(Vec3f{0.5f, -0.4f, 1});
  const SurfaceGrid grid(mesh, 0.1f);
  for (const SurfaceSample& sample : grid.samples()) {
    EXPECT_NEAR(sample.position.z, 0.3f, 1e-6f);
  }
}

// On a strip of ten metres as everywhere, a third of what is there if that is less.
TEST(SurfaceGrid, LongRimsArePulledAcross) {
  const SurfaceGrid grid(Quad({10, 0, 0}, {0, 0.06f, 0}), 0.1f);
  for (const SurfaceSample& sample : grid.samples()) {
    const float y = sample.position.y - 0.2f;
    EXPECT_GT(std::min(y, 0.06f - y), 7e-4f);  // half of √2 mm at corners
  }
}

TEST(SurfaceGrid, NoPointIsFartherFromASampleThanTheSpacing) {
  const float spacing = 0.05f;
  const Mesh mesh = Quad({1, 0, 0}, {0.2f, 0.6f, 0.2f});
  const SurfaceGrid grid(mesh, spacing);
  for (int i = 0; i < 900; ++i) {
    const float u = float(i % 30) / 29, v = (1 - u) * float(i / 30) / 29;
    const Vec3f point = PointOn(mesh, std::uint32_t(i % 2), u, v);
    float nearest = 1e9f;
    for (const SurfaceSample& s : grid.samples()) {
      nearest = std::min(nearest, Norm(s.position - point));
    }
    EXPECT_LT(nearest, spacing);
  }
}

// 1/s² samples a square metre: a long, thin part does not pay for its length squared.
TEST(SurfaceGrid, TheNumberOfSamplesFollowsTheArea) {
  EXPECT_NEAR(SurfaceGrid(Quad({1, 0, 0}, {0, 1, 0}), 0.02f).samples().size(), 2500, 700);
  EXPECT_LT(SurfaceGrid(Quad({2, 0, 0}, {0, 0.01f, 0}), 0.02f).samples().size(), 400u);
  EXPECT_LT(SurfaceGrid(Quad({6, 0, 0}, {0, 0.08f, 0}), 0.025f).samples().size(), 2000u);
}

TEST(SurfaceGrid, SmallTrianglesShareTheirCorners) {
  SceneBuilder builder;
  builder.AddSphere({0, 0, 0}, 0.1f, 32, 0);
  // Rings of 32 corners between the poles; the seam's and the poles' copies are one.
  EXPECT_EQ(SurfaceGrid(builder.scene.mesh, 0.05f).samples().size(), 15u * 32 + 2);
}

TEST(SurfaceGrid, HardEdgesKeepTheirSides) {
  SceneBuilder builder;
  builder.AddBox({0, 0, 0}, {0.01f, 0.01f, 0.01f}, 0);
  EXPECT_EQ(SurfaceGrid(builder.scene.mesh, 0.05f).samples().size(), 6u * 4);
}

TEST(SurfaceGrid, NormalsLieOnTheFrontEvenWhereAModelSaysOtherwise) {
  Mesh mesh = Quad({1, 0, 0}, {0, 1, 0});
  for (Vec3f& normal : mesh.normals) normal = {0.1f, 0, -0.995f};
  const SurfaceGrid grid(mesh, 0.3f);
  for (const SurfaceSample& sample : grid.samples()) {
    EXPECT_GT(sample.normal.z, 0.9f);
  }
}

TEST(SurfaceGrid, ATriangleWithoutAreaIsHarmless) {
  Mesh mesh = Quad({1, 0, 0}, {2, 0, 0});
  for (Vec3f& normal : mesh.normals) normal = {};
  const SurfaceGrid grid(mesh, 0.1f);
  for (const SurfaceSample& sample : grid.samples()) {
    EXPECT_TRUE(std::isfinite(sample.position.x));
    EXPECT_NEAR(Norm(sample.normal), 1, 1e-6f);
  }
}

// However thin a strip is, a lookup reads samples that are near it along the strip.
TEST(SurfaceGrid, SliversAreLookedUpNearby) {
  SceneBuilder builder;
  builder.AddQuad({0, 0, 0}, {2, 0, 0}, {0, 0.01f, 0}, builder.AddMaterial(Vec3f{}));
  const SurfaceGrid grid(builder.scene.mesh, 0.025f);
  EXPECT_LT(grid.samples().size(), 300u);
  for (const std::uint32_t triangle : {0u, 1u}) {
    for (const float along : {0.1f, 0.33f, 0.6f, 0.9f}) {
      // (along · (b − a) + ½ of the way across), inside either triangle
      const float u = triangle == 0 ? along * 0.9f : 0.05f,
                  v = triangle == 0 ? 0.05f : along * 0.9f;
      const Triangle& t = builder.scene.mesh.triangles[triangle];
      const std::vector<Vec3f>& p = builder.scene.mesh.positions;
      const Vec3f point = (1 - u - v) * p[t.vertex[0]] + u * p[t.vertex[1]] + v * p[t.vertex[2]];
      const SurfaceLookup at = grid.Locate(triangle, u, v);
      for (int i = 0; i < 4; ++i) {
        if (at.weight[i] == 0) continue;
        EXPECT_LT(Norm(grid.samples()[at.sample[i]].position - point), 0.06f);
      }
    }
  }
}

// A place in a cell and the point of the triangle name each other, and on the cell's corners along
// its lower row a sample lies.
TEST(SurfaceGrid, CellsTileTheTriangle) {
  for (const float spacing : {10.0f, 0.07f}) {
    const Mesh mesh = Quad({1, 0, 0}, {0, 0.6f, 0.2f});
    const SurfaceGrid grid(mesh, spacing);
    for (int i = 0; i < 400; ++i) {
      const float u = float(i % 20) / 20 + 0.01f, v = (1 - u) * (float(i / 20) / 20 + 0.02f);
      const SurfaceGrid::CellPlace place = grid.CellAt(std::uint32_t(i % 2), u, v);
      EXPECT_TRUE(place.along >= 0 && place.along <= 1 && place.up >= 0 && place.up <= 1);
      const Vec2f point = grid.PointOf(place);
      EXPECT_NEAR(point.x, u, 1e-5f) << spacing << " m, " << i;
      EXPECT_NEAR(point.y, v, 1e-5f) << spacing << " m, " << i;
      for (const float along : {0.0f, 1.0f}) {
        const Vec2f corner = grid.PointOf({place.cell, along, 0});
        const SurfaceLookup at = grid.Locate(place.cell.triangle, corner.x, corner.y);
        EXPECT_GT(*std::max_element(at.weight, at.weight + 4), 0.999f);
      }
    }
  }
}

}  // namespace
}  // namespace silt::sim
