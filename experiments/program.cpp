// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/program.h"

#include <malloc.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>
#include <string>

#include "silt/experiments/build_info.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/interrupt.h"

namespace silt::experiments {
namespace {

int Fail(std::string message, int code) {
  // What a library put into several lines is still one failure.
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fprintf(stderr, "silt: %s\n", message.c_str());
  return code;
}

// As typed; an argument with spaces or quotes is put into single quotes.
std::string CommandLine(int argc, const char* const* argv) {
  std::string line = "silt";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\*?$&;|<>()") == word.npos;
    line += " ";
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

// CLI11 would only say that a command is required, not which word is none.
void RequireKnownCommand(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto named = [&](const CLI::App* each) { return each->get_name() == word; };
    const auto all = [](const CLI::App*) { return true; };
    const bool told = word == "-h" || word == "--help" || word == "--version";
    if (told || command->get_subcommands(all).empty()) return;
    const auto found = command->get_subcommands(named);
    if (found.empty()) throw CLI::ExtrasError({"'" + word + "' (no such command)"});
    command = found.front();
  }
}

void AddCommands(CLI::App& app, const Invocation& invocation) {
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("silt ") + kVersion + " (" + Commit() + ")");
  app.footer(
      "Each command tells more with --help. A first try:\n"
      "  silt experiment accuracy --out results/accuracy");
  AddRenderCommand(app, invocation);
  AddConvertCommand(app, invocation);
  AddTrackCommand(app, invocation);
  AddAlignCommand(app, invocation);
  AddEvaluateCommand(app, invocation);
  AddExperimentCommand(app, invocation);
  AddBenchCommand(app, invocation);
  AddSceneCommand(app, invocation);
  AddPathCommand(app, invocation);
  AddInfoCommand(app, invocation);
}

// Images come and go by the megabyte. glibc would return their memory to the system each time, and
// to get it again, page by page, takes longer than most of what is done with it.
void KeepFreedMemory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that glibc takes
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

}  // namespace

int RunProgram(int argc, const char* const* argv) {
  KeepFreedMemory();
  // stdout is for results.
  spdlog::set_default_logger(spdlog::stderr_color_mt("silt"));
  spdlog::set_pattern("silt: %^%v%$");
  CatchInterrupts();
  const Invocation invocation{CommandLine(argc, argv)};
  CLI::App app{"silt: simulation in the loop for RGB-D tracking", "silt"};
  AddCommands(app, invocation);
  try {
    RequireKnownCommand(app, argc, argv);
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return Fail(std::string(error.what()) + " (--help tells more)", 2);
  } catch (const Interrupted& interrupted) {
    return Fail("interrupted; " + interrupted.consequence, 130);
  } catch (const std::bad_alloc&) {
    return Fail("out of memory", 1);
  } catch (const std::exception& error) {
    return Fail(error.what(), 1);
  }
}

}  // namespace silt::experiments
