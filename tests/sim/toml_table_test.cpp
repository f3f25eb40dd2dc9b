// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/toml_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "silt/core/error.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(TomlTableTest, ReadsValues) {
  const TomlTable table = TomlTable::Parse(
      "text = 'a'\nnumber = 2\nreal = -0.5\nflag = true\nvector = [1, 2.5, 3]\n"
      "[map]\nb = 'B'\na = 'A'\n[[item]]\nk = 1\n[[item]]\nk = 2\n",
      "f.toml");
  EXPECT_EQ(table.String("text"), "a");
  EXPECT_EQ(table.String("absent", "fallback"), "fallback");
  EXPECT_TRUE(table.IsString("text"));
  EXPECT_FALSE(table.IsString("number"));
  EXPECT_EQ(table.Integer("number", 7), 2);
  EXPECT_EQ(table.Integer("absent", 7), 7);
  EXPECT_EQ(table.Number("number"), 2);
  EXPECT_EQ(table.Number("real", 1), -0.5);
  EXPECT_EQ(table.Number("absent", 1), 1);
  EXPECT_TRUE(table.Bool("flag", false));
  EXPECT_EQ(table.Vector("vector").y, 2.5);
  EXPECT_EQ(table.Vector("absent", {4, 5, 6}).z, 6);
  const auto map = table.Strings("map");
  ASSERT_EQ(map.size(), 2u);
  EXPECT_EQ(map[0], std::make_pair(std::string("a"), std::string("A")));
  const std::vector<TomlTable> items = table.Tables("item");
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[1].Integer("k", 0), 2);
  EXPECT_EQ(items[1].place(), "f.toml:11");
  EXPECT_TRUE(table.Tables("absent").empty());
  EXPECT_NO_THROW(table.RejectUnknownKeys());
}

TEST(TomlTableTest, NamesUnknownKeysWithTheirLine) {
  const TomlTable table = TomlTable::Parse("name = 'a'\ncolour = 1\n", "f.toml");
  table.String("name");
  table.Has("color");
  EXPECT_EQ(ErrorOf([&] { table.RejectUnknownKeys(); }),
            "f.toml:2: unknown key 'colour'; known here: color, name");
}

struct BadValue {
  const char* toml;
  const char* message;
};
void PrintTo(const BadValue& bad, std::ostream* out) { *out << bad.message; }

class TomlTableBadValueTest : public testing::TestWithParam<BadValue> {};

TEST_P(TomlTableBadValueTest, NamesTheLineAndTheKey) {
  const std::string message = ErrorOf([] {
    const TomlTable table = TomlTable::Parse(GetParam().toml, "f.toml");
    table.Number("number", 0);
    table.Integer("integer", 0);
    table.Bool("flag", false);
    table.String("text", "");
    table.Vector("vector", {});
    table.Tables("tables");
    table.Strings("strings");
    table.String("needed");
  });
  EXPECT_THAT(message, HasSubstr(GetParam().message));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, TomlTableBadValueTest,
    testing::Values(
        BadValue{"\nnumber = 'x'", "f.toml:2: number must be a number, not a string"},
        BadValue{"number = inf", "f.toml:1: number must be finite"},
        BadValue{"number = nan", "f.toml:1: number must be finite"},
        BadValue{"number = 2020-01-01", "f.toml:1: number must be a number, not a date or time"},
        BadValue{"integer = 1.5", "f.toml:1: integer must be a whole number"},
        BadValue{"integer = 9999999999", "f.toml:1: integer is out of range"},
        BadValue{"flag = 1", "f.toml:1: flag must be true or false, not a number"},
        BadValue{"text = [1]", "f.toml:1: text must be a string, not an array"},
        BadValue{"text = \"a\\nb\"", "f.toml:1: text must not hold control characters"},
        BadValue{"number = 1e13", "f.toml:1: number must be finite, and at most 1e12"},
        BadValue{"\n\nvector = [1, 2]", "f.toml:3: vector must be an array of 3 finite numbers"},
        BadValue{"vector = [1, 2, 'z']", "f.toml:1: vector must be an array of 3 finite numbers"},
        BadValue{"vector = 3", "f.toml:1: vector must be an array of 3 finite numbers"},
        BadValue{"[tables]\na = 1", "f.toml:1: tables must be written as [[tables]]"},
        BadValue{"tables = [1]", "f.toml:1: tables must be written as [[tables]]"},
        BadValue{"strings = 1", "f.toml:1: strings must be a table of strings"},
        BadValue{"strings = { a = 1 }", "f.toml:1: strings must hold strings only"},
        BadValue{"", "needed is missing"}, BadValue{"a = 1\na = 2", "f.toml:2: is not TOML"},
        BadValue{"a = \n", "f.toml:1: is not TOML"},
        BadValue{"a = tru\ne", "f.toml:1: is not TOML"}, BadValue{"\xEF\xBB\xBD", "is not TOML"},
        BadValue{"a = 'unterminated", "f.toml:1: is not TOML"}));

TEST(TomlTableTest, NamesUnknownKeysInOneLine) {
  const TomlTable table = TomlTable::Parse("\"a\\nb\" = 1", "f.toml");
  EXPECT_THAT(ErrorOf([&] { table.RejectUnknownKeys(); }), HasSubstr("unknown key 'a b'"));
}

TEST(TomlTableTest, RefusesFoldersAndMissingFiles) {
  const TempFolder folder;
  EXPECT_THAT(ErrorOf([&] { TomlTable::ReadFile(folder.path()); }),
              HasSubstr("is not a regular file"));
  EXPECT_THAT(ErrorOf([&] { TomlTable::ReadFile(folder.path() / "none.toml"); }),
              HasSubstr("none.toml: no such file"));
}

TEST(TomlTableTest, ReadsFiles) {
  const TempFolder folder;
  const auto file = folder.Write("a.toml", "x = 1\n\ny = 'z'\n");
  const TomlTable table = TomlTable::ReadFile(file);
  EXPECT_EQ(table.Number("x"), 1);
  EXPECT_THAT(ErrorOf([&] { table.Number("y"); }), StartsWith(file.string() + ":3: y must be"));
  EXPECT_NO_THROW(TomlTable::ReadFile(folder.Write("empty.toml", "")).RejectUnknownKeys());
}

}  // namespace
}  // namespace silt::sim
