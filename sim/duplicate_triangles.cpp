// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/duplicate_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>
#include <utility>
#include <vector>

namespace silt::sim {
namespace {

using Key = std::array<std::uint32_t, 3>;

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    return std::size_t(hash ^ hash >> 32);
  }
};

// The same number for vertices at the same place.
std::vector<std::uint32_t> PlaceNumbers(const std::vector<Vec3f>& positions) {
  std::unordered_map<Key, std::uint32_t, KeyHash> numbers;
  numbers.reserve(positions.size());
  std::vector<std::uint32_t> by_vertex;
  by_vertex.reserve(positions.size());
  for (const Vec3f& p : positions) {
    // Adding 0 makes −0 and 0 one place.
    const Key bits{std::bit_cast<std::uint32_t>(p.x + 0.0f),
                   std::bit_cast<std::uint32_t>(p.y + 0.0f),
                   std::bit_cast<std::uint32_t>(p.z + 0.0f)};
    by_vertex.push_back(numbers.emplace(bits, std::uint32_t(numbers.size())).first->second);
  }
  return by_vertex;
}

}  // namespace

void RemoveDuplicateTriangles(Mesh& mesh, const std::function<bool(const Triangle&)>& is_visible) {
  const std::vector<std::uint32_t> place = PlaceNumbers(mesh.positions);
  std::unordered_map<Key, std::size_t, KeyHash> kept_at;
  kept_at.reserve(mesh.triangles.size());
  std::vector<Triangle> kept;
  kept.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Key corners{place[t.vertex[0]], place[t.vertex[1]], place[t.vertex[2]]};
    std::sort(corners.begin(), corners.end());
    const auto [found, is_new] = kept_at.emplace(corners, kept.size());
    if (is_new) {
      kept.push_back(t);
    } else if (!is_visible(kept[found->second]) && is_visible(t)) {
      kept[found->second] = t;
    }
  }
  mesh.triangles = std::move(kept);
}

}  // namespace silt::sim
