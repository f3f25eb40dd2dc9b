// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "silt/sim/archive_io.h"
#include "silt/sim/model_import.h"
#include "silt/sim/scene_file.h"

namespace silt::sim {

// The models that a scene file names. Each archive is opened and each model imported once, however
// many entries use it, in processes of their own (isolated_import.h).
class ModelLibrary {
 public:
  // Throws silt::Error, with the place in the scene file, for the first entry in order that fails.
  explicit ModelLibrary(const SceneFile& file);

  // An entry's model; entries of the same model share its index.
  int IndexOf(const ModelEntry& entry) const { return index_.at(KeyOf(entry)); }
  const std::vector<Model>& models() const { return models_; }

 private:
  using Key = std::pair<std::string, std::string>;  // archive id, file

  static Key KeyOf(const ModelEntry& entry) { return {entry.archive, entry.file}; }
  void OpenArchive(const SceneFile& file, const std::string& id);
  const AssetSource& SourceOf(const ModelEntry& entry) const;

  FolderSource folder_;
  std::map<std::string, std::unique_ptr<Archive>> archives_;  // by id
  std::map<Key, int> index_;
  std::vector<Model> models_;
};

}  // namespace silt::sim
