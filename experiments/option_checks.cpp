// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/option_checks.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <string>

#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

// The whole text as a number; from_chars takes no leading spaces and no locale.
template <typename Number>
bool Parses(const std::string& text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

std::string Complaint(const std::string& text, const char* kind, double low, double high) {
  char range[96];
  std::snprintf(range, sizeof range, " from %.10g to %.10g", low, high);
  return "'" + text + "' is not " + kind + range;
}

}  // namespace

CLI::Option* RequireNumber(CLI::Option* option, double low, double high) {
  return option->check([low, high](const std::string& text) {
    double value = 0;
    const bool good = Parses(text, value) && value >= low && value <= high;
    return good ? std::string() : Complaint(text, "a number", low, high);
  });
}

CLI::Option* RequireInteger(CLI::Option* option, long long low, long long high) {
  return option->check([low, high](const std::string& text) {
    long long value = 0;
    const bool good = Parses(text, value) && value >= low && value <= high;
    return good ? std::string() : Complaint(text, "an integer", double(low), double(high));
  });
}

CLI::Option* AddBackendOption(CLI::App& command, std::string& backend) {
  return command.add_option("--backend", backend, kBackendHelp)
      ->transform([](const std::string& name) { return ResolvedBackend(name); })
      ->capture_default_str();
}

}  // namespace silt::experiments
