// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/resources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "silt/core/error.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

// A folder of scenes of the test's own, in SILT_SCENES.
class Resources : public testing::Test {
 protected:
  void SetUp() override {
    Add("attic/scene.toml");
    Add("attic/walk.toml");
    Add("cellar/scene.toml");
    Add("cellar/desk.toml");
    Add("cellar/tour.toml");
    setenv("SILT_SCENES", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("SILT_SCENES"); }

  void Add(const std::string& file) {
    std::filesystem::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << "";
  }

  template <typename Call>
  static std::string Said(const Call& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  TestFolder folder_;
};

TEST_F(Resources, ScenesAreFoundByNameInTheEnvironmentsFolderAndTheSources) {
  EXPECT_EQ(SceneFile("attic"), folder_ / "attic/scene.toml");
  EXPECT_EQ(SceneFile("studio"),
            std::filesystem::path(SILT_SOURCE_DIR) / "scenes/studio/scene.toml");
  EXPECT_THAT(SceneNames(), AllOf(Contains("attic"), Contains("cellar"), Contains("studio")));
}

TEST_F(Resources, AnUnknownSceneListsThoseThereAre) {
  EXPECT_THAT(Said([] { SceneFile("palace"); }),
              AllOf(HasSubstr("'palace'"), HasSubstr("attic, cellar"), HasSubstr("studio")));
}

TEST_F(Resources, PathsAreTakenAsTheyAre) {
  EXPECT_EQ(SceneFile((folder_ / "attic").string()), folder_ / "attic/scene.toml");
  EXPECT_EQ(SceneFile((folder_ / "attic/scene.toml").string()), folder_ / "attic/scene.toml");
  EXPECT_THAT(Said([] { SceneFile("./none.toml"); }), HasSubstr("./none.toml"));
}

TEST_F(Resources, ATrajectoryIsFoundBesideItsScene) {
  const auto cellar = SceneFile("cellar"), attic = SceneFile("attic");
  EXPECT_EQ(PathFile(cellar, "tour"), folder_ / "cellar/tour.toml");
  EXPECT_EQ(PathFile(cellar, ""), folder_ / "cellar/desk.toml");  // the usual one
  EXPECT_EQ(PathFile(attic, ""), folder_ / "attic/walk.toml");    // the only one
  EXPECT_EQ(PathFile(attic, (folder_ / "cellar/tour.toml").string()), folder_ / "cellar/tour.toml");
}

TEST_F(Resources, AnUnknownTrajectoryListsThoseThereAre) {
  const auto cellar = SceneFile("cellar");
  EXPECT_THAT(Said([&] { PathFile(cellar, "loop"); }),
              AllOf(HasSubstr("'loop'"), HasSubstr("desk, tour")));
  EXPECT_THAT(Said([&] { PathFile(cellar, "scene"); }), HasSubstr("'scene'"));
  EXPECT_THAT(Said([&] { PathFile(cellar, "./x.toml"); }), HasSubstr("./x.toml"));
}

TEST_F(Resources, TheFiguresScriptIsThere) {
  EXPECT_TRUE(std::filesystem::exists(FigureScript("accuracy.py")));
  EXPECT_THAT(Said([] { FigureScript("none.py"); }), HasSubstr("none.py"));
}

}  // namespace
}  // namespace silt::experiments
