// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/track_bench.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/core/io/icl_camera.h"
#include "silt/core/io/image_file.h"
#include "silt/core/trajectory.h"
#include "silt/experiments/opencv_odometry.h"
#include "silt/experiments/pose_difference.h"
#include "silt_program.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

using ::testing::HasSubstr;

PairRun RunOf(double ms, double t_mm, bool found = true) {
  PairRun run;
  run.found = found;
  run.milliseconds = ms;
  run.t_mm = t_mm;
  run.stages.total_ms = ms / 2;
  run.stages.jacobian_ms = 2;
  run.pixel_iterations = 1e6;
  return run;
}

TEST(TrackBench, ReportsMediansOfAllPairsAndOfEachGap) {
  TrackBench bench;
  bench.pairs = {{{}, 1, 3}, {{}, 1, 5}, {{}, 9, 100}};
  bench.methods = {{"fast",
                    true,
                    {RunOf(8, 1), RunOf(9, 1), RunOf(10, 1)},
                    {RunOf(4, 1), RunOf(6, 3), RunOf(50, 9, false)}}};
  bench.fused_pass.photometric_ms = 0.7;
  const Json json = bench.ToJson();
  EXPECT_EQ(json["pairs"]["fast"]["ms"], 6);
  EXPECT_EQ(json["pairs"]["fast"]["ms_one_thread"], 9);
  EXPECT_EQ(json["pairs"]["fast"]["t_mm"], 3);
  EXPECT_EQ(json["pairs"]["fast"]["lost"], 1);
  EXPECT_TRUE(json["pairs"]["opencv_rgbd"].is_null());
  EXPECT_EQ(json["gaps"][0]["frames_apart"], 1);
  EXPECT_EQ(json["gaps"][0]["fast"]["ms"], 5);
  EXPECT_EQ(json["gaps"][1]["fast"]["t_mm"], 9);
  const Json stages = json["stages_ms"]["fast"]["threads"];
  EXPECT_EQ(stages["load"], 5);
  EXPECT_EQ(stages["total"], 3);
  EXPECT_DOUBLE_EQ(stages["frames_per_s"], 1000.0 / 3);
  EXPECT_DOUBLE_EQ(stages["pixel_iterations_per_s"], 5e8);
  EXPECT_FALSE(stages.contains("device_total"));
  for (PairRun& run : bench.methods[0].threads) run.device_ms = 0.25;
  const Json timed = bench.ToJson()["stages_ms"]["fast"]["threads"];
  EXPECT_EQ(timed["device_total"], 0.25);
  EXPECT_EQ(timed["device_frames_per_s"], 4000);
  EXPECT_EQ(json["fused_pass_ms"], 0.7);
  EXPECT_THAT(bench.Format(), HasSubstr("fast"));
}

// On each pair a tenth less; and on half of them less, on the others as much more.
TEST(TrackBench, TellsWhichDifferencesThePairsProve) {
  TrackBench bench;
  MethodRuns own{"fast", true, {}, {}}, worse{"worse", false, {}, {}}, same{"same", false, {}, {}};
  for (int i = 0; i < 40; ++i) {
    bench.pairs.push_back({{}, 3, 0});
    const double error = 1 + 0.01 * i;
    own.threads.push_back(RunOf(1, error));
    worse.threads.push_back(RunOf(1, error + 0.1));
    same.threads.push_back(RunOf(1, error + (i % 2 == 0 ? 0.1 : -0.1)));
  }
  own.one_thread = own.threads;
  worse.one_thread = worse.threads;
  same.one_thread = same.threads;
  bench.methods = {own, worse, same};
  const Json gaps = bench.ToJson()["gaps"][0];
  const Json less = gaps["fast"]["less"];
  EXPECT_NEAR(less["worse"]["t_mm_95"][0], -0.1, 1e-9);
  EXPECT_NEAR(less["worse"]["t_mm_95"][1], -0.1, 1e-9);
  EXPECT_LT(less["same"]["t_mm_95"][0], 0);
  EXPECT_GT(less["same"]["t_mm_95"][1], 0);
  EXPECT_FALSE(gaps["worse"].contains("less"));
  EXPECT_THAT(bench.Format(), HasSubstr("3  fast less worse: -0.100 to -0.100 mm"));
}

