// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/keyframe_map.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "silt_program.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

constexpr PinholeCamera kCamera{40, 40, 19.5, 14.5, 40, 30};

// A wall at z = 2 m, seen from the origin and from beside it.
tracker::Keyframe WallFrom(double x, Rgb8 color) {
  tracker::Keyframe keyframe;
  keyframe.frame.rgb = Image<Rgb8>(40, 30, color);
  keyframe.frame.depth_m = Image<float>(40, 30, 2.0f);
  keyframe.world_from_camera.translation = {x, 0, 0};
  return keyframe;
}

TEST(KeyframeMap, PointsLieOnWhatTheKeyframesSaw) {
  const PlyModel cloud = FusedCloud({WallFrom(0, {10, 20, 30})}, kCamera, 0.001);
  EXPECT_EQ(cloud.points.size(), 40u * 30u);  // a pixel is 5 cm wide there
  ASSERT_EQ(cloud.colors.size(), cloud.points.size());
  float left = 0, right = 0;
  for (const Vec3f& p : cloud.points) {
    EXPECT_NEAR(p.z, 2, 1e-6);
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  EXPECT_NEAR(left, -19.5 / 20, 1e-5);
  EXPECT_NEAR(right, 19.5 / 20, 1e-5);
  EXPECT_EQ(cloud.colors[7], (Rgb8{10, 20, 30}));
}

TEST(KeyframeMap, KeyframesFuseInTheirVoxels) {
  const tracker::Keyframe first = WallFrom(0, {100, 0, 0});
  tracker::Keyframe second = WallFrom(0, {200, 0, 0});
  for (float& z : second.frame.depth_m) z = 2.004f;
  const PlyModel one = FusedCloud({first}, kCamera, 0.04);
  const PlyModel both = FusedCloud({first, second}, kCamera, 0.04);
  EXPECT_NEAR(double(both.points.size()), double(one.points.size()), 40);
  int mixed = 0;
  for (std::size_t i = 0; i < both.points.size(); ++i) {
    EXPECT_GE(both.points[i].z, 2 - 1e-6);
    EXPECT_LE(both.points[i].z, 2.004 + 1e-6);
    mixed += both.colors[i].r > 140 && both.colors[i].r < 160 ? 1 : 0;
  }
  EXPECT_GT(mixed, int(0.9 * double(both.points.size())));
  // From farther apart each sees a part of its own.
  EXPECT_GT(FusedCloud({first, WallFrom(1, {})}, kCamera, 0.04).points.size(),
            one.points.size() * 5 / 4);
}

TEST(KeyframeMap, EdgesAndHolesOfDepthGiveNoPoints) {
  tracker::Keyframe keyframe = WallFrom(0, {});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (x < 10) keyframe.frame.depth_m(x, y) = NAN;
      if (x >= 30) keyframe.frame.depth_m(x, y) = 1;
    }
  }
  const PlyModel cloud = FusedCloud({keyframe}, kCamera, 0.001);
  EXPECT_LT(cloud.points.size(), 30u * 30u - 2u * 30u);
  EXPECT_GT(cloud.points.size(), 30u * 20u);
  for (const Vec3f& p : cloud.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST(KeyframeMap, LinesShowCamerasAndThePath) {
  const Trajectory path{{0, {{}, {0, 0, 0}}}, {1, {{}, {0.5, 0, 0}}}, {2, {{}, {1, 0, 0}}}};
  const PlyModel lines = CameraLines({WallFrom(0, {}), WallFrom(1, {})}, kCamera, path, 0.2);
  EXPECT_EQ(lines.edges.size(), 2 * 8u + 2u);
  for (const auto& edge : lines.edges) {
    for (const int index : edge) ASSERT_LT(std::size_t(index), lines.points.size());
  }
  EXPECT_EQ(lines.points.back().x, 1);
  EXPECT_NE(lines.colors.front(), lines.colors.back());
}

TEST(TrackCommand, WritesAMap) {
  const TestFolder folder;
  const ProgramResult result = RunSilt(
      "track --scene studio --width 160 --spp 1 --fps 10 --duration 1 --preset fast --voxel 0.02 "
      "--map " +
      (folder / "map").string() + " --out " + (folder / "path.txt").string());
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto manifest = nlohmann::json::parse(ReadText(folder / "map/manifest.json"));
  EXPECT_GE(manifest["map"]["keyframes"], 2);
  EXPECT_GT(manifest["map"]["points"], 5000);
  for (const char* name : {"cloud.ply", "cameras.ply", "path.txt", "figures/map.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "map" / name)) << name;
  }
  // Either a mesh or a word about why there is none.
  const bool meshed = std::filesystem::exists(folder / "map/mesh.ply");
  EXPECT_EQ(meshed, manifest["map"]["triangles"].is_number());
  EXPECT_EQ(meshed, result.error.find("no mesh.ply") == std::string::npos);
}

}  // namespace
}  // namespace silt::experiments
