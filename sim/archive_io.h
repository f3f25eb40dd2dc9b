// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <mutex>

#include "silt/sim/asset_source.h"

namespace silt::sim {

// The files inside a .zip, .sh3f, .tar.gz or whatever else libarchive reads. Opening lists the
// entries; the first Read in a folder of the archive fetches that whole folder in one pass (if it
// is not huge), since a model's files lie together. Fetched files are kept as long as the archive.
class Archive : public AssetSource {
 public:
  // Throws silt::Error where the file is not an archive.
  explicit Archive(std::filesystem::path file);

  std::optional<std::string> Find(std::string_view path) const override;
  Bytes Read(const std::string& name) const override;
  std::string Describe(const std::string& name) const override;

 private:
  void Fetch(const std::string& name) const;
  bool BelongsTo(const std::string& candidate, const std::string& name) const;

  std::filesystem::path file_;
  std::map<std::string, std::uint64_t> sizes_;        // by name, as entries declare them
  std::map<std::string, std::string> by_lower_case_;  // the first name in order
  mutable std::mutex mutex_;
  mutable std::map<std::string, Bytes> fetched_;
};

}  // namespace silt::sim
