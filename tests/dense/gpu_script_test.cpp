// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

// ./experiments/gpu beside stand-ins for all that it calls, which write down how they were called.
namespace silt::dense {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string ReadText(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class GpuScript : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "silt-gpu-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    for (const char* folder : {"tools", "sequence", "experiments/results", "build/gpu/bin"}) {
      fs::create_directories(root_ / folder);
    }
    fs::copy_file(fs::path(SILT_SOURCE_DIR) / "experiments/gpu", root_ / "experiments/gpu");
    std::ofstream(root_ / "sequence/frames.txt") << "0 0.color 0.depth\n";
    Tool("tools/nvidia-smi",
         "case $* in *driver*) echo 580.65;; *cap*) echo 9.0;; *) echo 'NVIDIA H200';; esac");
    for (const char* tool : {"tools/cmake", "build/gpu/bin/cuda_tests", "build/gpu/bin/dense_tests",
                             "build/gpu/bin/silt-dense"}) {
      Tool(tool, "");
    }
  }
  void TearDown() override { fs::remove_all(root_); }

  // A stand-in that writes down its name and arguments first.
  void Tool(const std::string& name, const std::string& script) {
    const fs::path file = root_ / name;
    std::ofstream(file) << "#!/bin/bash\necho \"${0##*/} $*\" >> " << root_ / "calls"
                        << "\n"
                        << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
  }

  // Its exit code; what it has said is in out_.
  int Run(const std::string& arguments) {
    const std::string out = (root_ / "out").string();
    fs::remove(root_ / "calls");
    const std::string command = "CUDA_HOME=" + (root_ / "cuda").string() +
                                " PATH=" + (root_ / "tools").string() + ":/usr/bin:/bin " +
                                (root_ / "experiments/gpu").string() + " " + arguments + " > " +
                                out + " 2>&1";
    const int status = std::system(command.c_str());
    out_ = ReadText(out);
    calls_ = ReadText(root_ / "calls");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string Sequence() const { return (root_ / "sequence").string(); }

  fs::path root_;
  std::string out_, calls_;
};

TEST_F(GpuScript, BuildsTestsAndMeasures) {
  EXPECT_EQ(Run(Sequence() + " --frames 3"), 0) << out_;
  const std::string json = (root_ / "experiments/results/gpu_nvidia_h200.json").string();
  EXPECT_THAT(calls_, HasSubstr("-DSILT_DENSE_ONLY=ON -DSILT_CUDA=REQUIRED "
                                "-DCMAKE_CUDA_ARCHITECTURES=90\n"));
  EXPECT_THAT(calls_, HasSubstr("cuda_tests --gtest_brief=1\ndense_tests --gtest_brief=1\n"));
  EXPECT_THAT(calls_, HasSubstr("silt-dense " + Sequence() + " --backend cuda --json " + json +
                                " --commit unknown, driver 580.65, sanitizer: none --frames 3\n"));
  EXPECT_THAT(out_, HasSubstr("no compute-sanitizer here: racecheck is left out"));
  EXPECT_THAT(out_, HasSubstr("Results: " + json));
}

// On PATH, or where a toolkit usually is.
TEST_F(GpuScript, ChecksMemoryAndRacesWhereItCan) {
  fs::create_directories(root_ / "cuda/bin");
  for (const char* place : {"tools/compute-sanitizer", "cuda/bin/compute-sanitizer"}) {
    Tool(place, "echo blocks $SILT_CUDA_BLOCKS");
    EXPECT_EQ(Run(Sequence()), 0) << out_;
    for (const char* tool : {"memcheck", "racecheck"}) {
      EXPECT_THAT(calls_, HasSubstr("compute-sanitizer --tool " + std::string(tool) +
                                    " --report-api-errors no --error-exitcode 1 "));
    }
    EXPECT_THAT(out_, HasSubstr("blocks 8"));
    EXPECT_THAT(calls_, HasSubstr("sanitizer: memcheck racecheck"));
    fs::remove(root_ / place);
  }
}

// Stages one by one, of which the last one knows what was checked before.
TEST_F(GpuScript, GoesStageByStageWhereAsked) {
  Tool("tools/compute-sanitizer", "");
  const char* const first_calls[] = {"\ncmake -S", "\ncuda_tests --gtest",
                                     "\ncompute-sanitizer --tool racecheck", "\nsilt-dense "};
  int i = 0;
  for (const char* stage : {"build", "test", "racecheck", "measure"}) {
    EXPECT_EQ(Run(std::string("--only ") + stage + " " + Sequence()), 0) << out_;
    for (const char* call : first_calls) {
      EXPECT_EQ(calls_.find(call) != calls_.npos, call == first_calls[i]) << stage << calls_;
    }
    ++i;
  }
  EXPECT_THAT(calls_, HasSubstr("sanitizer: racecheck\n"));
  EXPECT_EQ(Run("--only tests " + Sequence()), 1);
  EXPECT_THAT(out_, HasSubstr("--only: 'tests' is none of build, test"));
}

TEST_F(GpuScript, BuildsForAllWhereTheDriverTellsNoCapability) {
  Tool("tools/nvidia-smi", "case $* in *cap*) exit 1;; *) echo 'Old GPU';; esac");
  EXPECT_EQ(Run("--only build " + Sequence()), 0) << out_;
  EXPECT_THAT(calls_, Not(HasSubstr("ARCHITECTURES")));
}

TEST_F(GpuScript, MeasuresNothingWhereATestFails) {
  for (const char* failing : {"build/gpu/bin/dense_tests", "build/gpu/bin/cuda_tests"}) {
    Tool(failing, "exit 1");
    EXPECT_EQ(Run(Sequence()), 1) << failing;
    EXPECT_THAT(calls_, Not(HasSubstr("silt-dense ")));
  }
}

// It may not know the device, and takes longest.
TEST_F(GpuScript, MeasuresWhereTheSanitizerFails) {
  Tool("tools/compute-sanitizer", "[[ $* == *memcheck* ]]");
  EXPECT_EQ(Run(Sequence()), 1);
  EXPECT_THAT(out_, HasSubstr("experiments/gpu: racecheck has not passed\n"));
  EXPECT_THAT(out_, Not(HasSubstr("memcheck has not passed")));
  EXPECT_THAT(calls_, HasSubstr("sanitizer: memcheck\n"));
}

TEST_F(GpuScript, ExitsAsTheMeasurementDoes) {
  Tool("build/gpu/bin/silt-dense", "exit 2");
  EXPECT_EQ(Run(Sequence()), 2) << "backends do not agree";
  EXPECT_THAT(out_, HasSubstr("Results: "));
  Tool("build/gpu/bin/silt-dense", "exit 1");
  EXPECT_EQ(Run(Sequence()), 1);
  EXPECT_THAT(out_, Not(HasSubstr("Results: ")));
}

TEST_F(GpuScript, WhatIsMissingIsToldInOneLine) {
  EXPECT_EQ(Run(""), 1);
  EXPECT_EQ(out_,
            "experiments/gpu: give the folder of a sequence: silt render --scene office --format "
            "raw --out DIR\n");
  EXPECT_EQ(Run(root_.string()), 1);
  EXPECT_THAT(out_, HasSubstr("holds no frames.txt"));
  Tool("tools/nvidia-smi", "exit 6");
  EXPECT_EQ(Run(Sequence()), 1);
  EXPECT_EQ(out_, "experiments/gpu: nvidia-smi finds no GPU\n");
  EXPECT_THAT(calls_, Not(HasSubstr("cmake")));
}

}  // namespace
}  // namespace silt::dense
