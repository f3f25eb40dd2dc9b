// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/archive_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_model.h"
#include "silt/core/parallel.h"
#include "silt/core/random.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

TEST(ArchiveTest, ReadsEntriesByPath) {
  const TempFolder folder;
  const Archive archive(folder.Write(
      "a.zip", ZipOf({{"top.txt", "top"}, {"Desk/Oak.png", "oak"}, {"Desk/b/c.txt", "deep"}})));
  EXPECT_EQ(*archive.Read(*archive.Find("top.txt")), "top");
  EXPECT_EQ(*archive.Read(*archive.Find("desk\\OAK.png")), "oak");
  EXPECT_EQ(*archive.Read(*archive.Find("Desk/b/../b/./c.txt")), "deep");
  EXPECT_FALSE(archive.Find("Desk").has_value());
  EXPECT_FALSE(archive.Find("../top.txt").has_value());
  EXPECT_THAT(archive.Describe("top.txt"), HasSubstr("a.zip(top.txt)"));
}

TEST(ArchiveTest, PrefersTheExactCase) {
  const TempFolder folder;
  const Archive archive(folder.Write("a.zip", ZipOf({{"A.txt", "upper"}, {"a.txt", "lower"}})));
  EXPECT_EQ(*archive.Read(*archive.Find("a.txt")), "lower");
  EXPECT_EQ(*archive.Read(*archive.Find("A.txt")), "upper");
}

TEST(ArchiveTest, SharesWhatItHasRead) {
  const TempFolder folder;
  const Archive archive(folder.Write("a.zip", ZipOf({{"d/a", "1"}, {"d/b", "2"}, {"e/c", "3"}})));
  const Bytes first = archive.Read("d/a");
  EXPECT_EQ(archive.Read("d/a"), first);
  // The folder's other file came along; one elsewhere needs the archive again.
  std::filesystem::remove(folder.path() / "a.zip");
  EXPECT_EQ(*archive.Read("d/b"), "2");
  EXPECT_THAT(ErrorOf([&] { archive.Read("e/c"); }), HasSubstr("a.zip"));
}

TEST(ArchiveTest, ServesManyThreads) {
  const TempFolder folder;
  std::map<std::string, std::string> files;
  for (int i = 0; i < 40; ++i) {
    files["d" + std::to_string(i % 7) + "/" + std::to_string(i)] = std::string(1000, char('a' + i));
  }
  const Archive archive(folder.Write("a.zip", ZipOf(files)));
  ParallelFor(200, [&](int i) {
    const int k = i % 40;
    const std::string name = "d" + std::to_string(k % 7) + "/" + std::to_string(k);
    EXPECT_EQ(*archive.Read(name), files.at(name));
  });
}

TEST(ArchiveTest, RefusesWhatIsNoArchive) {
  const TempFolder folder;
  const std::string text = ErrorOf([&] { Archive(folder.Write("a.zip", "hello")); });
  EXPECT_THAT(text, HasSubstr("a.zip: is not an archive"));
  EXPECT_THAT(ErrorOf([&] { Archive(folder.path() / "none.zip"); }), HasSubstr("none.zip"));
  EXPECT_THAT(ErrorOf([&] { Archive(folder.path()); }), HasSubstr("is not an archive"));
}

TEST(ArchiveTest, ReportsDamagedEntriesOnlyWhenAsked) {
  const TempFolder folder;
  std::string noise;
  for (std::uint64_t i = 0; i < 4000; ++i) noise += char(CounterRandom(1).Bits(i));
  std::string zip = ZipOf({{"a.txt", "good"}, {"b.bin", noise}});
  const std::size_t body = zip.find("b.bin") + 600;
  for (std::size_t i = 0; i < 200; ++i) zip[body + i] = char(~zip[body + i]);
  const Archive archive(folder.Write("a.zip", zip));
  EXPECT_EQ(*archive.Read("a.txt"), "good");
  const std::string message = ErrorOf([&] { archive.Read("b.bin"); });
  EXPECT_THAT(message, HasSubstr("a.zip(b.bin): is damaged"));
  EXPECT_THAT(ErrorOf([&] { archive.Read("c.txt"); }), HasSubstr("no such file"));
}

TEST(ArchiveTest, ReportsATruncatedArchive) {
  const TempFolder folder;
  const std::string zip = ZipOf({{"a.txt", std::string(5000, 'x')}, {"b.txt", "b"}});
  for (std::size_t length = 0; length < zip.size(); length += 7) {
    const auto file = folder.Write("a.zip", zip.substr(0, length));
    try {
      const Archive archive(file);
      if (const auto name = archive.Find("a.txt")) archive.Read(*name);
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("a.zip"));
    }
  }
}

}  // namespace
}  // namespace silt::sim
