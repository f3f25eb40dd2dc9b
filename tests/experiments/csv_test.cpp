// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/csv.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace silt::experiments {
namespace {

TEST(Csv, HasTheKeysAsHeaderAndALinePerObject) {
  const Json rows =
      Json::array({{{"name", "a"}, {"n", 3}, {"x", 0.1}, {"ok", true}, {"none", nullptr}},
                   {{"name", "b"}, {"n", -1}, {"x", 1e-12}, {"ok", false}, {"none", 2.5}}});
  EXPECT_EQ(FormatCsv(rows), "name,n,x,ok,none\na,3,0.1,true,\nb,-1,1e-12,false,2.5\n");
}

TEST(Csv, AnEmptyFirstCellIsACell) {
  EXPECT_EQ(FormatCsv(Json::array({{{"changed", ""}, {"n", 3}}})), "changed,n\n,3\n");
}

TEST(Csv, QuotesWhatWouldBreakALine) {
  const Json rows = Json::array({{{"a,b", "say \"no\"\nnow"}}});
  EXPECT_EQ(FormatCsv(rows), "\"a,b\"\n\"say \"\"no\"\"\nnow\"\n");
}

TEST(Csv, OfNothingIsEmpty) { EXPECT_EQ(FormatCsv(Json::array()), ""); }

}  // namespace
}  // namespace silt::experiments
