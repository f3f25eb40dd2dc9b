// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
// `silt scene` and `silt path`, and that `silt render` keeps out of walls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/experiments/output.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

const std::string kWall = R"(name = "Wall"
[[material]]
name = "plaster"
color = "#808080"
[[box]]
name = "wall"
material = "plaster"
size = [0.2, 4, 3]
at = [1, 0, 0]
[[quad]]
name = "floor"
material = "plaster"
corner = [-2, -2, 0]
u = [4, 0, 0]
v = [0, 4, 0]
)";

const std::string kThrough = R"([line]
from = [0, 0, 1]
to = [2, 0, 1]
duration_s = 2
)";

std::string Write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file.string();
}

TEST(SceneCommand, InfoTellsWhatASceneConsistsOf) {
  const TestFolder folder;
  const std::string json_file = (folder / "facts.json").string();
  const ProgramResult result = RunSilt("scene info studio --json " + json_file);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("triangles:"));
  EXPECT_THAT(result.out, HasSubstr("megapixels"));
  const Json facts = ReadJson(json_file);
  EXPECT_EQ(facts["name"], "Studio");
  std::size_t triangles = 0;
  for (const Json& instance : facts["instances"]) triangles += instance["triangles"].get<int>();
  EXPECT_EQ(facts["triangles"], triangles);
  EXPECT_GT(facts["textures"].size(), 10u);
  // Four channels of 16 bits, at each level with a column and a row more.
  double bytes = 0;
  for (const Json& texture : facts["textures"]) {
    for (int w = texture["width"], h = texture["height"];;
         w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
      bytes += 8.0 * (w + 1) * (h + 1);
      if (w == 1 && h == 1) break;
    }
  }
  EXPECT_NEAR(facts["textures_mb"].get<double>(), bytes / (1 << 20), 1e-6);
  EXPECT_EQ(facts["instances"][0]["size_m"].size(), 3u);
}

