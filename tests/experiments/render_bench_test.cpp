// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/render_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt_program.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

using ::testing::HasSubstr;

TEST(RenderBench, RatiosAreOfTheSameRays) {
  RenderSpeed speed{"", 1e6, 0.02, 0.05, 0.1};
  EXPECT_DOUBLE_EQ(speed.Ratio(), 0.4);
  EXPECT_DOUBLE_EQ(speed.Fps(), 10);
  EXPECT_DOUBLE_EQ(speed.RawMegaRays(2), 100);
  EXPECT_DOUBLE_EQ(speed.MegaRays(2), 40);
}

TEST(RenderBench, CountsTheRaysOfEachPictureAndOfItsDepth) {
  const RenderBench bench = MeasureRendering(StudioWorld(), {160, 1, 3});
  const double pixels = 160 * 120;
  EXPECT_EQ(bench.geometry.rays, pixels);
  EXPECT_EQ(bench.baked_4spp.rays, 5 * pixels);
  EXPECT_EQ(bench.blur_16.rays, 17 * pixels);
  for (const RenderSpeed* speed : {&bench.geometry, &bench.baked_4spp, &bench.blur_16}) {
    EXPECT_GT(speed->raw_s, 0);
    EXPECT_GT(speed->cpu_s, 0.7 * speed->raw_s);  // more is done, and the clock is not exact
    EXPECT_GT(speed->wall_s, 0);
  }
  EXPECT_GT(bench.blur_16.raw_s, 1.5 * bench.baked_4spp.raw_s);
  EXPECT_GT(bench.costs.embree_ns, 0);
  EXPECT_GT(bench.costs.shading_ns, 0);
}

TEST(RenderBench, TheCommandWritesItsResults) {
  const ProgramResult result =
      RunSilt("bench render --scene studio --width 64 --instants 1 --repeats 1 --no-bake --json -");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json json = Json::parse(result.out);
  for (const char* part : {"geometry", "baked_4spp", "blur_16"}) {
    for (const char* key : {"mrays", "ratio", "fps"}) EXPECT_GT(json[part][key], 0) << part;
  }
  EXPECT_GT(json["raw"]["mrays"], 0);
  EXPECT_GT(json["load_s"], 0);
  EXPECT_TRUE(json["bake_s"].is_null());
  EXPECT_GT(json["peak_rss_mb"], 10);
  EXPECT_THAT(json["manifest"]["command"], HasSubstr("bench render"));
}

TEST(RenderBench, TheCommandTimesTheBake) {
  const ProgramResult result =
      RunSilt("bench render --scene studio --width 16 --instants 1 --repeats 1");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("with 16 instants"));
  EXPECT_THAT(result.out, HasSubstr("shading"));
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("not measured")));
}

// A floor of 12 m × 12 m has enough samples for its light to be kept.
TEST(RenderBench, LoadingIsTimedWithoutTheBakeAlsoWhereNothingIsCached) {
  const TestFolder folder;
  std::ofstream(folder / "scene.toml")
      << "name = \"Floor\"\nambient = [1, 1, 1]\n[[material]]\nname = \"gray\"\n"
         "[[quad]]\nmaterial = \"gray\"\ncorner = [-6, -6, 0]\nu = [12, 0, 0]\nv = [0, 12, 0]\n";
  std::ofstream(folder / "path.toml")
      << "[line]\nfrom = [0, 0, 2]\nto = [1, 0, 2]\nduration_s = 1\nlook_at = [0, 1, 0]\n";
  const auto start = std::chrono::steady_clock::now();
  const ProgramResult result =
      RunSilt("bench render --scene '" + (folder / "scene.toml").string() + "' --trajectory '" +
                  (folder / "path.toml").string() +
                  "' --width 16 --instants 1 --repeats 1 --no-bake --json -",
              "XDG_CACHE_HOME='" + folder.path().string() + "'");
  const double all_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_FALSE(std::filesystem::is_empty(folder / "silt"));  // it was computed, and kept
  EXPECT_LT(double(Json::parse(result.out)["load_s"]), 0.3 * all_s);
}

}  // namespace
}  // namespace silt::experiments
