// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/euroc_sequence_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "posed_image.h"
#include "silt/core/error.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using Rows = std::vector<std::vector<std::string>>;

// The cells of a CSV file below its line of names.
Rows ReadRows(const fs::path& file) {
  std::ifstream in(file);
  Rows rows;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

// As a visual-inertial odometry would: the image by its name, the state at its time.
PosedImage ReadFrame(const fs::path& folder, std::size_t number) {
  const Rows images = ReadRows(folder / "mav0/cam0/data.csv");
  const std::vector<std::string>& row = images.at(number);
  PosedImage image;
  const Image<std::uint8_t> gray = ReadGray8(folder / "mav0/cam0/data" / row.at(1));
  image.gray = Image<float>(gray.width(), gray.height());
  for (std::size_t i = 0; i < gray.size(); ++i) {
    image.gray.data()[i] = float(gray.data()[i]) / 255;
  }
  image.depth_m = ReadDepth(folder / "mav0/depth0/data" / row.at(1));
  const std::string yaml = ReadText(folder / "mav0/cam0/sensor.yaml");
  std::sscanf(yaml.c_str() + yaml.find("intrinsics:"), "intrinsics: [%lf, %lf, %lf, %lf]",
              &image.fx, &image.fy, &image.cx, &image.cy);
  for (const auto& state : ReadRows(folder / "mav0/state_groundtruth_estimate0/data.csv")) {
    if (state.at(0) != row.at(0)) continue;
    double v[8];
    for (std::size_t i = 1; i < 8; ++i) v[i] = std::stod(state.at(i));
    image.position = {v[1], v[2], v[3]};
    image.rotation = Quaterniond{v[4], v[5], v[6], v[7]}.Matrix();
  }
  return image;
}

// Readings at 20 Hz about the frames of BoxDescription.
ImuRecording SomeReadings() {
  ImuRecording imu{20, ImuNoise::Euroc(), {}};
  for (int k = 0; k <= 6; ++k) {
    const double x = 0.01 * k;
    imu.samples.push_back({k / 20.0,
                           {x, 2 * x, 3 * x},
                           {4 * x, 5 * x, 9.81},
                           {{{}, {x, 0, 0}}, {1, 2, x}, {0.1, 0.2, x}, {0.3, 0.4, x}}});
  }
  return imu;
}

TEST(EurocSequenceWriter, PicturesAreConsistentWithStatesAndIntrinsics) {
  const SequenceFolder folder;
  const SequenceDescription description = BoxDescription(4);
  EurocSequenceWriter writer(folder.path(), description);
  WriteBox(writer, description);
  const PosedImage from = ReadFrame(folder.path(), 0), to = ReadFrame(folder.path(), 3);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
  EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
  EXPECT_GT(WarpError(WithDepthMistaken(from, -1), WithDepthMistaken(to, -1)), 3 * right);
}

TEST(EurocSequenceWriter, TimesAreNanosecondsOfNineteenDigits) {
  const SequenceFolder folder;
  const SequenceDescription description = BoxDescription(2);
  EurocSequenceWriter writer(folder.path(), description);
  WriteBox(writer, description);
  const Rows images = ReadRows(folder / "mav0/cam0/data.csv");
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[1], (std::vector<std::string>{"100000000", "0000000000100000000.png"}));
  EXPECT_EQ(writer.FrameFiles(1)[0], "mav0/cam0/data/0000000000100000000.png");
  EXPECT_FALSE(fs::exists(folder / "mav0/imu0"));
  EXPECT_THAT(ReadText(folder / "mav0/cam0/sensor.yaml"), HasSubstr("rate_hz: 10\n"));
  EXPECT_THAT(ReadText(folder / "mav0/cam0/sensor.yaml"), HasSubstr("resolution: [160, 120]"));
}

TEST(EurocSequenceWriter, WithoutAnImuVelocitiesAreDifferences) {
  const SequenceFolder folder;
  const SequenceDescription description = BoxDescription(3);
  EurocSequenceWriter writer(folder.path(), description);
  writer.Finish();
  const Rows states = ReadRows(folder / "mav0/state_groundtruth_estimate0/data.csv");
  ASSERT_EQ(states.size(), 3u);
  for (const auto& state : states) {
    ASSERT_EQ(state.size(), 17u);
    EXPECT_NEAR(std::stod(state[8]), 1, 1e-8);
    EXPECT_NEAR(std::stod(state[9]), 0.7, 1e-8);
    EXPECT_NEAR(std::stod(state[10]), -0.5, 1e-8);
  }
}

TEST(EurocSequenceWriter, HoldsTheReadingsAndTheTruthAboutThem) {
  const SequenceFolder folder;
  SequenceDescription description = BoxDescription(2);
  description.imu = SomeReadings();
  EurocSequenceWriter writer(folder.path(), description);
  WriteBox(writer, description);
  const Rows readings = ReadRows(folder / "mav0/imu0/data.csv");
  ASSERT_EQ(readings.size(), 7u);
  EXPECT_EQ(readings[3], (std::vector<std::string>{"150000000", "0.03", "0.06", "0.09", "0.12",
                                                   "0.15", "9.81"}));
  const Rows states = ReadRows(folder / "mav0/state_groundtruth_estimate0/data.csv");
  ASSERT_EQ(states.size(), 7u);
  const double expected[17] = {150000000, 0.03, 0,   0,   1,    0,   0,   0,   1,
                               2,         0.03, 0.1, 0.2, 0.03, 0.3, 0.4, 0.03};
  for (std::size_t i = 0; i < 17; ++i) EXPECT_EQ(std::stod(states[3].at(i)), expected[i]) << i;
  const std::string yaml = ReadText(folder / "mav0/imu0/sensor.yaml");
  EXPECT_THAT(yaml, HasSubstr("rate_hz: 20\n"));
  EXPECT_THAT(yaml, HasSubstr("gyroscope_noise_density: 0.00016968"));
  EXPECT_THAT(yaml, HasSubstr("accelerometer_random_walk: 0.003"));
}

TEST(EurocSequenceWriter, RefusesTimesBeforeZero) {
  SequenceDescription description = BoxDescription(1);
  description.truth[0].time_s = -1;
  EXPECT_THROW(EurocSequenceWriter("nowhere", description), Error);
}

}  // namespace
}  // namespace silt
