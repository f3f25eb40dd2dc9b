// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace silt::sim {

using Bytes = std::shared_ptr<const std::string>;

// Files that name each other by path, wherever they are kept: in a folder or in an archive. All
// members may be called from several threads.
class AssetSource {
 public:
  virtual ~AssetSource() = default;

  // The true name of the file that `path` means, if there is one: '\' and '/' are the same, '.' and
  // '..' are resolved, and upper and lower case only matter where both exist.
  virtual std::optional<std::string> Find(std::string_view path) const = 0;

  // The whole file, by its true name. Throws silt::Error where it cannot be read.
  virtual Bytes Read(const std::string& name) const = 0;

  // For messages, and different for any two files: "folder/file" or "archive.zip(folder/file)".
  virtual std::string Describe(const std::string& name) const = 0;
};

// '\' as '/', without '.', '..', doubled or trailing separators, and trailing blanks.
std::string NormalizedAssetPath(std::string_view path);
// ASCII only: what artists' tools on Windows mix up.
std::string LowerCase(std::string_view text);
// Everything before the last '/', which is left out; empty where there is none.
std::string FolderOf(std::string_view path);
// `name` as seen from a file at `base`: absolute names are left alone.
std::string BesideAsset(std::string_view base, std::string_view name);

// Plain files; names are absolute paths.
class FolderSource : public AssetSource {
 public:
  std::optional<std::string> Find(std::string_view path) const override;
  Bytes Read(const std::string& name) const override;
  std::string Describe(const std::string& name) const override { return name; }
};

}  // namespace silt::sim
