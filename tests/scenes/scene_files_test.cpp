// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "explained_findings.h"
#include "shipped_scenes.h"
#include "silt/sim/scene.h"
#include "silt/sim/scene_check.h"

namespace silt::sim {
namespace {

using testing::Each;
using testing::Field;
using testing::Gt;
using testing::HasSubstr;

// Of one model of the furniture, two pictures are missing; they would cover four triangles.
constexpr const char* kIncompleteModel = "textMarker.obj";

class ShippedSceneTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!FurnitureIsInstalled()) GTEST_SKIP() << "sweethome3d-furniture is not installed";
  }
};

TEST_P(ShippedSceneTest, LoadsAndPassesTheCheck) {
  const Scene scene = LoadScene(ShippedFile(GetParam(), "scene.toml"));
  EXPECT_THAT(scene.warnings, Each(HasSubstr(kIncompleteModel)));
  EXPECT_THAT(scene.instances, Each(Field(&Instance::triangle_count, Gt(0u))));
  EXPECT_FALSE(scene.lights.empty());
  EXPECT_LE(scene.mesh.triangles.size(), 400'000u);
}

// What the check finds is mended, or told and explained in explained_findings.h; and what is told
// there is still found.
TEST_P(ShippedSceneTest, EveryFindingOfTheCheckIsExplained) {
  const std::vector<SceneFinding> findings =
      CheckScene(LoadScene(ShippedFile(GetParam(), "scene.toml")));
  const auto explains = [](const ExplainedFinding& known, const SceneFinding& finding) {
    return known.scene == GetParam() && known.Explains(finding.message);
  };
  for (const SceneFinding& finding : findings) {
    EXPECT_FALSE(finding.is_error) << finding.message;
    EXPECT_TRUE(std::any_of(ExplainedFindings().begin(), ExplainedFindings().end(),
                            [&](const auto& known) { return explains(known, finding); }))
        << finding.message;
  }
  for (const ExplainedFinding& known : ExplainedFindings()) {
    if (known.scene != GetParam()) continue;
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                            [&](const auto& finding) { return explains(known, finding); }))
        << known.object << ' ' << known.finding;
  }
}

// A folder says where it comes from, and shows itself in a small picture.
TEST_P(ShippedSceneTest, IsDescribed) {
  EXPECT_TRUE(std::filesystem::exists(ShippedFile(GetParam(), "README.md")));
  const std::filesystem::path picture = ShippedFile(GetParam(), "view.jpg");
  ASSERT_TRUE(std::filesystem::exists(picture));
  EXPECT_LE(std::filesystem::file_size(picture), 400'000u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSceneTest, testing::ValuesIn(ShippedScenes()),
                         [](const auto& named) { return named.param; });

std::uintmax_t BytesBelow(const std::filesystem::path& folder, const std::string& extension) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) bytes += entry.file_size();
  }
  return bytes;
}

// Whoever clones the project fetches them all.
TEST(ShippedTexturesTest, AreSmallOnDisk) {
  const std::filesystem::path textures = SILT_SOURCE_DIR "/scenes/textures";
  EXPECT_LE(BytesBelow(textures, ".jpg") + BytesBelow(textures, ".png"), 20u << 20);
}

}  // namespace
}  // namespace silt::sim
