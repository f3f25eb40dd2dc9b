// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace silt::experiments {

std::string ReadText(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TestFolder::TestFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "silt-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make " + pattern);
  path_ = pattern;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

ProgramResult RunSilt(const std::string& arguments, const std::string& before) {
  const TestFolder folder;
  const std::string out = (folder / "out").string(), error = (folder / "error").string();
  // The arguments may redirect stdout themselves.
  const bool redirected = arguments.find('>') != arguments.npos;
  const std::string command = before + " " + SILT_PROGRAM + " " + arguments +
                              (redirected ? "" : " > " + out) + " 2> " + error;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(out), ReadText(error)};
}

void ExpectOneLineError(const ProgramResult& result, const std::string& part) {
  EXPECT_GT(result.exit_code, 0) << result.out;
  std::istringstream lines(result.error);
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" left: ") != line.npos) continue;
    EXPECT_LT(line.size(), 300u);
    ++count;
  }
  EXPECT_EQ(count, 1) << result.error;
  EXPECT_THAT(result.error, testing::HasSubstr(part));
}

}  // namespace silt::experiments
