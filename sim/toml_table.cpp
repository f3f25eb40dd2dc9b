// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/toml_table.h"

#include <toml++/toml.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {
namespace fs = std::filesystem;

// `root` keeps alive what `table` points into.
struct TomlTable::State {
  std::shared_ptr<const toml::table> root;
  const toml::table* table = nullptr;
  std::string file;
  std::set<std::string> known;
};

namespace {

constexpr double kLargestNumber = 1e12;  // so that products of a few do not overflow

std::string Place(const std::string& file, const toml::node& node) {
  return file + ":" + std::to_string(node.source().begin.line);
}

// The parser quotes what it found, line breaks included.
std::string Printable(std::string_view text) {
  std::string printable(text);
  for (char& c : printable) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return printable;
}

std::string TypeName(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

std::optional<double> FiniteNumber(const toml::node& node) {
  if (!node.is_number()) return {};
  const double value = *node.value<double>();
  return std::abs(value) <= kLargestNumber ? std::optional(value) : std::nullopt;
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}

TomlTable TomlTable::ReadFile(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw Error(file.string() + ": no such file");
  // An open folder reads as an empty file.
  if (!fs::is_regular_file(file, ignored)) throw Error(file.string() + ": is not a regular file");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (in.bad() || !in.is_open()) throw Error(file.string() + ": cannot be read");
  return Parse(text.str(), file.string());
}

TomlTable TomlTable::Parse(const std::string& text, const std::string& file) {
  auto state = std::make_shared<State>();
  state->file = file;
  try {
    state->root = std::make_shared<toml::table>(toml::parse(text, file));
  } catch (const toml::parse_error& e) {
    throw Error(file + ":" + std::to_string(e.source().begin.line) +
                ": is not TOML: " + Printable(e.description()));
  }
  state->table = state->root.get();
  return TomlTable(std::move(state));
}

bool TomlTable::Has(const std::string& key) const {
  state_->known.insert(key);
  return state_->table->contains(key);
}

bool TomlTable::IsString(const std::string& key) const {
  return Has(key) && state_->table->get(key)->is_string();
}

std::string TomlTable::place() const { return Place(state_->file, *state_->table); }

std::string TomlTable::PlaceOf(const std::string& key) const {
  const toml::node* node = state_->table->get(key);
  return node == nullptr ? place() : Place(state_->file, *node);
}

void TomlTable::Fail(const std::string& key, const std::string& problem) const {
  throw Error(PlaceOf(key) + ": " + key + " " + problem);
}

std::string TomlTable::String(const std::string& key) const {
  if (!Has(key)) Fail(key, "is missing: give it a string");
  const toml::node& node = *state_->table->get(key);
  if (!node.is_string()) Fail(key, "must be a string, not " + TypeName(node));
  const auto text = *node.value<std::string>();
  if (Printable(text) != text) Fail(key, "must not hold control characters");
  return text;
}

std::string TomlTable::String(const std::string& key, const std::string& fallback) const {
  return Has(key) ? String(key) : fallback;
}

double TomlTable::Number(const std::string& key) const {
  if (!Has(key)) Fail(key, "is missing: give it a number");
  const toml::node& node = *state_->table->get(key);
  if (!node.is_number()) Fail(key, "must be a number, not " + TypeName(node));
  const std::optional<double> value = FiniteNumber(node);
  if (!value) Fail(key, "must be finite, and at most 1e12 in size");
  return *value;
}

double TomlTable::Number(const std::string& key, double fallback) const {
  return Has(key) ? Number(key) : fallback;
}

int TomlTable::Integer(const std::string& key, int fallback) const {
  if (!Has(key)) return fallback;
  const toml::node& node = *state_->table->get(key);
  if (!node.is_integer()) Fail(key, "must be a whole number, not " + TypeName(node));
  const auto value = *node.value<std::int64_t>();
  if (value != int(value)) Fail(key, "is out of range");
  return int(value);
}

bool TomlTable::Bool(const std::string& key, bool fallback) const {
  if (!Has(key)) return fallback;
  const toml::node& node = *state_->table->get(key);
  if (!node.is_boolean()) Fail(key, "must be true or false, not " + TypeName(node));
  return *node.value<bool>();
}

std::vector<double> TomlTable::Numbers(const std::string& key, std::size_t count) const {
  const std::string wanted = "an array of " + std::to_string(count) + " finite numbers";
  if (!Has(key)) Fail(key, "is missing: give it " + wanted);
  const toml::array* array = state_->table->get(key)->as_array();
  if (array == nullptr || array->size() != count) Fail(key, "must be " + wanted);
  std::vector<double> numbers;
  for (const toml::node& node : *array) {
    const std::optional<double> value = FiniteNumber(node);
    if (!value) Fail(key, "must be " + wanted);
    numbers.push_back(*value);
  }
  return numbers;
}

Vec3d TomlTable::Vector(const std::string& key) const {
  const std::vector<double> xyz = Numbers(key, 3);
  return {xyz[0], xyz[1], xyz[2]};
}

Vec3d TomlTable::Vector(const std::string& key, const Vec3d& fallback) const {
  return Has(key) ? Vector(key) : fallback;
}

std::optional<TomlTable> TomlTable::Table(const std::string& key) const {
  if (!Has(key)) return {};
  const toml::table* table = state_->table->get(key)->as_table();
  if (table == nullptr) Fail(key, "must be written as [" + key + "]");
  auto state = std::make_shared<State>();
  state->root = state_->root;
  state->table = table;
  state->file = state_->file;
  return TomlTable(std::move(state));
}

std::vector<TomlTable> TomlTable::Tables(const std::string& key) const {
  std::vector<TomlTable> tables;
  if (!Has(key)) return tables;
  const toml::array* array = state_->table->get(key)->as_array();
  if (array == nullptr) Fail(key, "must be written as [[" + key + "]]");
  for (const toml::node& node : *array) {
    if (!node.is_table()) Fail(key, "must be written as [[" + key + "]]");
    auto state = std::make_shared<State>();
    state->root = state_->root;
    state->table = node.as_table();
    state->file = state_->file;
    tables.push_back(TomlTable(std::move(state)));
  }
  return tables;
}

std::vector<std::pair<std::string, std::string>> TomlTable::Strings(const std::string& key) const {
  std::vector<std::pair<std::string, std::string>> strings;
  if (!Has(key)) return strings;
  const toml::table* table = state_->table->get(key)->as_table();
  if (table == nullptr) Fail(key, "must be a table of strings, such as { old = \"new\" }");
  for (const auto& [name, node] : *table) {
    if (!node.is_string()) Fail(key, "must hold strings only");
    strings.emplace_back(std::string(name), *node.value<std::string>());
    const auto& [old, value] = strings.back();
    if (Printable(old + value) != old + value) Fail(key, "must not hold control characters");
  }
  return strings;
}

void TomlTable::RejectUnknownKeys() const {
  for (const auto& [name, node] : *state_->table) {
    const std::string key(name);
    if (state_->known.contains(key)) continue;
    std::string known;
    for (const std::string& one : state_->known) known += (known.empty() ? "" : ", ") + one;
    throw Error(Place(state_->file, node) + ": unknown key '" + Printable(key) +
                "'; known here: " + known);
  }
}

}  // namespace silt::sim