TEST(SceneCommand, InfoKnowsSizesAndLights) {
  const TestFolder folder;
  const std::string light =
      "[[light]]\nname = \"lamp\"\ncenter = [0, 0, 2.9]\nu = [0.5, 0, 0]\nv = [0, -0.25, 0]\n"
      "radiance = [2, 2, 2]\n";
  const std::string scene = Write(folder / "scene.toml", kWall + light);
  const Json facts = Json::parse(RunSilt("scene info " + scene + " --json -").out);
  EXPECT_EQ(facts["triangles"], 12 + 2 + 2);
  EXPECT_NEAR(facts["size_m"][2].get<double>(), 3, 1e-6);
  EXPECT_EQ(facts["instances"][0]["name"], "wall");
  EXPECT_NEAR(facts["instances"][0]["size_m"][0].get<double>(), 0.2, 1e-6);
  ASSERT_EQ(facts["lights"].size(), 1u);
  EXPECT_NEAR(facts["lights"][0]["area_m2"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(facts["lights"][0]["flux"][0].get<double>(), 3.14159, 1e-4);
  EXPECT_EQ(facts["environment"], false);
  const std::string sky =
      Write(folder / "sky.toml", kWall +
                                     "[environment]\nzenith = [1, 1, 2]\nhorizon = [1, 1, 1]\n"
                                     "ground = [0.2, 0.2, 0.2]\n");
  const ProgramResult result = RunSilt("scene info " + sky);
  EXPECT_THAT(result.out, HasSubstr("0, an environment, ambient")) << result.error;
  EXPECT_THAT(result.out, HasSubstr("of which 0 emit light"));
}

TEST(SceneCommand, CheckPassesTheStudio) {
  const ProgramResult result = RunSilt("scene check studio");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("0 errors"));
}

TEST(SceneCommand, CheckTellsOfWarningsAndFailsForErrors) {
  const TestFolder folder;
  const std::string rug =
      "[[quad]]\nname = \"rug\"\nmaterial = \"plaster\"\ncorner = [-1, -1, 0]\nu = [1, 0, 0]\n"
      "v = [0, 1, 0]\n";
  const std::string scene = Write(folder / "scene.toml", kWall + rug);
  const ProgramResult warned = RunSilt("scene check " + scene);
  EXPECT_EQ(warned.exit_code, 0) << warned.error;
  EXPECT_THAT(warned.out, HasSubstr("warning: 'floor' and 'rug' have faces in the same place"));
  EXPECT_THAT(warned.out, HasSubstr("0 errors, 1 warnings"));
  ExpectOneLineError(RunSilt("scene check --strict " + scene), "the scene has warnings");

  Write(folder / "scene.toml", "ambient = [0, 0, 0]\n" + kWall);
  const ProgramResult dark = RunSilt("scene check " + scene + " --json -");
  ExpectOneLineError(dark, "the scene has errors");
  EXPECT_EQ(Json::parse(dark.out)["errors"], 1);
  ExpectOneLineError(RunSilt("scene check " + (folder / "none.toml").string()), "none.toml");
}

TEST(PathCommand, InfoTellsOfSpeeds) {
  const TestFolder folder;
  const std::string path = Write(folder / "through.toml", kThrough);
  const ProgramResult result = RunSilt("path info " + path);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("2.000 m in 2.000 s"));
  const Json facts = Json::parse(RunSilt("path info " + path + " --json -").out);
  EXPECT_NEAR(facts["mean_speed_m_s"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(facts["max_acceleration_m_s2"].get<double>(), 0, 1e-6);
  EXPECT_FALSE(facts.contains("replay"));
  EXPECT_THAT(RunSilt("path info --scene studio").out, HasSubstr("orbit.toml"));
  ExpectOneLineError(RunSilt("path info"), "--scene");
}

TEST(PathCommand, InfoTellsHowWellAReplayFits) {
  const TestFolder folder;
  std::string recorded;
  for (int i = 0; i < 100; ++i) recorded += std::to_string(0.02 * i) + " 0 0 1 0 0 0 1\n";
  Write(folder / "recorded.txt", recorded);
  const std::string path = Write(folder / "replay.toml", "[replay]\nfile = \"recorded.txt\"\n");
  EXPECT_THAT(RunSilt("path info " + path).out, HasSubstr("replay of:          100 poses"));
  const Json facts = Json::parse(RunSilt("path info " + path + " --json -").out);
  EXPECT_EQ(facts["replay"]["poses"], 100);
  EXPECT_LT(facts["replay"]["residual_max_m"].get<double>(), 1e-9);
}

TEST(PathCommand, CheckNamesWhatIsInTheWay) {
  const TestFolder folder;
  const std::string scene = Write(folder / "scene.toml", kWall);
  const std::string path = Write(folder / "through.toml", kThrough);
  const ProgramResult result = RunSilt("path check " + path + " --scene " + scene);
  ExpectOneLineError(result, "crosses surfaces");
  EXPECT_THAT(result.out, HasSubstr("crosses 'wall'"));
  const ProgramResult low =
      RunSilt("path check --trajectory through --clearance 1.1 --json - --scene " + scene);
  EXPECT_EQ(low.exit_code, 1);
  EXPECT_EQ(Json::parse(low.out)["contacts"].size(), 2u);  // the wall and the floor
  const ProgramResult clear = RunSilt("path check --scene studio");
  EXPECT_EQ(clear.exit_code, 0) << clear.out << clear.error;
  EXPECT_THAT(clear.out, HasSubstr("keeps clear"));
}

TEST(CrossingPath, IsNotRendered) {
  const TestFolder folder;
  const std::string scene = Write(folder / "scene.toml", kWall);
  Write(folder / "through.toml", kThrough);
  const std::string render = "render --width 32 --fps 2 --scene " + scene + " --out ";
  const ProgramResult refused = RunSilt(render + (folder / "a").string());
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.error, HasSubstr("crosses 'wall'; --allow-crossing"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a" / "groundtruth.txt"));
  EXPECT_EQ(RunSilt(render + (folder / "b").string() + " --duration 0.8").exit_code, 0);
  EXPECT_EQ(RunSilt(render + (folder / "c").string() + " --allow-crossing").exit_code, 0);
}

}  // namespace
}  // namespace silt::experiments
