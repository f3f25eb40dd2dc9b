// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/csv.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

// As RFC 4180 has it: quoted where it holds a comma, a quote or a line break.
std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string Cell(const Json& value) {
  SILT_CHECK(!value.is_structured());
  if (value.is_null()) return "";
  if (value.is_string()) return Quoted(value.get<std::string>());
  if (!value.is_number_float()) return value.dump();
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value.get<double>());
  return text;
}

}  // namespace

std::string FormatCsv(const Json& rows) {
  SILT_CHECK(rows.is_array());
  if (rows.empty()) return "";
  std::string header, lines;
  for (const auto& [key, value] : rows.front().items()) {
    header += (header.empty() ? "" : ",") + Quoted(key);
  }
  for (const Json& row : rows) {
    SILT_CHECK(row.size() == rows.front().size());
    const char* separator = "";
    for (const auto& [key, value] : rows.front().items()) {
      lines += separator + Cell(row.at(key));
      separator = ",";
    }
    lines += "\n";
  }
  return header + "\n" + lines;
}

}  // namespace silt::experiments
