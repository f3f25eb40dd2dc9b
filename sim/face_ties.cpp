// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/face_ties.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "silt/core/parallel.h"
#include "silt/sim/path_check.h"

namespace silt::sim {
namespace {

constexpr double kLeastArea_m2 = 1e-6;
constexpr double kOffset_m = 2e-4;      // of the point from which the surroundings are looked at
constexpr int kLines = 16;              // that are drawn from there, in all directions
constexpr double kMost = 0.75;          // of them
constexpr std::size_t kMostLooks = 12;  // at the largest overlaps between two instances
// An instance that fills more of the scene's box is a room, which things are inside of.
constexpr double kRoomShare = 0.2;

double Volume(const Bounds& b) {
  const Vec3d size = b.Size().Cast<double>();
  return size.x * size.y * size.z;
}

// Direction i of kLines, spread evenly over the sphere (Vogel's spiral).
Vec3d Direction(int i) {
  const double z = 1 - (2 * i + 1.0) / kLines, angle = 2.39996322972865332 * i + 0.1;
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

class TieFinder {
 public:
  TieFinder(const Scene& scene, const TriangleTree& tree) : scene_(scene), tree_(tree) {
    Bounds all;
    for (const Vec3f& p : scene.mesh.positions) all.Add(p);
    reach_m_ = 2 * Norm(all.Size().Cast<double>()) + 1;
    for (const Instance& instance : scene.instances) {
      Bounds own;
      for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
        own.Add(BoundsOf(scene.mesh, instance.first_triangle + i));
      }
      is_room_.push_back(Volume(own) > kRoomShare * Volume(all));
    }
  }

  std::vector<Tie> Find() const {
    std::map<std::pair<int, int>, std::vector<FaceOverlap>> pairs;
    for (const FaceOverlap& o : FindOverlaps(scene_.mesh, tree_)) {
      pairs[std::minmax({InstanceIndex(o.first), InstanceIndex(o.second)})].push_back(o);
    }
    std::vector<Tie> ties;
    std::vector<std::vector<FaceOverlap>> groups;
    for (auto& [instances, group] : pairs) {
      ties.push_back({instances.first, instances.second, 0, {}, false});
      groups.push_back(std::move(group));
    }
    ParallelFor(int(ties.size()),
                [&](int i) { AddVisible(groups[std::size_t(i)], ties[std::size_t(i)]); });
    std::erase_if(ties, [](const Tie& tie) { return tie.area_m2 < kLeastArea_m2; });
    return ties;
  }

 private:
  int InstanceIndex(std::uint32_t triangle) const {
    return int(&InstanceOf(scene_, triangle) - scene_.instances.data());
  }

  void AddVisible(std::vector<FaceOverlap>& group, Tie& tie) const {
    std::stable_sort(group.begin(), group.end(), [](const FaceOverlap& a, const FaceOverlap& b) {
      return a.area_m2 > b.area_m2;
    });
    if (group.size() > kMostLooks) group.resize(kMostLooks);
    for (const FaceOverlap& overlap : group) {
      if (!IsVisible(overlap)) continue;
      if (tie.area_m2 == 0) tie.middle = overlap.middle;
      tie.area_m2 += overlap.area_m2;
      tie.materials_differ |= MaterialOf(overlap.first) != MaterialOf(overlap.second);
    }
  }

  std::uint32_t MaterialOf(std::uint32_t triangle) const {
    return scene_.mesh.triangles[triangle].material;
  }

  bool IsVisible(const FaceOverlap& overlap) const {
    const Vec3d front = Normalized(AreaVector(CornersOf(scene_.mesh, overlap.first)));
    const bool same = Dot(front, AreaVector(CornersOf(scene_.mesh, overlap.second))) > 0;
    return IsOpen(overlap.middle, front, same) || IsOpen(overlap.middle, -front, false);
  }

  // Whether there is room on the side `up` of a point. Above two fronts it may be the open sky.
  bool IsOpen(const Vec3d& point, const Vec3d& up, bool may_be_sky) const {
    const Vec3d from = point + kOffset_m * up;
    std::map<int, int> left;  // by instance: lines that leave it more often than they enter it
    int upward = 0, missed = 0;
    for (int i = 0; i < kLines; ++i) {
      const Vec3d way = reach_m_ * Direction(i);
      std::map<int, int> exits;
      tree_.VisitPierced(from, from + way, [&](std::uint32_t t) {
        exits[InstanceIndex(t)] += Dot(AreaVector(CornersOf(scene_.mesh, t)), way) > 0 ? 1 : -1;
        return true;
      });
      for (const auto& [instance, count] : exits) left[instance] += count > 0;
      if (Dot(way, up) <= 0) continue;
      ++upward;
      missed += exits.empty() && !(may_be_sky && way.z > 0);
    }
    const auto is_around = [&](const auto& entry) {
      return entry.second >= kMost * kLines && !is_room_[std::size_t(entry.first)];
    };
    return missed < kMost * upward && std::none_of(left.begin(), left.end(), is_around);
  }

  const Scene& scene_;
  const TriangleTree& tree_;
  double reach_m_ = 0;         // from anywhere in the scene to outside of it
  std::vector<bool> is_room_;  // by instance
};

}  // namespace

std::vector<Tie> FindVisibleTies(const Scene& scene, const TriangleTree& tree) {
  return TieFinder(scene, tree).Find();
}

}  // namespace silt::sim
