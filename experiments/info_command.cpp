// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/experiments/commands.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/output.h"
#include "silt/experiments/resources.h"

namespace silt::experiments {
namespace {

std::string Text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// One line a fact; nested facts are joined to one line.
std::string Format(const Json& facts) {
  std::string text;
  for (const auto& [key, value] : facts.items()) {
    std::string line = key + ":";
    line.resize(std::max<std::size_t>(line.size() + 1, 16), ' ');
    if (value.is_object()) {
      for (const auto& [name, inner] : value.items()) line += name + " " + Text(inner) + "  ";
    } else if (value.is_array()) {
      for (const Json& inner : value) line += Text(inner) + "  ";
    } else {
      line += Text(value);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace

void AddInfoCommand(CLI::App& program, const Invocation&) {
  const auto json = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand(
      "info", "Say what this build is and can do: versions, devices, SIMD level, scenes");
  command->add_option("--json", *json, "Write the same to this file (-: to stdout)");
  command->callback([json] {
    Json facts = BuildFacts();
    facts["scenes"] = SceneNames();
    if (!json->empty()) WriteJson(*json, facts);
    if (*json != "-") Print(Format(facts));
  });
}

}  // namespace silt::experiments
