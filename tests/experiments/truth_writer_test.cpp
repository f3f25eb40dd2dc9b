// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/truth_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "silt/core/io/image_file.h"
#include "silt/sim/imu.h"
#include "silt_program.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

// Three frames of the studio.
class TruthWriterTest : public testing::Test {
 protected:
  TruthWriter Writer(const TruthSelection& selection) const {
    return {folder_.path(), selection, StudioWorld(), renderer_, poses_};
  }
  // The float32 values that end a file.
  template <typename T>
  Image<T> Load(const std::string& name) const {
    const std::string bytes = ReadText(folder_ / ("truth/" + name));
    const PinholeCamera& camera = renderer_.options().camera;
    Image<T> image(camera.width, camera.height);
    const std::size_t size = image.size() * sizeof(T);
    EXPECT_GT(bytes.size(), size);
    std::memcpy(static_cast<void*>(image.data()), bytes.data() + bytes.size() - size, size);
    return image;
  }

  TestFolder folder_;
  const sim::Renderer renderer_{StudioWorld().scene, SmallPictures(64)};
  const Trajectory poses_ = StudioWorld().path.Sample(10, 0.5, 0.3);
};

TEST_F(TruthWriterTest, FilesAreThoseThatWereAnnounced) {
  TruthSelection all;
  all.sharp = all.depth = all.normals = all.ids = all.flow = all.imu = all.poses = true;
  const TruthWriter writer = Writer(all);
  const ImuRecording imu = sim::RecordImu(StudioWorld().path, {}, 0.5, 0.3);
  std::vector<fs::path> announced = writer.SequenceFiles(), found;
  for (int number = 0; number < 3; ++number) {
    writer.Write(number, number);
    for (const fs::path& file : writer.FrameFiles(number)) announced.push_back(file);
  }
  writer.Finish(imu, 0.8);
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
    if (entry.is_regular_file()) found.push_back(fs::relative(entry.path(), folder_.path()));
  }
  std::sort(announced.begin(), announced.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(announced, found);
  // The first has no frame before it and the last none after it.
  EXPECT_EQ(writer.FrameFiles(0).size(), 9u);
  EXPECT_EQ(writer.FrameFiles(1).size(), 11u);
  EXPECT_EQ(writer.FrameFiles(2).size(), 9u);
}

// Of a blurred and noisy sequence, the sharp picture is that of a camera without either.
TEST_F(TruthWriterTest, TheSharpPictureHasNeitherBlurNorNoise) {
  sim::RenderOptions options = SmallPictures(64);
  const double time_s = poses_[1].time_s;
  const Image<Rgb8> perfect =
      sim::Renderer(StudioWorld().scene, options).Render(StudioWorld().Pose(), time_s, 1).rgb;
  options.shutter = {.exposure_s = 0.1, .time_samples = 8};
  options.sensor.noise = sim::HandaNoise{};
  const sim::Renderer shaky(StudioWorld().scene, options);
  TruthSelection selection;
  selection.sharp = true;
  const TruthWriter writer(folder_.path(), selection, StudioWorld(), shaky, poses_);
  writer.Write(1, 1);
  EXPECT_EQ(ReadRgb(folder_ / "truth/sharp/000001.png"), perfect);
  EXPECT_FALSE(shaky.Render(StudioWorld().Pose(), time_s, 1).rgb == perfect);
}

// Blur darkens no picture: metered frame by frame, the sharp one is exposed as its frame was.
TEST_F(TruthWriterTest, TheSharpPictureHasTheExposureOfItsFrame) {
  const double time_s = poses_[1].time_s;
  sim::RenderOptions options = SmallPictures(64);
  options.exposure.kind = sim::Exposure::Kind::kPerFrame;
  options.shutter = {.exposure_s = 0.5, .time_samples = 8};
  const sim::Renderer blurred(StudioWorld().scene, options);
  TruthSelection selection;
  selection.sharp = true;
  TruthWriter(folder_.path(), selection, StudioWorld(), blurred, poses_).Write(1, 7);
  const Image<Vec3f> sharp = blurred.RenderSharp(StudioWorld().Pose(), time_s, 7);
  const Image<Vec3f> linear = blurred.RenderLinear(StudioWorld().Pose(), time_s, 7);
  const auto developed = [&](const Image<Vec3f>& metered) {
    options.exposure = {sim::Exposure::Kind::kGiven, sim::MeteredExposure({metered})};
    return sim::Renderer(StudioWorld().scene, options).Develop(sharp, {});
  };
  const Image<Rgb8> written = ReadRgb(folder_ / "truth/sharp/000001.png");
  EXPECT_EQ(written, developed(linear));
  EXPECT_FALSE(written == developed(sharp));
}

