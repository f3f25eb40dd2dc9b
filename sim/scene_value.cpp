// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_value.h"

#include <optional>
#include <vector>

#include "silt/core/color.h"

namespace silt::sim {
namespace {

constexpr Mat3d kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// "#rrggbb" to [0, 1]; nothing where it is written differently.
std::optional<Vec3d> ParseHexColour(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return {};
  double channels[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = HexDigit(text[1 + 2 * i]), low = HexDigit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return {};
    channels[i] = (16 * high + low) / 255.0;
  }
  return Vec3d{channels[0], channels[1], channels[2]};
}

bool IsRotation(const Mat3d& m) {
  const Mat3d product = m * Transposed(m);
  for (int i = 0; i < 3; ++i) {
    if (Norm(product.row[i] - kIdentity.row[i]) > 1e-3) return false;
  }
  return Dot(m.row[0], Cross(m.row[1], m.row[2])) > 0;
}

}  // namespace

Vec3f ReadColour(const TomlTable& table, const std::string& key) {
  const std::optional<Vec3d> encoded =
      table.IsString(key) ? ParseHexColour(table.String(key)) : table.Vector(key);
  if (!encoded) table.Fail(key, "must look like \"#rrggbb\" or [r, g, b]");
  for (const double c : {encoded->x, encoded->y, encoded->z}) {
    if (c < 0 || c > 1) table.Fail(key, "must lie in 0..1");
  }
  return {LinearFromSrgb(float(encoded->x)), LinearFromSrgb(float(encoded->y)),
          LinearFromSrgb(float(encoded->z))};
}

Vec3d ReadRadiance(const TomlTable& table, const std::string& key) {
  const Vec3d radiance = table.Vector(key);
  if (radiance.x < 0 || radiance.y < 0 || radiance.z < 0) table.Fail(key, "must not be negative");
  return radiance;
}

double ReadShare(const TomlTable& table, const std::string& key, double fallback) {
  const double value = table.Number(key, fallback);
  if (value < 0 || value > 1) table.Fail(key, "must lie in 0..1");
  return value;
}

double ReadPositive(const TomlTable& table, const std::string& key) {
  const double value = table.Number(key);
  if (value <= 0) table.Fail(key, "must be above 0");
  return value;
}

Vec3d ReadSize(const TomlTable& table, const std::string& key) {
  const Vec3d size = table.Vector(key);
  if (size.x <= 0 || size.y <= 0 || size.z <= 0) table.Fail(key, "must be above 0 in x, y and z");
  return size;
}

int ReadSegments(const TomlTable& table, const std::string& key, int fallback) {
  const int segments = table.Integer(key, fallback);
  if (segments < 3 || segments > 1024) table.Fail(key, "must lie in 3..1024");
  return segments;
}

Edges ReadEdges(const TomlTable& table) {
  const Edges edges{table.Vector("u"), table.Vector("v")};
  const double area = Norm(Cross(edges.u, edges.v));
  if (!(area > 1e-9 * Norm(edges.u) * Norm(edges.v))) {
    table.Fail("v", "must span an area together with u");
  }
  return edges;
}

Mat3d ReadRotation(const TomlTable& table, const std::string& key) {
  if (!table.Has(key)) return kIdentity;
  const std::vector<double> m = table.Numbers(key, 9);
  const Mat3d rotation{{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}}};
  if (!IsRotation(rotation)) table.Fail(key, "must be a rotation matrix, row by row");
  return rotation;
}

}  // namespace silt::sim
