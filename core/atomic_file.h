// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace silt {

// Writes the whole file under a temporary name beside it, then renames: readers see the old file or
// the new one, never a part, and a failure (a full disk, say) leaves the old one as it was. Makes
// missing folders, follows links, and writes devices in place. Throws silt::Error with the path and
// the reason.
void WriteFileAtomically(const std::filesystem::path& file, std::string_view contents);

// The same for libraries that insist on writing a file themselves: `write` gets the temporary path,
// which ends in the extension of `file`, and returns whether it succeeded.
void WriteFileAtomically(const std::filesystem::path& file,
                         const std::function<bool(const std::filesystem::path&)>& write);

// Whether a file is such a temporary one, which a process that was killed has left.
bool IsPartOfFile(const std::filesystem::path& file);

}  // namespace silt
