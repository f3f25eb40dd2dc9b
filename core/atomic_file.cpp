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

// Why a write failed, as errno tells it.
std::string Reason() {
  return errno != 0 ? std::strerror(errno) : "write failed (is the disk full?)";
}

[[noreturn]] void Fail(const fs::path& file, const std::string& reason) {
  throw Error(file.string() + ": cannot be written: " + reason);
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw Error(folder.string() + ": cannot make the folder: " + error.message());
}

}  // namespace

// ".STEM.part-PID-COUNT" and an extension, as TemporaryNameBeside makes them.
bool IsPartOfFile(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t at = name.rfind(".part-");
  return name.size() > 1 && name[0] == '.' && at != name.npos && at > 0 &&
         name.find_first_of("0123456789", at) == at + 6;
}

void WriteFileAtomically(const fs::path& file, const std::function<bool(const fs::path&)>& write) {
  MakeFolder(file.parent_path());
  errno = 0;
  // A device or a pipe (/dev/null, /dev/stdout) must not be replaced by a file.
  std::error_code error;
  if (fs::is_other(file, error)) {
    if (!write(file)) Fail(file, Reason());
    return;
  }
  const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file) : file;
  const fs::path part = TemporaryNameBeside(target);
  std::string reason;
  try {
    if (!write(part)) reason = Reason();
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
  if (reason.empty()) {
    fs::rename(part, target, error);
    if (!error) return;
    reason = error.message();
  }
  fs::remove(part, error);
  Fail(file, reason);
}

void WriteFileAtomically(const fs::path& file, std::string_view contents) {
  WriteFileAtomically(file, [&](const fs::path& part) { return WriteAll(part, contents); });
}

}  // namespace silt
