// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_library.h"

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

ModelLibrary::ModelLibrary(const SceneFile& file) {
  std::vector<const ModelEntry*> entries;  // the first of each model
  for (const ModelEntry& entry : file.models) {
    if (!index_.emplace(KeyOf(entry), int(entries.size())).second) continue;
    if (!entry.archive.empty()) OpenArchive(file, entry.archive);
    entries.push_back(&entry);
  }
  models_.resize(entries.size());
  std::vector<std::string> problems(entries.size());
  ParallelFor(int(entries.size()), [&](int i) {
    const ModelEntry& entry = *entries[std::size_t(i)];
    try {
      models_[std::size_t(i)] = ImportModel(SourceOf(entry), entry.file);
    } catch (const Error& e) {
      problems[std::size_t(i)] = entry.place + ": " + e.what();
    }
  });
  for (const std::string& problem : problems) {
    if (!problem.empty()) throw Error(problem);
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
