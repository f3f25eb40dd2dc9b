// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/ablation.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "silt/experiments/tracker_options.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

TEST(Ablation, WhatIsKnownCanBeDone) {
  for (const std::string preset : {"paper", "accurate", "fast"}) {
    const Json own = ToJson(PresetOptions(preset));
    for (const Alternative& each : AlternativesTo(preset)) {
      // And is not what the preset does anyway.
      EXPECT_NE(ToJson(PresetOptions(preset + ":" + each.changes)), own) << each.changes;
    }
  }
  EXPECT_TRUE(AlternativesTo("paper-all-pixels").empty());
}

TEST(Ablation, RatiosAreToThePresetItself) {
  AccuracyOptions accuracy;
  accuracy.scene = "studio";
  accuracy.width = 160;
  accuracy.duration_s = 0.2;
  const auto rows = RunAblation(accuracy, "paper", {{"max_iterations=0-0-0-1", "hardly a try"}});
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < rows[0].cells.size(); ++i) {
    const AblationCell &own = rows[0].cells[i], &other = rows[1].cells[i];
    EXPECT_EQ(own.ratio, 1);
    EXPECT_GT(own.position_rmse_cm, 0);
    EXPECT_NEAR(other.ratio, other.position_rmse_cm / own.position_rmse_cm, 1e-9);
  }
  EXPECT_GT(rows[1].cells[0].ratio, 1.5);
  EXPECT_EQ(rows[0].cells.size(), 3u);
}

TEST(Ablation, TablesTellTheChangeAndTheLoss) {
  const std::vector<AblationRow> rows{
      {{"", ""}, {{"sharp", 0.002, 0.001, 1, 0, 10}, {"blur", 0.004, 0.001, 1, 0, 11}}},
      {{"joint=1:exclude_hidden=0", "why"},
       {{"sharp", 0.004, 0.002, 2, 3, 6}, {"blur", 0.002, 0.001, 0.125, 0, 6}}}};
  const std::string table = FormatMarkdown(rows);
  EXPECT_THAT(table, HasSubstr("| sharp | blur | mean | ms a frame |"));
  EXPECT_THAT(table, HasSubstr("| as it is |  | 0.0020 ×1.00 | 0.0040 ×1.00 | ×1.00 | 10.5 |"));
  // √(2/8) = ½.
  EXPECT_THAT(table, HasSubstr("| joint=1 exclude_hidden=0 | why | 0.0040 ×2.00, 3 lost | "
                               "0.0020 ×0.12 | ×0.50 | 6.0 |"));
  const Json json = ToJson(rows);
  ASSERT_EQ(json.size(), 4u);
  EXPECT_EQ(json[2]["changed"], "joint=1:exclude_hidden=0");
  EXPECT_EQ(json[2]["lost"], 3);
  EXPECT_EQ(json[3]["sequence"], "blur");
}

// Those that a folder holds are tracked as they are when they are rendered on the way.
TEST(AblationCommand, TakesRecordedSequences) {
  const TestFolder folder;
  const std::string raw = (folder / "twenty").string();
  const ProgramResult rendered = RunSilt(
      "render --scene studio --width 160 --fps 20 --duration 0.3 --format raw --out " + raw);
  ASSERT_EQ(rendered.exit_code, 0) << rendered.error;
  const RecordedSequences recorded{{folder / "twenty"}};
  const auto rows = RunAblation(recorded, "fast", {{"max_iterations=0-0-0-1", "hardly a try"}});
  AccuracyOptions accuracy;
  accuracy.scene = "studio";
  accuracy.width = 160;
  accuracy.duration_s = 0.3;
  const auto simulated = RunAblation(accuracy, "fast", {});
  ASSERT_EQ(rows[0].cells.size(), 1u);
  EXPECT_EQ(rows[0].cells[0].sequence, "twenty");
  EXPECT_GT(rows[0].cells[0].position_rmse_cm, 0);
  EXPECT_NEAR(rows[0].cells[0].position_rmse_cm, simulated[0].cells[0].position_rmse_cm, 1e-9);
  EXPECT_GT(rows[1].cells[0].ratio, 1.5);

  const ProgramResult missing =
      RunSilt("experiment ablation --preset fast --folder " + (folder / "nothing").string() +
              " --out " + (folder / "abl").string());
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.error, HasSubstr("nothing"));
}

TEST(AblationCommand, WritesATableOfTheChangesAsked) {
  const TestFolder folder;
  const auto out = folder / "abl";
  const ProgramResult result =
      RunSilt("experiment ablation --quick --width 96 --preset fast --change joint=2 --out " +
              out.string());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("| joint=2 |"));
  EXPECT_EQ(ReadText(out / "ablation.md"), result.out.substr(0, result.out.find("Results: ")));
  EXPECT_THAT(ReadText(out / "ablation.csv"), HasSubstr("joint=2,60fps-blur,"));
}

TEST(AblationCommand, RefusesWhatIsNoOptionBeforeItRenders) {
  const TestFolder folder;
  const std::string command =
      "experiment ablation --quick --out " + (folder / "abl").string() + " --change joint=zero";
  const ProgramResult result = RunSilt(command);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.error, HasSubstr("'joint=zero' gives the option no value"));
  EXPECT_FALSE(std::filesystem::exists(folder / "abl"));
}

}  // namespace
}  // namespace silt::experiments
