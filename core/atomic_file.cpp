// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "silt/core/error.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

// Unique among the threads of this process and among processes.
fs::path TemporaryNameBeside(const fs::path& file) {
  static std::atomic<unsigned> counter{0};
  fs::path name = "." + file.stem().string() + ".part-" + std::to_string(::getpid()) + "-" +
                  std::to_string(counter++);
  name += file.extension();
  return file.parent_path() / name;
}

bool WriteAll(const fs::path& file, std::string_view contents) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (!out) return false;
  const bool whole = std::fwrite(contents.data(), 1, contents.size(), out) == contents.size();
  const bool flushed = std::fflush(out) == 0;
  return (std::fclose(out) == 0) && whole && flushed;
}

}  // namespace

void WriteFileAtomically(const fs::path& file, const std::function<bool(const fs::path&)>& write) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) {
    throw Error(file.parent_path().string() + ": cannot make the folder: " + error.message());
  }
  const fs::path part = TemporaryNameBeside(file);
  errno = 0;
  std::string reason;
  if (!write(part)) {
    reason = errno != 0 ? std::strerror(errno) : "write failed (is the disk full?)";
  } else if (fs::rename(part, file, error); error) {
    reason = error.message();
  }
  if (reason.empty()) return;
  fs::remove(part, error);
  throw Error(file.string() + ": cannot be written: " + reason);
}

void WriteFileAtomically(const fs::path& file, std::string_view contents) {
  WriteFileAtomically(file, [&](const fs::path& part) { return WriteAll(part, contents); });
}

}  // namespace silt