std::vector<BenchPair> StudioPairs() {
  return RenderBenchPairs(StudioWorld(), SmallPictures(160), 30, {2, {1, 2}});
}

TEST(TrackBench, RendersPairsSoFarApart) {
  const std::vector<BenchPair> pairs = StudioPairs();
  ASSERT_EQ(pairs.size(), 4u);
  EXPECT_EQ(pairs[1].gap, 2);
  EXPECT_EQ(pairs[0].frames.reference.time_s, pairs[1].frames.reference.time_s);
  EXPECT_NEAR(pairs[1].frames.current.time_s - pairs[0].frames.current.time_s, 1.0 / 30, 1e-12);
  EXPECT_THROW(RenderBenchPairs(StudioWorld(), SmallPictures(160), 30, {1, {100000}}), Error);
}

TEST(TrackBench, MeasuresEveryMethodOnEveryPair) {
  const std::vector<BenchPair> pairs = StudioPairs();
  const TrackBench bench = MeasureTracking(pairs, {"cpu", 1, 2});
  ASSERT_GE(bench.methods.size(), 2u);
  for (const MethodRuns& method : bench.methods) {
    ASSERT_EQ(method.threads.size(), pairs.size()) << method.name;
    ASSERT_EQ(method.one_thread.size(), pairs.size()) << method.name;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PairRun &one = method.one_thread[i], &two = method.threads[i];
      EXPECT_GT(two.milliseconds, 0);
      EXPECT_EQ(one.t_mm, two.t_mm) << method.name;
      if (!method.has_stages) continue;
      EXPECT_TRUE(two.found);
      const SE3d& truth = pairs[i].frames.current_from_reference;
      EXPECT_LT(two.t_mm, 100 * Difference(truth, {}).distance_m) << method.name;  // a tenth
      EXPECT_GT(two.pixel_iterations, 0);
      EXPECT_GT(two.milliseconds, two.keyframe_ms + 0.99 * two.stages.total_ms);
    }
  }
  EXPECT_GT(bench.fused_pass.photometric_ms, 0);
  EXPECT_GT(bench.fused_pass.robust_depth_ms, bench.fused_pass.photometric_ms);
}

TEST(OpenCvOdometry, FindsASmallMotion) {
  const std::optional<OpenCvOdometry> odometry = OpenCvOdometry::Load();
  if (!odometry) GTEST_SKIP() << "no OpenCV with rgbd here";
  FramePair pair = RenderBenchPairs(StudioWorld(), SmallPictures(320), 30, {1, {2}})[0].frames;
  const PoseDifference motion = Difference(pair.current_from_reference, {});
  for (const auto kind : {OpenCvOdometry::Kind::kRgbd, OpenCvOdometry::Kind::kRgbdIcp}) {
    const OdometryRun run = odometry->Run(pair, kind);
    ASSERT_TRUE(run.found);
    EXPECT_GT(run.milliseconds, 0);
    EXPECT_LT(Difference(run.current_from_reference, pair.current_from_reference).distance_m,
              motion.distance_m);
  }
  pair.current.depth_m = {};
  EXPECT_THROW(odometry->Run(pair, OpenCvOdometry::Kind::kRgbd), Error);
}

// Two frames on disk, in TUM's layout.
class TrackBenchFiles : public testing::Test {
 protected:
  void SetUp() override {
    const FramePair pair = StudioPairs()[0].frames;
    std::filesystem::create_directories(folder_ / "s/rgb");
    std::filesystem::create_directories(folder_ / "s/depth");
    Write("s/rgb/1.0.png", "s/depth/1.0.png", pair.reference);
    Write("s/rgb/1.1.png", "s/depth/1.1.png", pair.current);
    std::ofstream(folder_ / "s/associations.txt") << "1.0 rgb/1.0.png 1.0 depth/1.0.png\n"
                                                     "1.1 rgb/1.1.png 1.1 depth/1.1.png\n";
    std::ofstream(folder_ / "s/pairs.txt")
        << "rgb/1.0.png depth/1.0.png rgb/1.1.png depth/1.1.png\n";
    truth_ = {{1.0, pair.current_from_reference}, {1.1, SE3d{}}};
    WriteTumTrajectory(folder_ / "s/groundtruth.txt", truth_);
    camera_ = pair.camera;
    camera_.width = camera_.height = 0;
  }

