// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

// A table of a TOML file, read strictly: a missing key, a wrong type, a number that is not finite
// or beyond ±1e12, a string with control characters and a key that nobody asked for are errors,
// "file:line: what is wrong and the mend".
//
// Reading a key marks it as known; call RejectUnknownKeys() once all have been read.
class TomlTable {
 public:
  // Throws silt::Error where the file is missing, a folder, or not TOML.
  static TomlTable ReadFile(const std::filesystem::path& file);
  // The same from memory; `file` is the name in messages.
  static TomlTable Parse(const std::string& text, const std::string& file);

  bool Has(const std::string& key) const;
  bool IsString(const std::string& key) const;

  // The key's value; the second form gives `fallback` where the key is absent.
  std::string String(const std::string& key) const;
  std::string String(const std::string& key, const std::string& fallback) const;
  double Number(const std::string& key) const;
  double Number(const std::string& key, double fallback) const;
  int Integer(const std::string& key, int fallback) const;
  bool Bool(const std::string& key, bool fallback) const;
  // An array of exactly `count` numbers.
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  Vec3d Vector(const std::string& key) const;
  Vec3d Vector(const std::string& key, const Vec3d& fallback) const;
  // The [key] table, where there is one.
  std::optional<TomlTable> Table(const std::string& key) const;
  // All the [[key]] tables, in order; none where the key is absent.
  std::vector<TomlTable> Tables(const std::string& key) const;
  // A table whose values are all strings, in order of its keys.
  std::vector<std::pair<std::string, std::string>> Strings(const std::string& key) const;

  void RejectUnknownKeys() const;

  // "file:line" of the table, or of one of its keys.
  std::string place() const;
  std::string PlaceOf(const std::string& key) const;
  // Throws silt::Error at the key (at the table where it is absent).
  [[noreturn]] void Fail(const std::string& key, const std::string& problem) const;

 private:
  struct State;
  explicit TomlTable(std::shared_ptr<State> state);

  std::shared_ptr<State> state_;
};

}  // namespace silt::sim
