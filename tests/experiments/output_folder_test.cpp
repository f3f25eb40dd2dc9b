// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

const Json kManifest{{"program", "silt"}};

void Write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

int EntryCount(const std::filesystem::path& folder) {
  return int(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(OutputFolder, AppearsOnlyWithCommit) {
  const TestFolder test;
  {
    OutputFolder folder(test / "out");
    Write(folder.path() / "a.txt", "a");
    EXPECT_FALSE(std::filesystem::exists(test / "out"));
    folder.Commit(kManifest);
  }
  EXPECT_EQ(ReadText(test / "out" / "a.txt"), "a");
  EXPECT_EQ(EntryCount(test.path()), 1);
  const Json manifest = Json::parse(ReadText(test / "out" / "manifest.json"));
  EXPECT_EQ(manifest["entries"], (Json{"a.txt", "manifest.json"}));
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
  const TestFolder test;
  {
    OutputFolder folder(test / "deep" / "out");
    Write(folder.path() / "a.txt", "a");
  }
  EXPECT_EQ(EntryCount(test / "deep"), 0);
}

TEST(OutputFolder, ReplacesWhatSiltWroteAndAnEmptyFolder) {
  const TestFolder test;
  std::filesystem::create_directory(test / "out");
  for (const char* name : {"old.txt", "new.txt"}) {
    OutputFolder folder(test / "out/");
    Write(folder.path() / name, name);
    folder.Commit(kManifest);
  }
  EXPECT_FALSE(std::filesystem::exists(test / "out" / "old.txt"));
  EXPECT_TRUE(std::filesystem::exists(test / "out" / "new.txt"));
  EXPECT_EQ(EntryCount(test.path()), 1);
}

TEST(OutputFolder, KeepsTheOldResultWhenTheNewOneFails) {
  const TestFolder test;
  {
    OutputFolder folder(test / "out");
    Write(folder.path() / "a.txt", "first");
    folder.Commit(kManifest);
  }
  {
    OutputFolder folder(test / "out");
    Write(folder.path() / "a.txt", "second");
  }
  EXPECT_EQ(ReadText(test / "out" / "a.txt"), "first");
}

std::string Refusal(const std::filesystem::path& place) {
  try {
    OutputFolder folder(place);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(OutputFolder, RefusesWhatOthersWrote) {
  const TestFolder test;
  Write(test / "theirs" / "thesis.tex", "x");
  EXPECT_THAT(Refusal(test / "theirs"), HasSubstr("'thesis.tex'"));
  EXPECT_TRUE(std::filesystem::exists(test / "theirs" / "thesis.tex"));
}

TEST(OutputFolder, RefusesAFileAddedToItsOwnResults) {
  const TestFolder test;
  {
    OutputFolder folder(test / "out");
    folder.Commit(kManifest);
  }
  Write(test / "out" / "notes.txt", "x");
  EXPECT_THAT(Refusal(test / "out"), HasSubstr("'notes.txt'"));
}

TEST(OutputFolder, RefusesAManifestThatIsNotSilts) {
  const TestFolder test;
  Write(test / "a" / "manifest.json", R"({"program": "other", "entries": ["manifest.json"]})");
  EXPECT_THAT(Refusal(test / "a"), HasSubstr("'manifest.json'"));
  Write(test / "b" / "manifest.json", R"([1, 2)");
  EXPECT_THAT(Refusal(test / "b"), HasSubstr("'manifest.json'"));
  Write(test / "c" / "manifest.json", R"({"program": "silt", "entries": 7})");
  EXPECT_THAT(Refusal(test / "c"), HasSubstr("'manifest.json'"));
}

TEST(OutputFolder, RefusesAFileInItsPlaceAndAPlaceThatCannotBe) {
  const TestFolder test;
  Write(test / "file", "x");
  EXPECT_THAT(Refusal(test / "file"), HasSubstr("no folder"));
  EXPECT_THAT(Refusal(test / "file" / "out"), HasSubstr("out: cannot be written"));
  EXPECT_THAT(Refusal("/proc/none/out"), HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace silt::experiments
