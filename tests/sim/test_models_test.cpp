// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
// The models on which assimp is tested (Debian's assimp-testmodels): broken ones among them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "silt/core/error.h"
#include "silt/sim/isolated_import.h"
#include "silt/sim/lit_scene.h"
#include "silt/sim/scene.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = "/usr/share/assimp/models";

std::vector<ImportTask> AllFiles(const AssetSource& source) {
  std::vector<ImportTask> tasks;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kFolder)) {
    if (entry.is_regular_file()) tasks.push_back({&source, entry.path().string()});
  }
  std::sort(tasks.begin(), tasks.end(),
            [](const ImportTask& a, const ImportTask& b) { return a.path < b.path; });
  return tasks;
}

// Also those files that are no models at all.
TEST(TestModels, AreReadOrRefusedInOneLine) {
  if (!fs::is_directory(kFolder)) GTEST_SKIP() << "the package assimp-testmodels is not installed";
  const FolderSource source;
  const std::vector<ImportTask> tasks = AllFiles(source);
  const auto outcomes = ImportIsolated(tasks, {.time_s = 60});
  int read = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    SCOPED_TRACE(tasks[i].path);
    EXPECT_NE(outcomes[i].model.has_value(), !outcomes[i].problem.empty());
    if (outcomes[i].model) {
      EXPECT_FALSE(outcomes[i].model->mesh.triangles.empty());
      ++read;
    } else {
      EXPECT_THAT(outcomes[i].problem, testing::StartsWith(tasks[i].path));
      EXPECT_EQ(outcomes[i].problem.find('\n'), std::string::npos) << outcomes[i].problem;
      EXPECT_LT(outcomes[i].problem.size(), tasks[i].path.size() + 400);
    }
  }
  EXPECT_GT(read, 250) << "of " << tasks.size();
}

// What comes behind the import as well: materials, pictures, placement, the acceleration structure.
TEST(TestModels, MakeScenesOrAreRefusedInOneLine) {
  if (!fs::is_directory(kFolder)) GTEST_SKIP() << "the package assimp-testmodels is not installed";
  const TempFolder folder;
  const FolderSource source;
  LightingOptions lighting;
  lighting.mode = LightMode::kPath;
  int loaded = 0, textured = 0;
  for (const ImportTask& task : AllFiles(source)) {
    SCOPED_TRACE(task.path);
    std::string name;
    for (const char c : task.path)
      name += c == '\\' || c == '"' ? std::string("\\") + c : std::string(1, c);
    const fs::path file = folder.Write("scene.toml",
                                       "name = \"t\"\nambient = [1, 1, 1]\n[[model]]\n"
                                       "file = \"" +
                                           name + "\"\n");
    try {
      const LitScene lit(LoadScene(file), lighting);
      EXPECT_FALSE(lit.scene().mesh.triangles.empty());
      ++loaded;
      textured += !lit.scene().textures.empty();
    } catch (const Error& e) {
      const std::string message = e.what();
      EXPECT_THAT(message, testing::StartsWith(file.string() + ":"));
      EXPECT_EQ(message.find('\n'), message.npos) << message;
      EXPECT_LT(message.size(), file.string().size() + task.path.size() + 420);
    }
  }
  EXPECT_GT(loaded, 230);
  EXPECT_GT(textured, 20);
}

}  // namespace
}  // namespace silt::sim
