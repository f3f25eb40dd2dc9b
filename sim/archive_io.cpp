// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/archive_io.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlockBytes = 1 << 16;
constexpr std::uint64_t kLargestFolderBytes = 64u << 20;  // beyond, entries are fetched one by one
constexpr std::uint64_t kLargestEntryBytes = 1u << 30;    // beyond, an entry is refused

using ArchivePointer = std::unique_ptr<archive, int (*)(archive*)>;

std::string Reason(archive* opened) {
  const char* text = archive_error_string(opened);
  std::string reason = text == nullptr ? "unknown reason" : text;
  while (!reason.empty() && std::isspace(static_cast<unsigned char>(reason.back()))) {
    reason.pop_back();
  }
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason;
}

std::string EntryName(archive_entry* entry) {
  const char* name = archive_entry_pathname(entry);
  if (name == nullptr) name = archive_entry_pathname_utf8(entry);
  return name == nullptr ? "" : NormalizedAssetPath(name);
}

// What remains of the current entry.
std::string ReadEntry(archive* opened, const std::string& place) {
  std::string contents;
  while (true) {
    const std::size_t size = contents.size();
    if (size > kLargestEntryBytes) throw Error(place + ": is larger than 1 GiB");
    contents.resize(size + kBlockBytes);
    const la_ssize_t got = archive_read_data(opened, contents.data() + size, kBlockBytes);
    if (got < 0) throw Error(place + ": is damaged: " + Reason(opened));
    contents.resize(size + std::size_t(got));
    if (got == 0) return contents;
  }
}

// Calls visit(archive, entry, name) for each regular file until it returns false.
using Visitor = std::function<bool(archive*, archive_entry*, const std::string&)>;

void ForEachFile(const fs::path& file, const Visitor& visit) {
  const ArchivePointer opened(archive_read_new(), archive_read_free);
  archive_read_support_filter_all(opened.get());
  archive_read_support_format_all(opened.get());
  if (archive_read_open_filename(opened.get(), file.c_str(), kBlockBytes) != ARCHIVE_OK) {
    throw Error(file.string() + ": is not an archive: " + Reason(opened.get()));
  }
  archive_entry* entry = nullptr;
  while (true) {
    const int status = archive_read_next_header(opened.get(), &entry);
    if (status == ARCHIVE_EOF) return;
    if (status < ARCHIVE_WARN) {
      throw Error(file.string() + ": is not an archive, or damaged: " + Reason(opened.get()));
    }
    if (archive_entry_filetype(entry) != AE_IFREG) continue;
    const std::string name = EntryName(entry);
    if (!name.empty() && !visit(opened.get(), entry, name)) return;
  }
}

}  // namespace

Archive::Archive(fs::path file) : file_(std::move(file)) {
  ForEachFile(file_, [this](archive*, archive_entry* entry, const std::string& name) {
    sizes_.emplace(name, archive_entry_size_is_set(entry)
                             ? std::uint64_t(std::max<la_int64_t>(0, archive_entry_size(entry)))
                             : 0);
    return true;
  });
  for (const auto& [name, size] : sizes_) by_lower_case_.emplace(LowerCase(name), name);
}

std::optional<std::string> Archive::Find(std::string_view path) const {
  std::string name = NormalizedAssetPath(path);
  if (sizes_.contains(name)) return name;
  const auto found = by_lower_case_.find(LowerCase(name));
  if (found == by_lower_case_.end()) return {};
  return found->second;
}

std::string Archive::Describe(const std::string& name) const {
  return file_.string() + "(" + name + ")";
}

bool Archive::BelongsTo(const std::string& candidate, const std::string& name) const {
  return FolderOf(candidate) == FolderOf(name);
}

void Archive::Fetch(const std::string& name) const {
  std::uint64_t folder_bytes = 0;
  std::size_t wanted = 0;
  for (const auto& [candidate, size] : sizes_) {
    if (!BelongsTo(candidate, name)) continue;
    folder_bytes += size;
    ++wanted;
  }
  const bool alone = folder_bytes > kLargestFolderBytes;
  if (alone) wanted = 1;
  ForEachFile(file_, [&](archive* opened, archive_entry*, const std::string& candidate) {
    if (alone ? candidate != name : !BelongsTo(candidate, name)) return true;
    if (fetched_.contains(candidate)) return true;  // the first of several entries of one name
    try {
      fetched_[candidate] =
          std::make_shared<const std::string>(ReadEntry(opened, Describe(candidate)));
    } catch (const Error&) {
      // A damaged neighbour matters when it is asked for itself.
      if (candidate == name) throw;
    }
    return --wanted > 0;
  });
}

Bytes Archive::Read(const std::string& name) const {
  const std::scoped_lock lock(mutex_);
  if (!fetched_.contains(name)) Fetch(name);
  const auto found = fetched_.find(name);
  if (found == fetched_.end()) throw Error(Describe(name) + ": no such file in the archive");
  return found->second;
}

}  // namespace silt::sim
