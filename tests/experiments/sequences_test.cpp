// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/trajectory.h"
#include "silt_program.h"

// Whole runs of the program: simulate, track, report.
namespace silt::experiments {
namespace {

using testing::HasSubstr;

std::string Quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

constexpr const char* kStretch = " --scene studio --width 320 --spp 1 --fps 20 --duration 0.5 ";

TEST(RenderAndTrack, ThroughFilesIsAsInMemory) {
  const TestFolder folder;
  const ProgramResult rendered =
      RunSilt(std::string("render") + kStretch + "--out " + Quoted(folder / "seq"));
  ASSERT_EQ(rendered.exit_code, 0) << rendered.error;
  const ProgramResult from_files =
      RunSilt("track " + Quoted(folder / "seq") + " --out " + Quoted(folder / "files.txt"));
  ASSERT_EQ(from_files.exit_code, 0) << from_files.error;
  const ProgramResult in_loop =
      RunSilt(std::string("track") + kStretch + "--out " + Quoted(folder / "memory.txt"));
  ASSERT_EQ(in_loop.exit_code, 0) << in_loop.error;

  const Trajectory files = ReadTumTrajectory(folder / "files.txt");
  const Trajectory memory = ReadTumTrajectory(folder / "memory.txt");
  ASSERT_EQ(files.size(), 10u);
  ASSERT_EQ(memory.size(), 10u);
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(files[i].time_s, memory[i].time_s);
    const SE3d difference = files[i].world_from_camera.Inverse() * memory[i].world_from_camera;
    // Depth in files is rounded to 0.2 mm.
    EXPECT_LT(Norm(difference.translation), 2e-4) << i;
    EXPECT_LT(RotationAngle(difference.rotation), 2e-4) << i;
  }
}

TEST(Render, WritesAWholeSequenceWithItsManifest) {
  const TestFolder folder;
  const ProgramResult result = RunSilt(
      "render --scene studio --width 64 --fps 10 --duration 0.3 --blur full --noise handa "
      "--seed 7 --out " +
      Quoted(folder / "seq"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("3 frames"));
  for (const char* name :
       {"rgb/000002.png", "depth/000002.png", "camera.txt", "associations.txt"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "seq" / name)) << name;
  }
  EXPECT_EQ(ReadTumTrajectory(folder / "seq/groundtruth.txt").size(), 3u);
  const auto manifest = nlohmann::json::parse(ReadText(folder / "seq/manifest.json"));
  EXPECT_EQ(manifest["seed"], 7);
  EXPECT_EQ(manifest["config"]["render"]["exposure_s"], 0.1);
  EXPECT_EQ(manifest["config"]["render"]["noise"], "handa");
  EXPECT_THAT(manifest["command"], HasSubstr("--blur full"));
  for (const char* fact : {"commit", "compiler", "flags", "processor", "threads", "libraries"}) {
    EXPECT_TRUE(manifest.contains(fact)) << fact;
  }
}

TEST(Render, TheShutterMayBeOpenForAShareOfTheFrameAndRoll) {
  const TestFolder folder;
  const ProgramResult result = RunSilt(
      "render --scene studio --width 64 --fps 10 --duration 0.1 --exposure-time 25% --row-time 500 "
      "--filter gaussian --pattern scrambled --out " +
      Quoted(folder / "seq"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto render =
      nlohmann::json::parse(ReadText(folder / "seq/manifest.json"))["config"]["render"];
  EXPECT_DOUBLE_EQ(render["exposure_s"], 0.025);
  EXPECT_DOUBLE_EQ(render["row_time_s"], 5e-4);
  EXPECT_EQ(render["filter"], "gaussian");
  EXPECT_EQ(render["pattern"], "scrambled");
}

// A limit on the size of files stands for a full disk, which takes no privilege to make.
TEST(Render, OnAFullDiskLeavesNothing) {
  const TestFolder folder;
  const ProgramResult result =
      RunSilt("render --scene studio --width 320 --fps 10 --duration 0.3 --out " +
                  Quoted(folder / "out/seq"),
              "trap '' XFSZ; ulimit -f 16;");
  EXPECT_EQ(result.exit_code, 1);
  ExpectOneLineError(result, ".png");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

TEST(Render, InterruptedLeavesWholeFramesToGoOnWith) {
  const TestFolder folder;
  const ProgramResult result =
      RunSilt("render --scene studio --width 320 --spp 64 --fps 1000 --duration 1 --out " +
                  Quoted(folder / "out/seq"),
              "timeout --preserve-status --signal INT 5");
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.error, HasSubstr("silt: interrupted"));
  if (!std::filesystem::exists(folder / "out/seq")) return;  // not a frame yet
  EXPECT_THAT(result.error, HasSubstr("of 1000 frames are there; the same command goes on"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/seq/unfinished.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/seq/manifest.json"));
}

class Accuracy : public testing::Test {
 protected:
  ProgramResult Run(const std::string& out, const std::string& options) const {
    return RunSilt("experiment accuracy --quick --duration 0.3 --spp 1 " + options + " --out " +
                   Quoted(folder_ / out));
  }
  nlohmann::json Results(const std::string& out) const {
    return nlohmann::json::parse(ReadText(folder_ / out / "accuracy.json"));
  }

  TestFolder folder_;
};

TEST_F(Accuracy, OnTheStudioIsWithinItsBound) {
  const ProgramResult result = Run("a", "");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("Table 2."));
  EXPECT_THAT(result.out, HasSubstr("Table 3."));
  const nlohmann::json runs = Results("a")["runs"];
  ASSERT_EQ(runs.size(), 3u);
  const char* const names[] = {"20fps", "60fps", "60fps-blur"};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(runs[i]["sequence"], names[i]);
    EXPECT_EQ(runs[i]["preset"], "paper");
    EXPECT_EQ(runs[i]["frames"], i == 0 ? 6 : 18);
    EXPECT_EQ(runs[i]["lost"], 0);
    EXPECT_GE(runs[i]["keyframes"], 1);
    EXPECT_GT(runs[i]["path_m"], 0.01);
    EXPECT_LT(runs[i]["position_cm"]["rmse"], 0.2);
    EXPECT_GT(runs[i]["position_cm"]["rmse"], 0);
    EXPECT_LT(runs[i]["ate_aligned_cm"], 0.2);
    for (const char* axis : {"x", "y", "z"}) {
      EXPECT_LT(runs[i]["orientation_deg"][axis]["rmse"], 0.1);
      EXPECT_LE(runs[i]["orientation_deg"][axis]["min"], 0);
    }
  }
  EXPECT_THAT(ReadText(folder_ / "a/report.html"), HasSubstr("Table 3."));
  EXPECT_EQ(ReadTumTrajectory(folder_ / "a/trajectories/20fps-truth.txt").size(), 6u);
}

TEST_F(Accuracy, TrajectoriesAreTheSameBytesForAnyNumberOfThreadsAndOtherwiseWithTheSeed) {
  ASSERT_EQ(Run("one", "--threads 1 --seed 1").exit_code, 0);
  ASSERT_EQ(Run("two", "--threads 2 --seeds 2").exit_code, 0);
  for (const char* name : {"20fps-paper-seed1", "60fps-paper-seed1", "60fps-blur-paper-seed1"}) {
    const std::string file = std::string("trajectories/") + name + ".txt";
    EXPECT_FALSE(ReadText(folder_ / "one" / file).empty());
    EXPECT_EQ(ReadText(folder_ / "one" / file), ReadText(folder_ / "two" / file)) << name;
  }
  EXPECT_NE(ReadText(folder_ / "two/trajectories/60fps-blur-paper.txt"),
            ReadText(folder_ / "two/trajectories/60fps-blur-paper-seed1.txt"));
  const nlohmann::json results = Results("two");
  EXPECT_EQ(results["runs"].size(), 6u);
  ASSERT_EQ(results["spread"].size(), 3u);
  EXPECT_EQ(results["spread"][0]["seeds"], 2);
}

}  // namespace
}  // namespace silt::experiments