// In the world the floor's normals point up, from whichever frame they are seen.
TEST_F(TruthWriterTest, NormalsAreUnitTowardsTheCameraAndUprightInTheWorld) {
  TruthSelection selection;
  selection.normals = selection.depth = true;
  Writer(selection).Write(1, 1);
  const auto camera = Load<Vec3f>("normal_camera/000001.npy");
  const auto world = Load<Vec3f>("normal_world/000001.npy");
  const auto depth_m = Load<float>("depth_z/000001.npy");
  const SE3d& pose = poses_[1].world_from_camera;
  const PinholeCamera& pinhole = renderer_.options().camera;
  int floor = 0;
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      if (depth_m(x, y) == 0) continue;
      const Vec3d ray = pinhole.Unproject(double(x), double(y), 1.0);
      const Vec3d n = camera(x, y).Cast<double>();
      EXPECT_NEAR(Norm(n), 1, 1e-6);
      EXPECT_LT(Dot(n, ray), 0);
      EXPECT_LT(Norm(pose.rotation * n - world(x, y).Cast<double>()), 1e-6);
      const Vec3d point = pose * (double(depth_m(x, y)) * ray);
      if (std::abs(point.z) > 1e-5) continue;
      EXPECT_NEAR(world(x, y).z, 1, 1e-5);
      ++floor;
    }
  }
  EXPECT_GT(floor, 50);
}

// Forward of one frame and backward of the next belong to the pairs that their names tell.
TEST_F(TruthWriterTest, FlowIsToTheNextAndThePreviousFrame) {
  TruthSelection selection;
  selection.flow = true;
  Writer(selection).Write(1, 1);
  const Image<float> depth_m = renderer_.RenderDepth(poses_[1].world_from_camera);
  const sim::OpticalFlow flow(StudioWorld().scene->tracer(), renderer_.options().camera);
  for (const int other : {0, 2}) {
    const std::string way = other == 0 ? "backward" : "forward";
    const sim::FlowField expected = flow.Between(depth_m, poses_[1].world_from_camera,
                                                 poses_[std::size_t(other)].world_from_camera);
    const auto written = Load<Vec2f>("flow_" + way + "/000001.flo");
    for (std::size_t i = 0; i < written.size(); ++i) {
      ASSERT_EQ(written.data()[i].x, expected.flow_px.data()[i].x);
      ASSERT_EQ(written.data()[i].y, expected.flow_px.data()[i].y);
    }
    EXPECT_EQ(ReadGray8(folder_ / ("truth/occlusion_" + way + "/000001.png")), expected.state);
  }
}

TEST_F(TruthWriterTest, ImuIsAListOfThirteenColumns) {
  TruthSelection selection;
  selection.imu = true;
  sim::ImuOptions options;
  options.noise = ImuNoise::Euroc();
  const ImuRecording imu = sim::RecordImu(StudioWorld().path, options, 0.5, 0.3);
  Writer(selection).Finish(imu, 0.8);
  const std::string text = ReadText(folder_ / "truth/imu.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 62);
  double v[13];
  const char* at = text.c_str() + text.find('\n') + 1;
  for (double& value : v) {
    char* end = nullptr;
    value = std::strtod(at, &end);
    at = end + 1;
  }
  const ImuSample& first = imu.samples.front();
  EXPECT_EQ(v[0], 0.5);
  EXPECT_NEAR(v[1], first.angular_velocity.x, 1e-11);
  EXPECT_NEAR(v[6], first.acceleration.z, 1e-10);
  EXPECT_NEAR(v[12], first.truth.accelerometer_bias.z, 1e-11);
}

}  // namespace
}  // namespace silt::experiments