  void Write(const std::string& rgb, const std::string& depth, const Frame& frame) {
    WriteRgb(folder_ / rgb, frame.rgb);
    WriteDepth(folder_ / depth, frame.depth_m);
  }

  // The motion between the two, in a folder whose poses have ICL-NUIM's axes.
  void MirrorTruth() {
    for (StampedPose& pose : truth_) pose.world_from_camera = IclFromSilt(pose.world_from_camera);
    WriteTumTrajectory(folder_ / "s/groundtruth.txt", truth_);
    camera_.fy = -camera_.fy;
  }

  void ExpectTruth(const std::vector<BenchPair>& pairs) const {
    ASSERT_EQ(pairs.size(), 1u);
    const FramePair& pair = pairs[0].frames;
    const SE3d truth = StudioPairs()[0].frames.current_from_reference;
    EXPECT_LT(Difference(pair.current_from_reference, truth).distance_m, 1e-7);
    EXPECT_LT(Difference(pair.current_from_reference, truth).angle_deg, 1e-5);
    EXPECT_GT(pair.camera.fy, 0);
    EXPECT_EQ(pair.camera.width, 160);
    EXPECT_FALSE(pair.current.depth_m.empty());
    EXPECT_GT(pairs[0].load_ms, 0);
  }

  TestFolder folder_;
  Trajectory truth_;
  PinholeCamera camera_;
};

TEST_F(TrackBenchFiles, AFolderGivesPairs) {
  ExpectTruth(FolderBenchPairs(folder_ / "s", camera_, 5000, {5, {1, 9}}));
  EXPECT_THROW(FolderBenchPairs(folder_ / "s", camera_, 5000, {5, {9}}), Error);
  MirrorTruth();
  ExpectTruth(FolderBenchPairs(folder_ / "s", camera_, 5000, {5, {1}}));
}

TEST_F(TrackBenchFiles, AListGivesPairs) {
  const auto list = folder_ / "s/pairs.txt", truth = folder_ / "s/groundtruth.txt";
  ExpectTruth(ListedBenchPairs(list, truth, camera_, 5000));
  MirrorTruth();
  ExpectTruth(ListedBenchPairs(list, truth, camera_, 5000));
}

TEST_F(TrackBenchFiles, AListWithoutPosesOrTimesIsRefused) {
  const auto list = folder_ / "s/pairs.txt", truth = folder_ / "s/groundtruth.txt";
  WriteTumTrajectory(truth, {{5, {}}, {6, {}}});
  EXPECT_THROW(ListedBenchPairs(list, truth, camera_, 5000), Error);
  std::filesystem::rename(folder_ / "s/rgb/1.1.png", folder_ / "s/rgb/second.png");
  std::ofstream(list) << "rgb/1.0.png depth/1.0.png rgb/second.png depth/1.1.png\n";
  EXPECT_THROW(ListedBenchPairs(list, truth, camera_, 5000), Error);
}

TEST_F(TrackBenchFiles, TheCommandMeasuresThem) {
  const std::string camera = " --camera " + std::to_string(camera_.fx) + " " +
                             std::to_string(camera_.fy) + " " + std::to_string(camera_.cx) + " " +
                             std::to_string(camera_.cy) + " --repeats 1 --json -";
  const std::string folder = (folder_ / "s").string();
  for (const std::string& source :
       {" --folder " + folder + " --gaps 1",
        " --pairs " + folder + "/pairs.txt --truth " + folder + "/groundtruth.txt"}) {
    const ProgramResult result = RunSilt("bench track" + source + camera);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const Json json = Json::parse(result.out);
    EXPECT_LT(json["pairs"]["fast"]["t_mm"], 5) << source;
    EXPECT_GT(json["stages_ms"]["accurate"]["one_thread"]["load"], 0);
    EXPECT_THAT(json["manifest"]["command"], HasSubstr("bench track"));
  }
  const ProgramResult refused = RunSilt("bench track --pairs " + folder + "/pairs.txt" + camera);
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.error, HasSubstr("--truth"));
}

TEST(TrackBench, TheCommandMeasuresRenderedPairs) {
  const ProgramResult result =
      RunSilt("bench track --scene studio --width 160 --instants 1 --gaps 1 --repeats 1");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("accurate"));
  EXPECT_THAT(result.out, HasSubstr("fused pass"));
}

}  // namespace
}  // namespace silt::experiments
