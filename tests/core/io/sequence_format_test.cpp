// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/sequence_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "posed_image.h"
#include "silt/core/error.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class EachFormat : public testing::TestWithParam<std::string> {
 protected:
  // The box in GetParam()'s layout.
  void Write() {
    const auto writer = MakeSequenceWriter(GetParam(), folder_.path(), description_);
    WriteBox(*writer, description_);
  }
  SequenceFolder folder_;
  const SequenceDescription description_ = BoxDescription(4);
};

TEST_P(EachFormat, FramesAreThereOnceWritten) {
  const auto writer = MakeSequenceWriter(GetParam(), folder_.path(), description_);
  EXPECT_FALSE(HasFrame(folder_.path(), *writer, 2));
  writer->Write(2, BoxFrames(description_)[2]);
  EXPECT_TRUE(HasFrame(folder_.path(), *writer, 2));
  EXPECT_FALSE(HasFrame(folder_.path(), *writer, 1));
  for (const fs::path& file : writer->FrameFiles(2)) {
    fs::rename(folder_ / file, folder_ / "away");
    EXPECT_FALSE(HasFrame(folder_.path(), *writer, 2)) << file;
    fs::rename(folder_ / "away", folder_ / file);
  }
  EXPECT_TRUE(HasFrame(folder_.path(), *writer, 2));
}

TEST_P(EachFormat, TwoWritingsAreTheSameBytes) {
  Write();
  SequenceFolder other;
  const auto writer = MakeSequenceWriter(GetParam(), other.path(), description_);
  WriteBox(*writer, description_);
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = fs::relative(entry.path(), folder_.path());
    EXPECT_EQ(ReadText(entry.path()), ReadText(other / name)) << name;
    ++files;
  }
  EXPECT_GE(files, 5);
}

INSTANTIATE_TEST_SUITE_P(Formats, EachFormat, testing::ValuesIn(SequenceFormats()),
                         [](const auto& param) { return param.param; });

class EachReadableFormat : public EachFormat {};

TEST_P(EachReadableFormat, IsRecognisedAndReadBack) {
  Write();
  const auto sequence = OpenSequence("auto", folder_.path());
  ASSERT_EQ(sequence->size(), 4);
  const std::vector<double> times = sequence->times_s();
  for (std::size_t i = 0; i < 4; ++i) {
    const StampedPose& truth = description_.truth[i];
    const Frame expected = BoxFrame(truth.world_from_camera, truth.time_s);
    const std::optional<Frame> frame = sequence->Next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(times[i], truth.time_s, 1e-9);
    EXPECT_NEAR(frame->time_s, truth.time_s, 1e-9);
    EXPECT_EQ(frame->rgb, expected.rgb);
    EXPECT_NEAR(frame->depth_m(11, 99), expected.depth_m(11, 99), 1.01e-4);
    const SE3d gap = sequence->truth()[i].world_from_camera.Inverse() * truth.world_from_camera;
    EXPECT_LT(Norm(gap.translation) + RotationAngle(gap.rotation), 1e-7);
  }
  EXPECT_FALSE(sequence->Next());
}

TEST_P(EachReadableFormat, CanBeThinned) {
  Write();
  const auto sequence = OpenSequence(GetParam(), folder_.path(), {.camera = {}, .take_every = 3});
  ASSERT_EQ(sequence->size(), 2);
  ASSERT_EQ(sequence->times_s().size(), 2u);
  EXPECT_NEAR(sequence->times_s()[1], 0.3, 1e-9);
  sequence->Next();
  EXPECT_NEAR(sequence->Next()->time_s, 0.3, 1e-9);
  EXPECT_FALSE(sequence->Next());
}

INSTANTIATE_TEST_SUITE_P(Formats, EachReadableFormat, testing::ValuesIn(ReadableFormats()),
                         [](const auto& param) { return param.param; });

