// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <set>
#include <thread>

#include "scene_builder.h"
#include "silt/core/error.h"
#include "silt/sim/irradiance.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

// An empty folder that XDG_CACHE_HOME names while a test runs.
class LightCache : public testing::Test {
 protected:
  void SetUp() override {
    const char* before = std::getenv("XDG_CACHE_HOME");
    if (before) before_ = before;
    folder_ = fs::temp_directory_path() / ("silt-light-cache-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  void TearDown() override {
    if (before_)
      ::setenv("XDG_CACHE_HOME", before_->c_str(), 1);
    else
      ::unsetenv("XDG_CACHE_HOME");
    fs::remove_all(folder_);
  }

  fs::path folder_;
  std::optional<std::string> before_;
};

BakedLight SomeLight() {
  std::vector<Vec3f> fine(2 * FineLight::kPlaces, {1, 2, 3});
  fine.back() = {0, 0, 4};
  return {{{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {0.5f, 0, 1e-20f}}},
          {{{{3, 1, 2}, 0}, {{3, 1, 4}, 1}}, fine}};
}

std::string Contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void Overwrite(const fs::path& file, const std::string& contents) {
  std::ofstream(file, std::ios::binary) << contents;
}

TEST_F(LightCache, GivesBackWhatWasWritten) {
  WriteLight(folder_ / "light", SomeLight());
  const std::optional<BakedLight> light = ReadLight(folder_ / "light", 2);
  ASSERT_TRUE(light);
  EXPECT_EQ(light->samples.front[1].y, 5);
  EXPECT_EQ(light->samples.back[1].z, 1e-20f);
  ASSERT_EQ(light->fine.patches().size(), 2u);
  EXPECT_EQ(light->fine.patches()[1], SomeLight().fine.patches()[1]);
  EXPECT_EQ(light->fine.irradiance().back().z, 4);
}

TEST_F(LightCache, AFileThatIsNotRightIsNotRead) {
  const fs::path file = folder_ / "light";
  EXPECT_FALSE(ReadLight(file, 2));  // missing
  WriteLight(file, SomeLight());
  const std::string good = Contents(file);
  EXPECT_FALSE(ReadLight(file, 1));  // of another grid
  EXPECT_FALSE(ReadLight(file, 3));
  for (const std::size_t place : {std::size_t(0), std::size_t(33), good.size() - 1}) {
    std::string bad = good;
    bad[place] ^= 1;
    Overwrite(file, bad);
    EXPECT_FALSE(ReadLight(file, 2)) << "byte " << place;
  }
  Overwrite(file, good.substr(0, good.size() - 1));
  EXPECT_FALSE(ReadLight(file, 2));
  Overwrite(file, good + "x");
  EXPECT_FALSE(ReadLight(file, 2));
  Overwrite(file, good);
  EXPECT_TRUE(ReadLight(file, 2));
}

// Whoever reads finds one writer's whole light, never a mixture or a part.
TEST_F(LightCache, WritersAndReadersDoNotMeet) {
  const fs::path file = folder_ / "light-shared";
  const auto light_of = [](int writer) {
    return BakedLight{StoredLight(std::vector<Vec3f>(20'000, {float(writer), 0, 0}),
                                  std::vector<Vec3f>(20'000, {0, float(writer), 0})),
                      {}};
  };
  WriteLight(file, light_of(0));
  std::atomic<bool> stop{false};
  std::vector<std::thread> writers;
  for (int writer = 1; writer <= 3; ++writer) {
    writers.emplace_back([&, writer] {
      while (!stop) WriteLight(file, light_of(writer));
    });
  }
  for (int i = 0; i < 50; ++i) {
    const std::optional<BakedLight> light = ReadLight(file, 20'000);
    EXPECT_TRUE(light && light->samples.front.front().x == light->samples.back.back().y);
  }
  stop = true;
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);  // nothing is left over
}

TEST_F(LightCache, TheNameFollowsAllThatLightDependsOn) {
  std::set<fs::path> names;
  const auto add = [&](const Scene& scene, const LightingOptions& options = {}) {
    names.insert(*LightCacheFile(scene, options));
  };
  const Scene scene = RoomWithBoxAndBall();
  add(scene);
  add(scene);
  EXPECT_EQ(names.size(), 1u);
  Scene moved = scene, tinted = scene, lamp = scene, sky = scene, turned = scene, out = scene;
  out.environment = std::make_shared<const Environment>(MakeSky({}));
  moved.mesh.positions.back().x += 1e-5f;
  tinted.materials[1].diffuse.y += 1e-3f;
  lamp.lights[0].radiance.z += 1;
  sky.ambient.x += 1e-3f;
  turned.materials[0].two_sided = false;
  for (const Scene& other : {moved, tinted, lamp, sky, turned, out}) add(other);
  LightingOptions finer, more_points, more_directions, other_seed, unrefined;
  finer.direct_spacing_m /= 2;
  more_points.light_points *= 2;
  more_directions.gather_directions *= 2;
  other_seed.seed = 1;
  unrefined.refine_tolerance = 1;
  for (const LightingOptions& other :
       {finer, more_points, more_directions, other_seed, unrefined}) {
    add(scene, other);
  }
  EXPECT_EQ(names.size(), 12u);
  Scene exposed = scene;
  exposed.exposure *= 2;  // does not change the light, nor does gloss
  exposed.materials[0].roughness += 0.1f;
  add(exposed);
  EXPECT_EQ(names.size(), 12u);
}

TEST_F(LightCache, KeepsTheEntriesWrittenLast) {
  Overwrite(folder_ / "other", "not ours");
  const auto start = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (int i = 0; i < 20; ++i) {
    const fs::path file = folder_ / ("light-" + std::to_string(i));
    WriteLight(file, SomeLight());
    fs::last_write_time(file, start + std::chrono::minutes(i));
  }
  WriteLight(folder_ / "light-new", SomeLight());
  EXPECT_TRUE(fs::exists(folder_ / "light-new"));
  EXPECT_TRUE(fs::exists(folder_ / "light-19"));
  EXPECT_FALSE(fs::exists(folder_ / "light-0"));
  EXPECT_TRUE(fs::exists(folder_ / "other"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 17);
}

TEST_F(LightCache, RemovesWhatAWriterThatWasKilledLeft) {
  const fs::path dead = folder_ / ".light-1.part-12-0", alive = folder_ / ".light-2.part-13-0",
                 other = folder_ / ".other.part-12-0";
  for (const fs::path& file : {dead, alive, other}) {
    Overwrite(file, "a part");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(2));
  }
  fs::last_write_time(alive, fs::file_time_type::clock::now());
  WriteLight(folder_ / "light-new", SomeLight());
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_TRUE(fs::exists(other));
}

TEST_F(LightCache, WithoutAHomeThereIsNone) {
  const char* home = std::getenv("HOME");
  const std::string kept = home ? home : "";
  ::unsetenv("HOME");
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_FALSE(LightCacheFile({}, {}));
  if (home) ::setenv("HOME", kept.c_str(), 1);
}

// A floor of half a million samples.
TEST_F(LightCache, ALargeSceneIsSolvedOnce) {
  SceneBuilder builder;
  builder.AddQuad({0, 0, 0}, {5, 0, 0}, {0, 5, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  builder.scene.ambient = {1, 1, 1};
  const RayTracer tracer(builder.scene);
  LightingOptions options;
  options.direct_spacing_m = 0.01f;
  options.indirect_spacing_m = 1;
  int reports = 0;
  options.progress = [&](double) { ++reports; };
  const float first = Irradiance(builder.scene, tracer, options).At(0, 0.3f, 0.3f, true).x;
  EXPECT_GT(reports, 0);
  const fs::path file = *LightCacheFile(builder.scene, options);
  EXPECT_TRUE(fs::exists(file));
  reports = 0;
  EXPECT_EQ(Irradiance(builder.scene, tracer, options).At(0, 0.3f, 0.3f, true).x, first);
  EXPECT_EQ(reports, 0);
  Overwrite(file, "no light");
  EXPECT_EQ(Irradiance(builder.scene, tracer, options).At(0, 0.3f, 0.3f, true).x, first);
  EXPECT_GT(reports, 0);
  // A folder that cannot be written costs nothing but time.
  fs::remove_all(folder_);
  Overwrite(folder_, "a file");
  EXPECT_EQ(Irradiance(builder.scene, tracer, options).At(0, 0.3f, 0.3f, true).x, first);
}

}  // namespace
}  // namespace silt::sim
