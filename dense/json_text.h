// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace silt::dense {

// One JSON object, written key by key: all that these results need.
class JsonText {
 public:
  JsonText& Add(std::string_view key, double value);  // null where it is not finite
  JsonText& Add(std::string_view key, std::string_view value);
  JsonText& AddFlag(std::string_view key, bool value);
  JsonText& AddObject(std::string_view key, const JsonText& object);
  JsonText& AddNull(std::string_view key);  // not measured

  std::string Text() const { return "{" + members_ + "}"; }

 private:
  void AddRaw(std::string_view key, const std::string& value);

  std::string members_;
};

// In quotation marks.
std::string Quoted(std::string_view text);

}  // namespace silt::dense
