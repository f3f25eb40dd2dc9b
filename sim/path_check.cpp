// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "silt/core/error.h"
#include "silt/sim/triangle_tree.h"

namespace silt::sim {
namespace {

constexpr double kLongestStep_m = 0.005;
constexpr double kShortestTick_s = 0.001, kLongestTick_s = 0.01;
// Two times near an instance that are farther apart are two contacts.
constexpr double kSeparate_s = 0.25;

struct Step {
  double time_s;
  Vec3d position;
};

// Where the camera is whenever it has moved on by step_m, or kLongestTick_s have passed.
std::vector<Step> StepsOf(const CameraPath& path, const PathCheckOptions& options, double step_m) {
  const double rest_s = path.duration_s() - options.start_s;
  const double duration_s = options.duration_s > 0 ? options.duration_s : rest_s;
  if (!(duration_s > 0 && duration_s <= rest_s + 1e-6)) {
    throw Error("the stretch to check leaves the camera path, which lasts " +
                std::to_string(path.duration_s()) + " s");
  }
  const double tick_s = std::max(kShortestTick_s, duration_s / 1e6);
  const auto ticks = std::max<std::int64_t>(1, std::llround(duration_s / tick_s));
  std::vector<Step> steps;
  for (std::int64_t k = 0; k <= ticks; ++k) {
    const double time_s = options.start_s + duration_s * double(k) / double(ticks);
    const Vec3d position = path.WorldFromCamera(time_s).translation;
    const bool far = steps.empty() || Norm(position - steps.back().position) >= step_m ||
                     time_s - steps.back().time_s >= kLongestTick_s - 1e-9;
    if (far || k == ticks) steps.push_back({time_s, position});
  }
  return steps;
}

// The triangles near the path as a whole.
TriangleTree TreeNear(const Mesh& mesh, const std::vector<Step>& steps, float margin) {
  Bounds all;
  for (const Step& step : steps) all.Add(step.position.Cast<float>());
  all = all.Grown(margin);
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (BoundsOf(mesh, t).Overlaps(all)) near.push_back(t);
  }
  return TriangleTree(mesh, std::move(near));
}

class ContactFinder {
 public:
  ContactFinder(const Scene& scene, double clearance_m)
      : scene_(scene), clearance_m_(clearance_m) {}

  std::vector<PathContact> Find(const std::vector<Step>& steps) {
    const auto margin = float(clearance_m_ + 1e-4);
    const TriangleTree tree = TreeNear(scene_.mesh, steps, margin);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Step& from = steps[i > 0 ? i - 1 : 0];
      Bounds box;
      box.Add(from.position.Cast<float>());
      box.Add(steps[i].position.Cast<float>());
      tree.Visit(box.Grown(margin), [&](std::uint32_t triangle) {
        Look(triangle, from, steps[i]);
        return true;
      });
    }
    const auto earlier = [](const PathContact& a, const PathContact& b) {
      return a.start_s < b.start_s;
    };
    std::stable_sort(contacts_.begin(), contacts_.end(), earlier);
    return std::move(contacts_);
  }

 private:
  void Look(std::uint32_t triangle, const Step& from, const Step& to) {
    const Corners corners = CornersOf(scene_.mesh, triangle);
    const bool crosses = Pierces(from.position, to.position, corners);
    const double distance_m = crosses ? 0 : Norm(NearestPoint(corners, to.position) - to.position);
    if (!crosses && !(distance_m < clearance_m_)) return;
    PathContact& contact = ContactAt(to.time_s, InstanceOf(scene_, triangle));
    contact.end_s = to.time_s;
    if (distance_m < contact.distance_m || (crosses && !contact.crosses)) {
      contact.distance_m = distance_m;
      contact.nearest_s = to.time_s;
    }
    contact.crosses |= crosses;
  }

  // The contact with an instance that goes on at a time, or a new one.
  PathContact& ContactAt(double time_s, const Instance& instance) {
    const auto [last, is_new] = last_.try_emplace(&instance, contacts_.size());
    if (!is_new && time_s - contacts_[last->second].end_s <= kSeparate_s) {
      return contacts_[last->second];
    }
    last->second = contacts_.size();
    contacts_.push_back({instance.name, time_s, time_s, time_s, clearance_m_ + 1, false});
    return contacts_.back();
  }

  const Scene& scene_;
  double clearance_m_;
  std::vector<PathContact> contacts_;
  std::map<const Instance*, std::size_t> last_;  // index of each instance's latest contact
};

}  // namespace

void PathCheckOptions::Validate() const {
  if (!(clearance_m >= 0 && clearance_m <= 10)) throw Error("the clearance must be in 0 … 10 m");
  if (!(start_s >= 0)) throw Error("the start must be 0 s or later");
  if (!(duration_s >= 0)) throw Error("the duration must be 0 s or more");
}

bool PathCheck::Crosses() const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const PathContact& contact) { return contact.crosses; });
}

PathCheck CheckPath(const CameraPath& path, const Scene& scene, const PathCheckOptions& options) {
  options.Validate();
  PathCheck check;
  check.step_m =
      options.clearance_m > 0 ? std::min(kLongestStep_m, options.clearance_m / 8) : kLongestStep_m;
  const std::vector<Step> steps = StepsOf(path, options, check.step_m);
  check.contacts = ContactFinder(scene, options.clearance_m).Find(steps);
  return check;
}

std::string Describe(const PathContact& contact) {
  char text[160];
  if (contact.crosses) {
    std::snprintf(text, sizeof text, "at %.2f s crosses ", contact.nearest_s);
    return text + ("'" + contact.instance + "'");
  }
  std::snprintf(text, sizeof text, "at %.2f s (%.2f to %.2f s) is only %.0f mm from ",
                contact.nearest_s, contact.start_s, contact.end_s, 1000 * contact.distance_m);
  return text + ("'" + contact.instance + "'");
}

const Instance& InstanceOf(const Scene& scene, std::uint32_t triangle) {
  const auto after = [](std::uint32_t t, const Instance& instance) {
    return t < instance.first_triangle;
  };
  const auto next =
      std::upper_bound(scene.instances.begin(), scene.instances.end(), triangle, after);
  SILT_CHECK(next != scene.instances.begin());
  return *(next - 1);
}

}  // namespace silt::sim
