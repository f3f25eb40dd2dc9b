// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/comparison_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "silt/experiments/paper_values.h"

namespace silt::experiments {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

AccuracyRun MakeRun(const std::string& sequence, std::uint64_t seed, double rmse_cm) {
  AccuracyRun run;
  run.sequence.name = sequence;
  run.setup.seed = seed;
  run.statistics.position_cm.rmse = rmse_cm;
  run.statistics.orientation_deg[1].min = -0.5;
  return run;
}

const ComparisonTable* Find(const std::vector<ComparisonTable>& tables, const std::string& title) {
  for (const ComparisonTable& table : tables) {
    if (table.title.find(title) != title.npos) return &table;
  }
  return nullptr;
}

TEST(ComparisonTables, PutOursBesideThePapers) {
  const auto tables = ComparisonTables({MakeRun("20fps", 0, 0.25), MakeRun("60fps", 0, 0.125)});
  const ComparisonTable& position = tables.front();
  EXPECT_THAT(position.groups, ElementsAre("20fps", "60fps"));
  EXPECT_THAT(position.columns, ElementsAre("paper", "silt"));
  EXPECT_EQ(position.rows[0].label, "RMSE");
  EXPECT_THAT(position.rows[0].cells,
              ElementsAre(ElementsAre("0.74", "0.250"), ElementsAre("0.52", "0.125")));
  const ComparisonTable* about_y = Find(tables, "about Y");
  ASSERT_TRUE(about_y);
  EXPECT_EQ(about_y->rows[2].label, "Min. error");
  EXPECT_THAT(about_y->rows[2].cells[0], ElementsAre("-0.44", "-0.500"));
}

TEST(ComparisonTables, ShowTheSpreadOfSeveralSeedsOnly) {
  EXPECT_EQ(Find(ComparisonTables({MakeRun("60fps", 0, 1)}), "seeds"), nullptr);
  const auto tables =
      ComparisonTables({MakeRun("60fps", 0, 1), MakeRun("60fps", 1, 2), MakeRun("60fps", 2, 3)});
  const ComparisonTable* spread = Find(tables, "3 seeds");
  ASSERT_TRUE(spread);
  EXPECT_THAT(spread->rows[0].cells[0], ElementsAre("0.52", "2.000"));
  EXPECT_THAT(spread->rows[3].cells[0], ElementsAre("", "3.000"));
  EXPECT_THAT(tables.front().rows[0].cells[0], ElementsAre("0.52", "1.000"));  // the first seed's
}

TEST(ComparisonTables, NameThePresetsWhereThereAreSeveral) {
  AccuracyRun fast = MakeRun("60fps", 0, 3);
  fast.setup.preset = "fast";
  const auto tables = ComparisonTables({MakeRun("60fps", 0, 1), fast});
  EXPECT_THAT(tables.front().columns, ElementsAre("paper", "silt paper", "silt fast"));
  EXPECT_THAT(tables.front().rows[0].cells[0], ElementsAre("0.52", "1.000", "3.000"));
}

ComparisonTable Small() {
  return {"A & B", {"g1", "g2"}, {"paper", "silt"}, {{"row", {{"1", "2"}, {"", "<4>"}}}}};
}

TEST(ComparisonTables, TextStandsInColumns) {
  EXPECT_EQ(FormatText(Small()),
            "A & B\n"
            "                                  g1              g2\n"
            "                        paper   silt    paper   silt\n"
            "row                         1      2             <4>\n");
}

TEST(ComparisonTables, HtmlIsEscapedAndMarksThePapersCells) {
  const std::string html = FormatHtml(Small());
  EXPECT_THAT(html, HasSubstr("<caption>A &amp; B</caption>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"paper\">1</td><td>2</td>"));
  EXPECT_THAT(html, HasSubstr("&lt;4&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<4>")));
}

// From the text of the paper: "the maximum error is 1.63° and the minimum error is −1.90°", and "a
// RMSE of 1.12 cm in translation and 0.31°, 0.34° and 0.43°".
TEST(PaperValues, AreThoseThatThePaperRepeatsInWords) {
  double highest = -99, lowest = 99;
  for (const char* sequence : {"20fps", "60fps", "60fps-blur"}) {
    for (int axis = 0; axis < 3; ++axis) {
      highest = std::max(highest, std::stod(PaperOrientation(sequence, axis)->max));
      lowest = std::min(lowest, std::stod(PaperOrientation(sequence, axis)->min));
    }
  }
  EXPECT_EQ(highest, 1.63);
  EXPECT_EQ(lowest, -1.90);
  EXPECT_STREQ(PaperPosition("60fps-blur")->rmse, "1.12");
  EXPECT_STREQ(PaperOrientation("60fps-blur", 2)->rmse, "0.43");
  EXPECT_EQ(PaperPosition("30fps"), nullptr);
  EXPECT_EQ(PaperOrientation("60fps", 3), nullptr);
}

// rmse² = mean² + std², within the two digits printed; a digit typed wrong shows here.
TEST(PaperValues, AreConsistent) {
  for (const char* sequence : {"20fps", "60fps", "60fps-blur"}) {
    for (int axis = -1; axis < 3; ++axis) {
      const PaperColumn& c =
          axis < 0 ? *PaperPosition(sequence) : *PaperOrientation(sequence, axis);
      EXPECT_NEAR(std::stod(c.rmse), std::hypot(std::stod(c.mean), std::stod(c.std_dev)), 0.011)
          << sequence << " " << axis;
    }
  }
}

}  // namespace
}  // namespace silt::experiments
