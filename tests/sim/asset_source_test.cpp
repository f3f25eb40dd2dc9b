// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/asset_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temp_folder.h"

namespace silt::sim {
namespace {

TEST(AssetPathTest, Normalizes) {
  EXPECT_EQ(NormalizedAssetPath("a\\b//c/../d.png"), "a/b/d.png");
  EXPECT_EQ(NormalizedAssetPath("./x.png \t\r"), "x.png");
  EXPECT_EQ(NormalizedAssetPath("../x.png"), "../x.png");
  EXPECT_EQ(NormalizedAssetPath("a/b/"), "a/b");
  EXPECT_EQ(NormalizedAssetPath(""), "");
  EXPECT_EQ(NormalizedAssetPath("  "), "");
}

TEST(AssetPathTest, LiesBesideItsBase) {
  EXPECT_EQ(BesideAsset("m/desk/desk.obj", "..\\wood\\oak.png"), "m/wood/oak.png");
  EXPECT_EQ(BesideAsset("desk.obj", "oak.png"), "oak.png");
  EXPECT_EQ(BesideAsset("m/desk.obj", "/abs/oak.png"), "/abs/oak.png");
  EXPECT_EQ(FolderOf("a/b/c"), "a/b");
  EXPECT_EQ(FolderOf("c"), "");
  EXPECT_EQ(LowerCase("AbC-9"), "abc-9");
}

TEST(FolderSourceTest, FindsFilesWhateverTheirCase) {
  const TempFolder folder;
  folder.Write("Models/Oak.PNG", "oak");
  const FolderSource source;
  const std::string base = folder.path().string();
  for (const char* const name : {"/Models/Oak.PNG", "/models/oak.png", "/x/../MODELS\\oak.PNG"}) {
    const auto found = source.Find(base + name);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_EQ(*source.Read(*found), "oak");
  }
  EXPECT_FALSE(source.Find(base + "/Models/elm.png").has_value());
  EXPECT_FALSE(source.Find(base + "/none/oak.png").has_value());
  EXPECT_FALSE(source.Find(base + "/Models").has_value());  // a folder is no file
  EXPECT_FALSE(source.Find("").has_value());
}

TEST(FolderSourceTest, PrefersTheExactCase) {
  const TempFolder folder;
  folder.Write("a.png", "lower");
  folder.Write("A.png", "upper");
  const FolderSource source;
  EXPECT_EQ(*source.Read(*source.Find((folder.path() / "A.png").string())), "upper");
  EXPECT_EQ(*source.Read(*source.Find((folder.path() / "a.png").string())), "lower");
}

TEST(FolderSourceTest, ReportsWhatItCannotRead) {
  EXPECT_THAT(ErrorOf([] { FolderSource().Read("/nowhere/a.png"); }),
              testing::HasSubstr("/nowhere/a.png: cannot be read"));
}

}  // namespace
}  // namespace silt::sim
