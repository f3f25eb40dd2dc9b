// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/align_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace silt::dense {
namespace {

using testing::HasSubstr;
using testing::Not;

// 1 MB and 4 million operations each, in 0.5 ms.
AlignFigures Figures() {
  AlignFigures figures;
  figures.alignments = figures.ok = 7;
  figures.device_ms = 0.5;
  figures.wall_ms = 0.8;
  figures.work = {40, 1e6, 4e6};
  return figures;
}

constexpr Ceilings kCeilings{8e9, 16e9, 30e9};

TEST(FloorMilliseconds, IsThatOfWhatTakesLonger) {
  EXPECT_DOUBLE_EQ(FloorMilliseconds({1, 1e6, 4e6}, kCeilings), 0.25);
  EXPECT_DOUBLE_EQ(FloorMilliseconds({1, 4e6, 4e6}, kCeilings), 0.5);
  EXPECT_EQ(FloorMilliseconds({1, 1e6, 4e6}, {}), 0);
}

TEST(FiguresJson, SetsSpeedsBesideTheCeilings) {
  const std::string json = FiguresJson(Figures(), kCeilings).Text();
  for (const char* part :
       {"\"per_s\": 2000", "\"bytes_per_s\": 2e+09", "\"operations_per_s\": 8e+09",
        "\"floor_ms\": 0.25", "\"share_of_bytes_ceiling\": 0.25",
        "\"share_of_operations_ceiling\": 0.5"}) {
    EXPECT_THAT(json, HasSubstr(part));
  }
}

TEST(FiguresJson, WhatIsNotMeasuredIsNull) {
  AlignFigures figures = Figures();
  figures.device_ms = 0;
  const std::string json = FiguresJson(figures, {}).Text();
  EXPECT_THAT(json, HasSubstr("\"device_ms\": null"));
  EXPECT_THAT(json, HasSubstr("\"per_s\": 1250"));
  EXPECT_THAT(json, HasSubstr("\"floor_ms\": null"));
  EXPECT_THAT(json, HasSubstr("\"share_of_bytes_ceiling\": null"));
}

TEST(FiguresText, TellsTheClock) {
  EXPECT_THAT(FiguresText("batch", Figures(), kCeilings),
              HasSubstr("0.5 ms by the device's clock"));
  EXPECT_THAT(FiguresText("batch", Figures(), kCeilings), HasSubstr("no less than 0.25 ms"));
  AlignFigures figures = Figures();
  figures.device_ms = 0;
  EXPECT_THAT(FiguresText("batch", figures, {}), HasSubstr("0.8 ms by the host's clock"));
  EXPECT_THAT(FiguresText("batch", figures, {}), Not(HasSubstr("no less than")));
}

}  // namespace
}  // namespace silt::dense
