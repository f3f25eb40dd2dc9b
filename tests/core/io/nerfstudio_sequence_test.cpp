// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/nerfstudio_sequence.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "posed_image.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

// As nerfstudio does: rays ((u + ½ − cx)/fx, −(v + ½ − cy)/fy, −1) turned by transform_matrix;
// depth images in millimetres along z.
PosedImage ReadFrame(const fs::path& folder, int number) {
  const auto json = nlohmann::json::parse(ReadText(folder / "transforms.json"));
  const auto& frame = json["frames"][std::size_t(number)];
  PosedImage image;
  image.rgb = ReadRgb(folder / frame["file_path"].get<std::string>());
  image.gray = GrayFromRgb(image.rgb);
  image.depth_m = ReadDepth(folder / frame["depth_file_path"].get<std::string>(), 1000);
  image.fx = json["fl_x"];
  image.fy = -json["fl_y"].get<double>();
  image.cx = json["cx"].get<double>() - 0.5;
  image.cy = json["cy"].get<double>() - 0.5;
  image.z_sign = -1;
  const auto m = frame["transform_matrix"].get<std::vector<std::vector<double>>>();
  for (std::size_t i = 0; i < 3; ++i) image.rotation.row[i] = {m[i][0], m[i][1], m[i][2]};
  image.position = {m[0][3], m[1][3], m[2][3]};
  EXPECT_EQ(json["camera_model"], "OPENCV");
  image.lens = {json["k1"], json["k2"], json["p1"], json["p2"], json["k3"]};
  return image;
}

class NerfstudioSequence : public testing::Test {
 protected:
  void SetUp() override {
    const SequenceDescription description = BoxDescription(4);
    NerfstudioSequenceWriter writer(folder_.path(), description);
    WriteBox(writer, description);
  }
  SequenceFolder folder_;
};

TEST_F(NerfstudioSequence, PicturesAreConsistentWithOpenGlsAxes) {
  const PosedImage from = ReadFrame(folder_.path(), 0), to = ReadFrame(folder_.path(), 3);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
  EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
  EXPECT_GT(WarpError(WithDepthMistaken(from, -1), WithDepthMistaken(to, -1)), 3 * right);
}

TEST_F(NerfstudioSequence, HoldsEveryPoseColourAndDepthThatWasWritten) {
  for (const LensDistortion& lens : {LensDistortion{}, kBoxLens}) {
    const SequenceFolder folder;
    SequenceDescription description = BoxDescription(5);
    description.lens = lens;
    const std::vector<Frame> frames = ColoredFrames(description);
    NerfstudioSequenceWriter writer(folder.path(), description);
    for (std::size_t i = 0; i < frames.size(); ++i) writer.Write(int(i), frames[i]);
    writer.Finish();
    const auto json = nlohmann::json::parse(ReadText(folder / "transforms.json"));
    ASSERT_EQ(json["frames"].size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      ExpectSame(ReadFrame(folder.path(), int(i)), description, i, frames[i], 1e-3);
      EXPECT_NEAR(json["frames"][i]["time"], description.truth[i].time_s, 1e-9);
    }
  }
}

TEST_F(NerfstudioSequence, PicturesThroughALensAreConsistentWithTheModelOpencv) {
  const SequenceFolder folder;
  SequenceDescription description = BoxDescription(4);
  description.lens = kBoxLens;
  NerfstudioSequenceWriter writer(folder.path(), description);
  WriteBox(writer, description);
  const PosedImage from = ReadFrame(folder.path(), 0), to = ReadFrame(folder.path(), 3);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithoutLens(from), WithoutLens(to)), 3 * right);
}

// Half a pixel more, since the pixels' corners are whole there.
TEST_F(NerfstudioSequence, StatesTheCameraOnce) {
  const auto json = nlohmann::json::parse(ReadText(folder_ / "transforms.json"));
  EXPECT_EQ(json["camera_model"], "OPENCV");
  EXPECT_EQ(json["w"], 160);
  EXPECT_EQ(json["h"], 120);
  EXPECT_EQ(json["cx"], 80);
  EXPECT_EQ(json["cy"], 60);
  EXPECT_EQ(json["k1"], 0);
  EXPECT_EQ(json["frames"].size(), 4u);
  EXPECT_EQ(json["frames"][2]["time"], 0.2);
  EXPECT_EQ(json["frames"][2]["transform_matrix"][3], (nlohmann::json{0, 0, 0, 1}));
}

}  // namespace
}  // namespace silt
