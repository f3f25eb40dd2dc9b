// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/output.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"

namespace silt::experiments {

void Print(std::string_view text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!whole || std::fflush(stdout) != 0) {
    throw Error("standard output: cannot be written (is the disk full?)");
  }
}

void WriteJson(const std::filesystem::path& file, const Json& json) {
  const std::string text = json.dump(2) + "\n";
  if (file == "-") {
    Print(text);
  } else {
    WriteFileAtomically(file, text);
  }
}

Json ReadJson(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw Error(file.string() + ": cannot be read as JSON");
  }
  Json json = Json::parse(in, nullptr, false);
  if (json.is_discarded()) throw Error(file.string() + ": is not JSON");
  return json;
}

}  // namespace silt::experiments
