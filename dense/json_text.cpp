// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/json_text.h"

#include <cmath>
#include <cstdio>

namespace silt::dense {

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    char escaped[8];
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      std::snprintf(escaped, sizeof escaped, "\\u%04x", unsigned(c));
      quoted += escaped;
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

void JsonText::AddRaw(std::string_view key, const std::string& value) {
  members_ += (members_.empty() ? "" : ", ") + Quoted(key) + ": " + value;
}

JsonText& JsonText::Add(std::string_view key, double value) {
  if (!std::isfinite(value)) return AddNull(key);
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  AddRaw(key, text);
  return *this;
}

JsonText& JsonText::Add(std::string_view key, std::string_view value) {
  AddRaw(key, Quoted(value));
  return *this;
}

JsonText& JsonText::AddFlag(std::string_view key, bool value) {
  AddRaw(key, value ? "true" : "false");
  return *this;
}

JsonText& JsonText::AddObject(std::string_view key, const JsonText& object) {
  AddRaw(key, object.Text());
  return *this;
}

JsonText& JsonText::AddNull(std::string_view key) {
  AddRaw(key, "null");
  return *this;
}

}  // namespace silt::dense