std::string ErrorOf(const std::string& format, const fs::path& folder,
                    const ReadingOptions& options = {}) {
  try {
    OpenSequence(format, folder, options);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(SequenceFormat, WhatIsNoneIsRefused) {
  const SequenceFolder folder;
  EXPECT_THAT(ErrorOf("auto", folder.path()), HasSubstr("holds no sequence that silt knows"));
  EXPECT_THAT(ErrorOf("auto", folder / "nowhere"), HasSubstr("nowhere: no such sequence folder"));
  EXPECT_THAT(ErrorOf("colmap", folder.path()), HasSubstr("'colmap': is none that can be read"));
  EXPECT_THROW(MakeSequenceWriter("bag", folder.path(), BoxDescription(1)), Error);
}

TEST(SequenceFormat, OnlyTumsCameraCanBeReplaced) {
  const SequenceFolder folder;
  const SequenceDescription description = BoxDescription(1);
  const auto writer = MakeSequenceWriter("raw", folder.path(), description);
  WriteBox(*writer, description);
  EXPECT_THAT(ErrorOf("auto", folder.path(), {.camera = kBoxCamera}),
              HasSubstr("a camera can be given for a tum folder alone; this is raw"));
}

TEST(SequenceFormat, OnlyTumsListsHaveATolerance) {
  const SequenceFolder raw, tum;
  const SequenceDescription description = BoxDescription(2);
  WriteBox(*MakeSequenceWriter("raw", raw.path(), description), description);
  EXPECT_THAT(ErrorOf("auto", raw.path(), {.camera = {}, .association_tolerance_s = 0.1}),
              HasSubstr("a tolerance can be given for a tum folder alone"));
  WriteBox(*MakeSequenceWriter("tum", tum.path(), description), description);
  fs::remove(tum / "associations.txt");
  std::ofstream(tum / "depth.txt") << "0.04 depth/000000.png\n0.14 depth/000001.png\n";
  const auto has_depth = [&](double tolerance_s) {
    return !OpenSequence("tum", tum.path(), {.camera = {}, .association_tolerance_s = tolerance_s})
                ->Next()
                ->depth_m.empty();
  };
  EXPECT_TRUE(has_depth(0.05));
  EXPECT_FALSE(has_depth(0.03));
}

TEST(SequenceFormat, ALensIsRefusedWhereItHasNoPlace) {
  SequenceDescription description = BoxDescription(1);
  description.lens.k1 = -0.1;
  for (const char* format : {"icl", "raw"}) {
    EXPECT_THROW(MakeSequenceWriter(format, "nowhere", description), Error) << format;
  }
  for (const char* format : {"tum", "euroc", "nerfstudio", "colmap"}) {
    EXPECT_NO_THROW(MakeSequenceWriter(format, "nowhere", description)) << format;
  }
  description.lens.k3 = 0.1;
  EXPECT_THROW(MakeSequenceWriter("euroc", "nowhere", description), Error);
}

// ICL-NUIM's frames in TUM's layout: poses in its own axes, to be read with fy = −480.
TEST(SequenceFormat, TumWithANegativeFyIsIclNuims) {
  const SequenceFolder icl, tum;
  const SequenceDescription description = BoxDescription(2);
  const auto writer = MakeSequenceWriter("icl", icl.path(), description);
  WriteBox(*writer, description);
  const auto images = MakeSequenceWriter("tum", tum.path(), description);
  WriteBox(*images, description);
  fs::copy_file(icl / "scene.gt.freiburg", tum / "groundtruth.txt",
                fs::copy_options::overwrite_existing);
  PinholeCamera camera = kBoxCamera;
  camera.fy = -camera.fy;
  const auto sequence = OpenSequence("tum", tum.path(), {.camera = camera});
  EXPECT_EQ(sequence->camera().fy, kBoxCamera.fy);
  const SE3d gap =
      sequence->truth()[1].world_from_camera.Inverse() * description.truth[1].world_from_camera;
  EXPECT_LT(Norm(gap.translation) + RotationAngle(gap.rotation), 1e-7);
}

}  // namespace
}  // namespace silt
