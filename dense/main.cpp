// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/dense/report.h"

namespace {

constexpr const char* kUsage =
    "Usage: silt-dense FOLDER [--backend cuda|cuda-emulated|cpu] [--frames N] [--repeats N]\n"
    "                  [--starts N] [--commit TEXT] [--json FILE]\n"
    "Tracks a sequence that `silt render --format raw` wrote, by the CPU and by the backend, "
    "compares\n"
    "their poses, and measures refinements and batches. Exit code 2: the two do not agree.\n";

struct Arguments {
  std::string folder, json;
  silt::dense::ReportOptions report;
};

int Count(const std::string& option, const std::string& value) {
  char* end = nullptr;
  const long number = std::strtol(value.c_str(), &end, 10);
  if (value.empty() || *end != '\0' || number < 1 || number > 10000000) {
    throw silt::Error(option + ": '" + value + "' is not a number from 1 to 10000000");
  }
  return int(number);
}

Arguments Parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.rfind("--", 0) != 0 && arguments.folder.empty()) {
      arguments.folder = word;
      continue;
    }
    if (i + 1 == words.size()) throw silt::Error(word + ": see silt-dense --help");
    const std::string& value = words[++i];
    if (word == "--backend") {
      arguments.report.backend = value;
    } else if (word == "--frames") {
      arguments.report.frames = Count(word, value);
    } else if (word == "--repeats") {
      arguments.report.repeats = Count(word, value);
    } else if (word == "--starts") {
      arguments.report.starts = Count(word, value);
    } else if (word == "--commit") {
      arguments.report.commit = value;
    } else if (word == "--json") {
      arguments.json = value;
    } else {
      throw silt::Error(word + ": no such option; see silt-dense --help");
    }
  }
  if (arguments.folder.empty()) throw silt::Error("give a folder; see silt-dense --help");
  return arguments;
}

std::vector<silt::RawFrame> Read(const Arguments& arguments) {
  silt::RawSequence sequence(arguments.folder);
  const int wanted = arguments.report.frames;
  std::vector<silt::RawFrame> frames;
  while (wanted == 0 || int(frames.size()) < wanted) {
    std::optional<silt::Frame> frame = sequence.Next();
    if (!frame) break;
    const silt::SE3d pose = sequence.truth().at(frames.size()).world_from_camera;
    frames.push_back({sequence.camera(), pose, *std::move(frame)});
  }
  return frames;
}

int Run(const std::vector<std::string>& words) {
  const Arguments arguments = Parse(words);
  const silt::dense::Report report = silt::dense::MakeReport(Read(arguments), arguments.report);
  std::fputs(report.text.c_str(), stdout);
  if (!arguments.json.empty()) silt::WriteFileAtomically(arguments.json, report.json);
  return report.agrees ? 0 : 2;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (!arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h")) {
    std::fputs(kUsage, stdout);
    return 0;
  }
  try {
    return Run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "silt-dense: %s\n", error.what());
    return 1;
  }
}
