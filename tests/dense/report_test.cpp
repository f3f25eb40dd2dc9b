// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/report.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/dense/align_bench.h"
#include "silt/dense/backends.h"
#include "silt/tracker/cpu_backend.h"
#include "waves.h"

namespace silt::dense {
namespace {

ReportOptions Small(const std::string& backend) {
  ReportOptions options;
  options.backend = backend;
  options.repeats = 2;
  options.starts = 3;
  options.commit = "abc";
  return options;
}

void ExpectReport(const std::string& backend) {
  const Report report = MakeReport(Waves(3), Small(backend));
  EXPECT_TRUE(report.agrees) << report.text;
  for (const char* key :
       {"\"commit\": \"abc\"", "\"paper\"", "\"accurate\"", "\"fast\"", "\"refinement_20_20_5_2\"",
        "\"batch_20_20_5_2\"", "\"floor_bytes\"", "\"agrees_with_cpu\": true"}) {
    EXPECT_NE(report.json.find(key), std::string::npos) << key;
  }
  EXPECT_NE(report.json.find("\"backend\": \"" + backend + "\""), std::string::npos);
}

TEST(Report, OfTheCpuAgreesWithItself) { ExpectReport("cpu"); }

TEST(Report, OfTheGpusCodeAgreesWithTheCpu) { ExpectReport("cuda-emulated"); }

TEST(Report, OfTheGpuAgreesWithTheCpu) {
  try {
    MakeBackend("cuda");
  } catch (const Error& why_not) {
    GTEST_SKIP() << why_not.what();
  }
  ExpectReport("cuda");
}

TEST(Report, NeedsTwoFramesAndAKnownBackend) {
  EXPECT_THROW(MakeReport(Waves(1), Small("cpu")), Error);
  EXPECT_THROW(MakeReport(Waves(2), Small("gpu")), Error);
}

TEST(MeasureRefinement, TakesAllItsSolves) {
  const std::vector<RawFrame> frames = Waves(2);
  const MovedPair pair{kSmallCamera, frames[0].frame, frames[1].frame,
                       frames[1].world_from_camera.Inverse() * frames[0].world_from_camera};
  const auto cpu = tracker::MakeCpuBackend();
  const AlignFigures figures = MeasureRefinement(*cpu, {pair}, RefinementOptions(), 3);
  EXPECT_EQ(figures.alignments, 3);
  EXPECT_EQ(figures.ok, 3);
  EXPECT_EQ(figures.work.passes, 20 + 20 + 5 + 2 + 4);
  EXPECT_GT(figures.wall_ms, 0);
  EXPECT_EQ(figures.device_ms, 0);
}

TEST(MeasureBatch, CountsWhatItAligns) {
  const std::vector<RawFrame> frames = Waves(2);
  const MovedPair pair{kSmallCamera, frames[0].frame, frames[1].frame,
                       frames[1].world_from_camera.Inverse() * frames[0].world_from_camera};
  const auto cpu = tracker::MakeCpuBackend();
  const AlignFigures figures = MeasureBatch(*cpu, {pair}, tracker::AccuratePreset().alignment, 5);
  EXPECT_EQ(figures.alignments, 5);
  EXPECT_EQ(figures.ok, 5);
  EXPECT_GT(figures.PerSecond(), 0);
}

}  // namespace
}  // namespace silt::dense
