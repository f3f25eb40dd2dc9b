// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/vector.h"
#include "silt/sim/toml_table.h"

// The kinds of values in a scene file. All throw silt::Error "file:line: …" for a bad one.
namespace silt::sim {

// "#rrggbb" or [r, g, b] in 0..1, sRGB-encoded; returned linear.
Vec3f ReadColour(const TomlTable& table, const std::string& key);
// Linear, not negative.
Vec3d ReadRadiance(const TomlTable& table, const std::string& key);
// In 0..1; `fallback` where the key is absent.
double ReadShare(const TomlTable& table, const std::string& key, double fallback);
// Above 0.
double ReadPositive(const TomlTable& table, const std::string& key);
Vec3d ReadSize(const TomlTable& table, const std::string& key);
// In 3..1024; `fallback` where the key is absent.
int ReadSegments(const TomlTable& table, const std::string& key, int fallback);
// The edges "u" and "v", which span an area.
struct Edges {
  Vec3d u, v;
};
Edges ReadEdges(const TomlTable& table);
// Nine numbers, row by row; the identity where the key is absent. Good to 1e-3, as catalogues are.
Mat3d ReadRotation(const TomlTable& table, const std::string& key);

}  // namespace silt::sim
