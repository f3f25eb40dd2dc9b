// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace silt::experiments {

struct ProgramResult {
  int exit_code = 0;
  std::string out, error;
};

// Runs the built program with these arguments, as typed into a shell; `before` stands before it on
// the command line: "ulimit -f 1;" or "timeout 5".
ProgramResult RunSilt(const std::string& arguments, const std::string& before = "");

// The run has failed and said why in one short line that holds `part`. Lines of
// progress, which a slow machine may bring, do not count.
void ExpectOneLineError(const ProgramResult& result, const std::string& part = "");

// A folder of the running test's own, empty at the start and gone at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string ReadText(const std::filesystem::path& file);

}  // namespace silt::experiments
