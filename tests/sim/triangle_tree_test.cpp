// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "silt/core/random.h"

namespace silt::sim {
namespace {

// Triangles of very different sizes, strewn over a few metres.
Mesh RandomMesh(int count) {
  const CounterRandom random(2);
  std::uint64_t draw = 0;
  const auto vector = [&](double size) {
    const double x = random.Normal(draw++), y = random.Normal(draw++), z = random.Normal(draw++);
    return Vec3f{float(size * x), float(size * y), float(size * z)};
  };
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3f at = vector(2);
    const double size = std::pow(10, -2 + 2.5 * random.Uniform(draw++));
    const auto first = std::uint32_t(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(at + vector(size));
    mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
  }
  return mesh;
}

TEST(TriangleTree, FindsAllBoxesThatTouch) {
  const Mesh mesh = RandomMesh(500);
  const TriangleTree tree(mesh);
  for (std::uint32_t probe = 0; probe < 500; probe += 7) {
    const Bounds box = BoundsOf(mesh, probe).Grown(0.01f);
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t t = 0; t < 500; ++t) {
      if (BoundsOf(mesh, t).Overlaps(box)) expected.insert(t);
    }
    tree.Visit(box, [&](std::uint32_t t) { return found.insert(t).second; });
    EXPECT_EQ(found, expected);
  }
}

TEST(TriangleTree, FindsAllTrianglesThatASegmentPierces) {
  const Mesh mesh = RandomMesh(500);
  const TriangleTree tree(mesh);
  std::size_t total = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3d p{-5, 0.2 * i - 4, 0.1 * i - 2}, q{5, 0.3, i % 3 == 0 ? p.z : 1 - 0.05 * i};
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t t = 0; t < 500; ++t) {
      if (Pierces(p, q, CornersOf(mesh, t))) expected.insert(t);
    }
    tree.VisitPierced(p, q, [&](std::uint32_t t) { return found.insert(t).second; });
    EXPECT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, 100u);
}

TEST(TriangleTree, FindsAWallThatALineAlongAnAxisMeets) {
  Mesh mesh;
  mesh.positions = {{0, -1, -1}, {0, 2, -1}, {0, -1, 2}};
  mesh.triangles = {{{0, 1, 2}, 0}};
  int found = 0;
  TriangleTree(mesh).VisitPierced({-1, 0, 0}, {1, 0, 0}, [&](std::uint32_t) { return ++found; });
  EXPECT_EQ(found, 1);
}

TEST(TriangleTree, StopsWhenTold) {
  const Mesh mesh = RandomMesh(100);
  int visited = 0;
  TriangleTree(mesh).Visit(Bounds{{-99, -99, -99}, {99, 99, 99}},
                           [&](std::uint32_t) { return ++visited < 5; });
  EXPECT_EQ(visited, 5);
}

TEST(TriangleTree, LeavesOutWhatIsNotFiniteAndMayBeEmpty) {
  Mesh mesh = RandomMesh(3);
  mesh.positions[4].y = NAN;
  mesh.positions[7].z = INFINITY;
  int visited = 0;
  const Bounds all{{-99, -99, -99}, {99, 99, 99}};
  TriangleTree(mesh).Visit(all, [&](std::uint32_t t) { return (visited += t == 0 ? 1 : 99) > 0; });
  EXPECT_EQ(visited, 1);
  TriangleTree(mesh, {}).Visit(all, [&](std::uint32_t) { return ++visited > 0; });
  EXPECT_EQ(visited, 1);
}

// The nearest of a dense set of points of the triangle.
double SampledDistance(const Corners& c, const Vec3d& p) {
  double least = 1e9;
  for (int i = 0; i <= 200; ++i) {
    for (int j = 0; j <= 200 - i; ++j) {
      const Vec3d q = c[0] + (i / 200.0) * (c[1] - c[0]) + (j / 200.0) * (c[2] - c[0]);
      least = std::min(least, Norm(q - p));
    }
  }
  return least;
}

TEST(Triangle, NearestPointIsTheNearestOfAll) {
  const Corners corners{Vec3d{0, 0, 0}, Vec3d{2, 0.3, 0}, Vec3d{0.4, 1, 0.5}};
  const CounterRandom random(6);
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Vec3d p{3 * random.Normal(3 * i), 2 * random.Normal(3 * i + 1), random.Normal(3 * i + 2)};
    const double distance = Norm(NearestPoint(corners, p) - p);
    const double sampled = SampledDistance(corners, p);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GT(distance, sampled - 0.01);
  }
}

TEST(Triangle, IsPiercedBetweenTheEndsOnly) {
  const Corners corners{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}};
  EXPECT_TRUE(Pierces({0.2, 0.2, 1}, {0.3, 0.3, -1}, corners));
  EXPECT_TRUE(Pierces({0.2, 0.2, -1}, {0.3, 0.3, 1}, corners));
  EXPECT_FALSE(Pierces({0.2, 0.2, 1}, {0.3, 0.3, 0.1}, corners));
  EXPECT_FALSE(Pierces({0.7, 0.7, 1}, {0.7, 0.7, -1}, corners));
  EXPECT_FALSE(Pierces({0.2, 0.2, 0}, {0.3, 0.3, 0}, corners));
}

}  // namespace
}  // namespace silt::sim
