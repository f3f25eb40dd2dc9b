// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/ply_file.h"

#include <bit>
#include <cstring>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"

namespace silt {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie");

template <typename T>
void Append(const T& value, std::string* bytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes->append(raw, sizeof(T));
}

std::string Header(const PlyModel& model) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += "element vertex " + std::to_string(model.points.size()) +
          "\nproperty float x\nproperty float y\nproperty float z\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (!model.triangles.empty()) {
    text += "element face " + std::to_string(model.triangles.size()) +
            "\nproperty list uchar int vertex_indices\n";
  }
  if (!model.edges.empty()) {
    text += "element edge " + std::to_string(model.edges.size()) +
            "\nproperty int vertex1\nproperty int vertex2\n";
  }
  return text + "end_header\n";
}

}  // namespace

void WritePly(const std::filesystem::path& file, const PlyModel& model) {
  SILT_CHECK(model.colors.size() == model.points.size());
  std::string bytes = Header(model);
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    Append(model.points[i].x, &bytes);
    Append(model.points[i].y, &bytes);
    Append(model.points[i].z, &bytes);
    Append(model.colors[i], &bytes);
  }
  for (const std::array<int, 3>& triangle : model.triangles) {
    bytes += char(3);
    for (const int index : triangle) Append(std::int32_t(index), &bytes);
  }
  for (const std::array<int, 2>& edge : model.edges) {
    for (const int index : edge) Append(std::int32_t(index), &bytes);
  }
  WriteFileAtomically(file, bytes);
}

}  // namespace silt
