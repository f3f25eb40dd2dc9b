// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/asset_source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

// The entry of `folder` whose name differs from `name` in case only; of several, the first in
// order.
std::optional<std::string> FindIgnoringCase(const fs::path& folder, const std::string& name) {
  std::optional<std::string> best;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string candidate = entry.path().filename().string();
    if (LowerCase(candidate) == name && (!best || candidate < *best)) best = candidate;
  }
  return best;
}

}  // namespace

std::string NormalizedAssetPath(std::string_view path) {
  // Materials' files are full of blanks at the ends of their lines.
  const std::size_t last = path.find_last_not_of(" \t\r\n");
  std::string slashes(path.substr(0, last == std::string_view::npos ? 0 : last + 1));
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  std::string normal = fs::path(slashes).lexically_normal().generic_string();
  while (normal.size() > 1 && normal.back() == '/') normal.pop_back();
  return normal == "." ? "" : normal;
}

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return lower;
}

std::string FolderOf(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

std::string BesideAsset(std::string_view base, std::string_view name) {
  return NormalizedAssetPath((fs::path(FolderOf(base)) / NormalizedAssetPath(name)).string());
}

std::optional<std::string> FolderSource::Find(std::string_view path) const {
  const std::string normal = NormalizedAssetPath(path);
  if (normal.empty()) return {};
  std::error_code ignored;
  if (fs::is_regular_file(normal, ignored)) return fs::absolute(normal).string();
  fs::path found = "/";
  const fs::path absolute = fs::absolute(normal);
  for (const fs::path& part : absolute.relative_path()) {
    std::optional<std::string> name = part.string();
    if (!fs::exists(found / part, ignored)) name = FindIgnoringCase(found, LowerCase(*name));
    if (!name) return {};
    found /= *name;
  }
  if (!fs::is_regular_file(found, ignored)) return {};
  return found.string();
}

Bytes FolderSource::Read(const std::string& name) const {
  std::ifstream in(name, std::ios::binary);
  std::ostringstream contents;
  if (in.peek() != std::ifstream::traits_type::eof()) contents << in.rdbuf();
  if (!in.is_open() || in.bad()) throw Error(name + ": cannot be read");
  return std::make_shared<const std::string>(contents.str());
}

}  // namespace silt::sim
