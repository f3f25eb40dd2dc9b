// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/isolated_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>

#include "sample_model.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/archive_io.h"
#include "silt/sim/model_transfer.h"
#include "silt/sim/scene.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr ImportLimits kImpatient{.time_s = 1, .memory_bytes = std::size_t(300) << 20};

// An importer that does what the name of the file says.
Model Obey(const AssetSource&, const std::string& path) {
  if (path == "crash") raise(SIGSEGV);
  if (path == "abort") std::abort();
  if (path == "exit") _exit(0);
  if (path == "hang") {
    for (volatile int i = 0; i == 0;) {
    }
  }
  if (path == "huge") {
    std::vector<std::string> pieces;
    while (true) pieces.emplace_back(std::size_t(16) << 20, 'x');
  }
  if (path == "refuse") throw Error("refuse: is no model");
  if (path == "throw") throw std::out_of_range("vector::at");
  Model model;
  model.warnings = {path};
  if (path == "nonsense") model.mesh.triangles = {{{7, 8, 9}, 0}};
  return model;
}

std::vector<ImportOutcome> Import(const std::vector<std::string>& names,
                                  const ImportLimits& limits = kImpatient) {
  static const FolderSource folder;
  std::vector<ImportTask> tasks;
  for (const std::string& name : names) tasks.push_back({&folder, name});
  return ImportIsolated(tasks, limits, Obey);
}

TEST(IsolatedImport, GivesTheSameAsTheImportItself) {
  const TempFolder folder;
  folder.Write("sheet.mtl", SampleMtl());
  folder.Write("picture.png", SamplePng());
  const std::string obj = folder.Write("sheet.obj", SampleObj()).string();
  const Archive archive(folder.Write("a.zip", ZipOf({{"s/sheet.obj", SampleObj()},
                                                     {"s/sheet.mtl", SampleMtl()},
                                                     {"s/picture.png", SamplePng()}})));
  const FolderSource files;
  const auto outcomes = ImportIsolated({{&files, obj}, {&archive, "s/sheet.obj"}});
  ASSERT_TRUE(outcomes[0].model && outcomes[1].model);
  EXPECT_EQ(ModelToBytes(*outcomes[0].model), ModelToBytes(ImportModel(files, obj)));
  EXPECT_EQ(ModelToBytes(*outcomes[1].model), ModelToBytes(ImportModel(archive, "s/sheet.obj")));
}

TEST(IsolatedImport, OneBadModelIsRefusedAndTheOthersAreNot) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"crash", "crashed (Segmentation fault)"},
      {"abort", "crashed (Aborted)"},
      {"exit", "went astray"},
      {"hang", "takes longer than 1 s"},
      {"refuse", "refuse: is no model"},
      {"throw", "vector::at"},
      {"nonsense", "is damaged"}};
  std::vector<std::string> names;
  for (const auto& [name, says] : bad) {
    names.push_back("good before " + name);
    names.push_back(name);
  }
  names.push_back("good at the end");
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    const auto outcomes = Import(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      SCOPED_TRACE(names[i]);
      if (i % 2 == 0) {
        ASSERT_TRUE(outcomes[i].model);
        EXPECT_EQ(outcomes[i].model->warnings.at(0), names[i]);
        EXPECT_EQ(outcomes[i].problem, "");
      } else {
        EXPECT_FALSE(outcomes[i].model);
        EXPECT_THAT(outcomes[i].problem, HasSubstr(bad[i / 2].second));
        EXPECT_THAT(outcomes[i].problem, HasSubstr(names[i]));
        EXPECT_EQ(outcomes[i].problem.find('\n'), std::string::npos);
      }
    }
  }
  SetThreadCount(0);
}

TEST(IsolatedImport, AModelThatNeedsTooMuchMemoryIsRefused) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers want their address space";
#endif
  const auto outcomes =
      Import({"huge", "good"}, {.time_s = 60, .memory_bytes = kImpatient.memory_bytes});
  EXPECT_THAT(outcomes[0].problem, HasSubstr("more memory than 300 MiB"));
  EXPECT_TRUE(outcomes[1].model);
}

TEST(IsolatedImport, HasNothingToDoForNoModels) { EXPECT_TRUE(Import({}).empty()); }

// The whole way: a scene whose model cannot be read is told of at its place in the scene file.
TEST(IsolatedImport, ABadModelIsTheScenesErrorAtItsLine) {
  const TempFolder folder;
  folder.Write("bad.obj", "v 0 0 0\n");
  const auto scene = folder.Write("scene.toml", "[[model]]\nname = \"x\"\nfile = \"bad.obj\"\n");
  const std::string message = ErrorOf([&] { LoadScene(scene); });
  EXPECT_THAT(message, StartsWith(scene.string() + ":3: "));
  EXPECT_THAT(message, HasSubstr("bad.obj: "));
}

}  // namespace
}  // namespace silt::sim
