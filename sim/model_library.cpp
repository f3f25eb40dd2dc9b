// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_library.h"

#include "silt/core/error.h"
#include "silt/sim/isolated_import.h"

namespace silt::sim {

ModelLibrary::ModelLibrary(const SceneFile& file) {
  std::vector<const ModelEntry*> entries;  // the first of each model
  for (const ModelEntry& entry : file.models) {
    if (!index_.emplace(KeyOf(entry), int(entries.size())).second) continue;
    if (!entry.archive.empty()) OpenArchive(file, entry.archive);
    entries.push_back(&entry);
  }
  std::vector<ImportTask> tasks;
  for (const ModelEntry* entry : entries) tasks.push_back({&SourceOf(*entry), entry->file});
  std::vector<ImportOutcome> outcomes = ImportIsolated(tasks);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!outcomes[i].model) throw Error(entries[i]->place + ": " + outcomes[i].problem);
    models_.push_back(std::move(*outcomes[i].model));
  }
}

void ModelLibrary::OpenArchive(const SceneFile& file, const std::string& id) {
  if (archives_.contains(id)) return;
  const ArchiveEntry& entry = file.archives.at(id);
  try {
    archives_[id] = std::make_unique<Archive>(entry.file);
  } catch (const Error& e) {
    throw Error(entry.place + ": " + e.what());
  }
}

const AssetSource& ModelLibrary::SourceOf(const ModelEntry& entry) const {
  if (entry.archive.empty()) return folder_;
  return *archives_.at(entry.archive);
}

}  // namespace silt::sim
