// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/flow_file.h"

#include <bit>
#include <cstdint>
#include <string>

#include "silt/core/atomic_file.h"

namespace silt {

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

void WriteFlow(const std::filesystem::path& file, const Image<Vec2f>& flow_px) {
  const std::int32_t size[2] = {flow_px.width(), flow_px.height()};
  static_assert(sizeof(Vec2f) == 2 * sizeof(float));
  std::string bytes = "PIEH";  // 202021.25f
  bytes.append(reinterpret_cast<const char*>(size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(flow_px.data()), flow_px.size() * sizeof(Vec2f));
  WriteFileAtomically(file, bytes);
}

}  // namespace silt
