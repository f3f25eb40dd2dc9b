// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "shipped_scenes.h"
#include "silt/sim/path_check.h"
#include "silt/sim/path_file.h"
#include "silt/sim/ray_packet.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/scene.h"

namespace silt::sim {
namespace {

// What a trajectory's name promises; speeds in m/s, turns in °/s.
struct Promise {
  double min_length_m, max_length_m;
  double min_mean_speed, max_mean_speed;
  double max_speed;
  double min_mean_turn, max_mean_turn;
  double min_max_turn, max_turn;
};

constexpr Promise kCalm{2, 8, 0.1, 0.25, 0.6, 8, 20, 15, 60};
constexpr Promise kFast{5, 25, 0.3, 1.0, 1.2, 20, 50, 55, 100};

// Of the office's paths, `desk` is the calm one.
const std::map<std::string, Promise> kPromises{{"calm", kCalm}, {"desk", kCalm}, {"fast", kFast}};

struct ShippedPath {
  std::string scene, name;

  friend void PrintTo(const ShippedPath& path, std::ostream* out) {
    *out << path.scene << '/' << path.name;
  }
};

// Those that promise something.
std::vector<ShippedPath> ShippedPaths() {
  std::vector<ShippedPath> paths;
  for (const std::string& scene : ShippedScenes()) {
    for (const auto& [name, promise] : kPromises) {
      if (std::filesystem::exists(ShippedFile(scene, name + ".toml"))) {
        paths.push_back({scene, name});
      }
    }
  }
  return paths;
}

class ShippedPathTest : public testing::TestWithParam<ShippedPath> {
 protected:
  CameraPath Load() const {
    return LoadCameraPath(ShippedFile(GetParam().scene, GetParam().name + ".toml"));
  }
};

TEST_P(ShippedPathTest, MovesAsItsNamePromises) {
  const PathStatistics path = Load().Statistics();
  const Promise& p = kPromises.at(GetParam().name);
  EXPECT_GE(path.length_m, p.min_length_m);
  EXPECT_LE(path.length_m, p.max_length_m);
  EXPECT_GE(path.mean_speed_m_s, p.min_mean_speed);
  EXPECT_LE(path.mean_speed_m_s, p.max_mean_speed);
  EXPECT_LE(path.max_speed_m_s, p.max_speed);
  EXPECT_GE(path.mean_turn_deg_s, p.min_mean_turn);
  EXPECT_LE(path.mean_turn_deg_s, p.max_mean_turn);
  EXPECT_GE(path.max_turn_deg_s, p.min_max_turn);
  EXPECT_LE(path.max_turn_deg_s, p.max_turn);
}

// Somewhere it comes back to within a stride of where it has been more than a third of its time
// before, and sees much the same.
TEST_P(ShippedPathTest, RevisitsAPlace) {
  const CameraPath path = Load();
  constexpr int kSteps = 60;
  bool revisits = false;
  for (int later = kSteps / 3; later <= kSteps; ++later) {
    const SE3d pose = path.WorldFromCamera(path.duration_s() * later / kSteps);
    for (int earlier = 0; earlier <= later - kSteps / 3; ++earlier) {
      const SE3d other = path.WorldFromCamera(path.duration_s() * earlier / kSteps);
      const double cosine = Dot(pose.rotation * Vec3d{0, 0, 1}, other.rotation * Vec3d{0, 0, 1});
      revisits |= Norm(pose.translation - other.translation) < 0.3 && cosine > 0.9;
    }
  }
  EXPECT_TRUE(revisits);
}

// Clear by half a head; and whoever is inside meets something all round, above and below.
TEST_P(ShippedPathTest, StaysInsideAndClear) {
  if (!FurnitureIsInstalled()) GTEST_SKIP() << "sweethome3d-furniture is not installed";
  const Scene scene = LoadScene(ShippedFile(GetParam().scene, "scene.toml"));
  const CameraPath path = Load();
  for (const PathContact& contact : CheckPath(path, scene, {.clearance_m = 0.1}).contacts) {
    ADD_FAILURE() << Describe(contact);
  }
  const RayTracer tracer(scene);
  for (double time_s = 0; time_s < path.duration_s(); time_s += 0.5) {
    const Vec3f from = path.WorldFromCamera(time_s).translation.Cast<float>();
    RayPacket rays;
    const Vec3f ways[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 6; ++i) rays.Set(i, {from, ways[i], 0, 50});
    EXPECT_EQ(tracer.Occluded(rays) & 0b111111u, 0b111111u) << "at " << time_s << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedPathTest, testing::ValuesIn(ShippedPaths()),
                         [](const auto& named) {
                           return named.param.scene + "_" + named.param.name;
                         });

TEST(ShippedPathsTest, EveryRoomHasACalmAndAFastOne) {
  std::map<std::string, int> calm, fast;
  for (const ShippedPath& path : ShippedPaths()) {
    calm[path.scene] += path.name == "calm" || path.name == "desk";
    fast[path.scene] += path.name == "fast";
  }
  for (const std::string scene : {"livingroom", "office", "stairwell"}) {
    EXPECT_EQ(calm[scene], 1) << scene;
    EXPECT_EQ(fast[scene], 1) << scene;
  }
}

}  // namespace
}  // namespace silt::sim
