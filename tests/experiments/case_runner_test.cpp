// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/case_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/experiments/tracker_options.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

// Small pictures of the studio: what matters here is which are made.
class CaseRunner : public testing::Test {
 protected:
  CaseRunner() : world_(LoadWorld("studio", "")) {
    plan_.options.camera = IclNuimCameraOfWidth(64);
    plan_.options.samples_per_pixel = 1;
    plan_.stretch = {60, 0, 0.1};
  }

  std::vector<RenderedFrame> Frames() const {
    std::vector<RenderedFrame> frames;
    ForEachFrame(world_, plan_, [&](const RenderedFrame& frame) { frames.push_back(frame); });
    return frames;
  }

  World world_;
  RenderPlan plan_;
};

TEST_F(CaseRunner, GivesEveryFrameOfTheStretchWithItsTruth) {
  const std::vector<RenderedFrame> frames = Frames();
  ASSERT_EQ(frames.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(frames[i].number, i);
    EXPECT_EQ(frames[i].frame.time_s, i / 60.0);
    const SE3d truth = world_.path.WorldFromCamera(i / 60.0);
    EXPECT_EQ(Norm(frames[i].truth.world_from_camera.translation - truth.translation), 0);
  }
}

// What ForEachFrame puts together itself must be what the renderer makes.
TEST_F(CaseRunner, FramesAreTheRenderers) {
  plan_.options.sensor.noise = sim::HandaNoise{};
  plan_.options.seed = 5;
  const sim::Renderer renderer(world_.scene, plan_.options);
  for (const RenderedFrame& rendered : Frames()) {
    const Frame frame = renderer.Render(world_.Pose(), rendered.truth.time_s, rendered.number);
    EXPECT_EQ(rendered.frame.rgb, frame.rgb);
    EXPECT_EQ(rendered.frame.depth_m, frame.depth_m);
  }
}

TEST_F(CaseRunner, AStretchIsPartOfTheWhole) {
  plan_.options.sensor.noise = sim::HandaNoise{};
  const std::vector<RenderedFrame> whole = Frames();
  plan_.stretch = {60, 0.05, 0.05};
  const std::vector<RenderedFrame> part = Frames();
  ASSERT_EQ(part.size(), 3u);
  EXPECT_EQ(part[0].number, 0);
  EXPECT_EQ(part[1].frame.rgb, whole[4].frame.rgb);
}

TEST_F(CaseRunner, EachSeedGetsANoiseOfItsOwnAndTheSameDepth) {
  plan_.options.sensor.noise = sim::HandaNoise{};
  plan_.noise_seeds = {3, 4};
  const std::vector<RenderedFrame> frames = Frames();
  ASSERT_EQ(frames.size(), 12u);
  EXPECT_EQ(frames[0].number, frames[1].number);
  EXPECT_EQ(frames[0].seed, 3u);
  EXPECT_EQ(frames[1].seed, 4u);
  EXPECT_NE(frames[0].frame.rgb, frames[1].frame.rgb);
  EXPECT_EQ(frames[0].frame.depth_m, frames[1].frame.depth_m);
  // A seed's noise does not depend on the others asked for.
  plan_.noise_seeds = {4};
  EXPECT_EQ(Frames()[2].frame.rgb, frames[5].frame.rgb);
}

TEST_F(CaseRunner, AStretchBeyondThePathIsRefused) {
  const double duration_s = world_.path.duration_s();
  EXPECT_THROW(TruePoses(world_, {60, duration_s + 1, 0}), Error);
  EXPECT_THROW(TruePoses(world_, {60, 0, duration_s + 1}), Error);
  EXPECT_THROW(TruePoses(world_, {60, 0.001, 0.001}), Error);  // no frame falls into it
  EXPECT_NO_THROW(TruePoses(world_, {60, 0, 0}));
}

TEST(IclNuimCamera, OfHalfTheWidthSeesTheSame) {
  const PinholeCamera half = IclNuimCameraOfWidth(320), halved = kIclNuimCamera.Halved();
  EXPECT_EQ(half.width, 320);
  EXPECT_EQ(half.height, 240);
  EXPECT_DOUBLE_EQ(half.fx, halved.fx);
  EXPECT_DOUBLE_EQ(half.cx, halved.cx);
  EXPECT_DOUBLE_EQ(half.cy, halved.cy);
}

TEST(TrackerSetup, UnknownNamesListTheKnown) {
  const auto said = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using testing::HasSubstr;
  EXPECT_THAT(said([] { PresetOptions("best"); }), HasSubstr("'best'; there are: paper"));
  EXPECT_THAT(said([] { MakeBackend("gpu"); }), HasSubstr("cpu, cpu-sse2"));
}

// There is no silent way back to the processor.
TEST(TrackerSetup, CudaAskedForAndMissingIsAnError) {
  try {
    MakeBackend("cuda");
    GTEST_SKIP() << "this build has a CUDA tracker and a device";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--backend c"));
  }
}

}  // namespace
}  // namespace silt::experiments
