// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/render_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void Write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

Json Manifest(double fps = 20, const std::string& commit = "abc") {
  return {{"program", "silt"},
          {"config", {{"render", {{"fps", fps}, {"spp", 4}}}}},
          {"commit", commit}};
}

// Two frames and a list.
const RenderFiles kFiles{{"rgb/0.png", "rgb/1.png"}, {"rgb.txt"}};

class RenderFolderTest : public testing::Test {
 protected:
  // As if a process had been killed after the first frame.
  void LeaveUnfinished() const {
    fs::create_directories(out_);
    Write(out_ / "rgb/0.png", "first");
    Json manifest = Manifest();
    manifest["entries"] = {"rgb", "rgb.txt"};
    Write(out_ / "unfinished.json", manifest.dump());
  }
  void Finish() const {
    RenderFolder folder(out_, Manifest(), kFiles, false);
    folder.Begin();
    for (const char* name : {"rgb/0.png", "rgb/1.png", "rgb.txt"}) Write(out_ / name, name);
    folder.Commit();
  }
  std::string ErrorOf(const Json& manifest, bool overwrite = false) const {
    try {
      RenderFolder folder(out_, manifest, kFiles, overwrite);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  TestFolder test_;
  const fs::path out_ = test_ / "out";
};

TEST_F(RenderFolderTest, IsWholeOnlyOnceCommitted) {
  {
    RenderFolder folder(out_, Manifest(), kFiles, false);
    folder.Begin();
    EXPECT_FALSE(folder.IsWhole());
    EXPECT_TRUE(fs::exists(out_ / "unfinished.json"));
    for (const char* name : {"rgb/0.png", "rgb/1.png", "rgb.txt"}) Write(out_ / name, name);
    folder.Commit();
    EXPECT_TRUE(folder.IsWhole());
  }
  EXPECT_FALSE(fs::exists(out_ / "unfinished.json"));
  const Json manifest = Json::parse(ReadText(out_ / "manifest.json"));
  EXPECT_EQ(manifest["entries"], (Json{"rgb", "rgb.txt"}));
}

TEST_F(RenderFolderTest, WithoutAFrameNothingIsLeft) {
  { RenderFolder(out_, Manifest(), kFiles, false).Begin(); }
  EXPECT_FALSE(fs::exists(out_));
  fs::create_directory(out_);
  { RenderFolder(out_, Manifest(), kFiles, false).Begin(); }
  EXPECT_TRUE(fs::is_empty(out_));
}

TEST_F(RenderFolderTest, FramesOfAnUnfinishedRunStayAndItsPartsGo) {
  LeaveUnfinished();
  Write(out_ / "rgb/.1.part-77-0.png", "half");
  Write(out_ / ".rgb.part-77-1.txt", "half");
  {
    RenderFolder folder(out_, Manifest(), kFiles, false);
    EXPECT_FALSE(folder.IsWhole());
    folder.Begin();
  }
  EXPECT_EQ(ReadText(out_ / "rgb/0.png"), "first");
  EXPECT_FALSE(fs::exists(out_ / "rgb/.1.part-77-0.png"));
  EXPECT_FALSE(fs::exists(out_ / ".rgb.part-77-1.txt"));
}

TEST_F(RenderFolderTest, AFinishedRunThatLostAFrameIsNoLongerWhole) {
  Finish();
  EXPECT_TRUE(RenderFolder(out_, Manifest(), kFiles, false).IsWhole());
  fs::remove(out_ / "rgb/1.png");
  RenderFolder folder(out_, Manifest(), kFiles, false);
  EXPECT_FALSE(folder.IsWhole());
  folder.Begin();
  EXPECT_FALSE(fs::exists(out_ / "manifest.json"));
}

TEST_F(RenderFolderTest, AnotherConfigurationIsRefusedAndNamed) {
  LeaveUnfinished();
  EXPECT_EQ(ErrorOf(Manifest()), "no error");
  EXPECT_THAT(ErrorOf(Manifest(30)), HasSubstr("holds another render (render/fps is 20.0 there and "
                                               "30.0 here)"));
  EXPECT_THAT(ErrorOf(Manifest(20, "def")), HasSubstr("commit is \"abc\" there and \"def\" here"));
  Json more = Manifest();
  more["config"]["truth"] = true;
  EXPECT_THAT(ErrorOf(more), HasSubstr("truth is not told there and true here"));
  EXPECT_EQ(ReadText(out_ / "rgb/0.png"), "first");
}

TEST_F(RenderFolderTest, OverwriteBeginsAnew) {
  Finish();
  EXPECT_EQ(ErrorOf(Manifest(30), true), "no error");
  EXPECT_FALSE(fs::exists(out_ / "rgb"));
  EXPECT_FALSE(fs::exists(out_ / "manifest.json"));
}

TEST_F(RenderFolderTest, WhatOthersWroteIsNeverTouched) {
  Write(out_ / "thesis.tex", "years");
  EXPECT_THAT(ErrorOf(Manifest(), true), HasSubstr("holds 'thesis.tex', which silt did not write"));
  fs::remove(out_ / "thesis.tex");
  LeaveUnfinished();
  Write(out_ / "notes.txt", "days");
  EXPECT_THAT(ErrorOf(Manifest(), true), HasSubstr("holds 'notes.txt'"));
  EXPECT_EQ(ReadText(out_ / "notes.txt"), "days");
}

TEST_F(RenderFolderTest, ASecondProcessIsRefused) {
  const RenderFolder folder(out_, Manifest(), kFiles, false);
  EXPECT_THAT(ErrorOf(Manifest()), HasSubstr("another silt is rendering into it"));
}

TEST_F(RenderFolderTest, PlacesThatCannotBeAreTold) {
  Write(out_, "a file");
  EXPECT_THAT(ErrorOf(Manifest()), HasSubstr("is there and is no folder"));
  try {
    RenderFolder folder("/proc/silt/out", Manifest(), kFiles, false);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("/proc/silt/out: cannot be written: No such file"));
  }
}

}  // namespace
}  // namespace silt::experiments
