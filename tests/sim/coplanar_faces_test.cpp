// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/coplanar_faces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/parallel.h"
#include "silt/core/se3.h"

namespace silt::sim {
namespace {

// Adds the triangle `corners`, turned by `turn` and moved by `at`.
struct Placed {
  Quaterniond turn = Quaterniond::Exp({0.4, -0.7, 1.1});
  Vec3d at{3, -2, 1};
  Mesh mesh;

  void Add(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Vec3d& p : {a, b, c}) mesh.positions.push_back((turn * p + at).Cast<float>());
    mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
  }
  std::vector<FaceOverlap> Overlaps() const { return FindOverlaps(mesh, TriangleTree(mesh)); }
};

TEST(CoplanarFaces, MeasuresTheOverlap) {
  Placed p;
  p.Add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  p.Add({1, 0, 0}, {1, 1, 0}, {-1, 1, 0});  // also wound the other way round
  const auto overlaps = p.Overlaps();
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_EQ(overlaps[0].first, 0u);
  EXPECT_EQ(overlaps[0].second, 1u);
  EXPECT_NEAR(overlaps[0].area_m2, 0.75, 1e-5);  // without the corner beyond x = 0
  const Vec3d middle = p.turn.Conjugate() * (overlaps[0].middle - p.at);
  EXPECT_GT(middle.x, 0);
  EXPECT_NEAR(middle.z, 0, 1e-5);
}

TEST(CoplanarFaces, NeighboursDoNotOverlap) {
  Placed p;
  p.Add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  p.Add({1, 0, 0}, {1, 1, 0}, {0, 1, 0});     // across the long side
  p.Add({0, 0, 0}, {0, -1, 0}, {1, 0, 0});    // at the edge
  p.Add({0, 0, 0}, {-1, 0, 0}, {-1, -1, 0});  // at the corner
  EXPECT_TRUE(p.Overlaps().empty());
}

TEST(CoplanarFaces, ApartOrInclinedIsNoOverlap) {
  Placed p;
  p.Add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  p.Add({0, 0, 2e-5}, {1, 0, 2e-5}, {0, 1, 2e-5});
  p.Add({0, 0, -1e-4}, {1, 0, 1e-4}, {0, 1, -1e-4});
  p.Add({0, 0, 0}, {1, 0, 0}, {0, 0.7, 0.7});
  EXPECT_TRUE(p.Overlaps().empty());
}

TEST(CoplanarFaces, WithinTheToleranceIsOne) {
  Placed p;
  p.Add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  p.Add({0, 0, 5e-6}, {1, 0, 5e-6}, {0, 1, 5e-6});
  EXPECT_EQ(p.Overlaps().size(), 1u);
}

// A small triangle anywhere on a large one, and a triangle that is a line.
TEST(CoplanarFaces, SizesMayDiffer) {
  Placed p;
  p.Add({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
  p.Add({4, 4, 0}, {4.002, 4, 0}, {4, 4.002, 0});
  p.Add({1, 1, 0}, {2, 2, 0}, {3, 3, 0});
  const auto overlaps = p.Overlaps();
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_NEAR(overlaps[0].area_m2, 2e-6, 1e-8);
}

TEST(CoplanarFaces, AreTheSameForAnyNumberOfThreads) {
  Placed p;
  for (int i = 0; i < 9000; ++i) {
    const double x = 0.5 * (i % 90), y = 0.5 * (i / 90);
    p.Add({x, y, 0}, {x + 0.8, y, 0}, {x, y + 0.8, 0});
  }
  SetThreadCount(1);
  const auto one = p.Overlaps();
  SetThreadCount(0);
  const auto all = p.Overlaps();
  ASSERT_EQ(one.size(), all.size());
  EXPECT_GT(one.size(), 17000u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].first, all[i].first);
    EXPECT_EQ(one[i].second, all[i].second);
    EXPECT_EQ(one[i].area_m2, all[i].area_m2);
  }
}

}  // namespace
}  // namespace silt::sim
