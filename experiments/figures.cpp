// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/figures.h"

#include <fcntl.h>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "silt/core/error.h"
#include "silt/experiments/resources.h"

extern char** environ;

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

// Another Python may come first on PATH, without matplotlib.
const char* const kPython = "/usr/bin/python3";

// Exit code of the script, or −1 where it could not be started. What it prints goes to `log`.
int RunPython(const fs::path& script, const fs::path& folder, const fs::path& log) {
  std::string words[] = {kPython, script.string(), folder.string()};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failed = posix_spawn(&child, kPython, &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string LastLine(const fs::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

bool DrawFigures(const std::string& script, const fs::path& folder) {
  const fs::path log = folder / ".figures.log";
  std::string reason;
  try {
    const int code = RunPython(FigureScript(script), folder, log);
    if (code != 0) {
      reason = LastLine(log);
      if (reason.empty()) reason = std::string(kPython) + " cannot be run";
    }
  } catch (const Error& error) {
    reason = error.what();
  }
  std::error_code ignored;
  fs::remove(log, ignored);
  if (reason.empty()) return true;
  spdlog::warn("no figures drawn ({}); apt-get install python3-matplotlib mends it", reason);
  return false;
}

}  // namespace silt::experiments
