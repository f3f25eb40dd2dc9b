// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "silt/sim/face_ties.h"
#include "silt/sim/triangle_tree.h"

namespace silt::sim {
namespace {

constexpr float kContact_m = 0.01f;      // as near as things that stand or hang are to others
constexpr double kInvertedShare = 0.01;  // of an instance; a few are folds of a smooth surface
constexpr float kBelowFloor_m = -0.005f;

bool IsFinite(const Vec3f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

float Largest(const Vec3f& v) { return std::max({v.x, v.y, v.z}); }

std::string Named(const Instance& instance) { return "'" + instance.name + "'"; }

std::string Counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

class SceneChecker {
 public:
  explicit SceneChecker(const Scene& scene) : scene_(scene), tree_(scene.mesh) {}

  std::vector<SceneFinding> Check() && {
    for (const std::string& warning : scene_.warnings) Warn(warning);
    CheckLight();
    for (const Material& material : scene_.materials) CheckMaterial(material);
    for (const Instance& instance : scene_.instances) {
      CheckTriangles(instance);
      CheckPlace(instance);
    }
    CheckTies();
    // Errors first; else as found.
    std::stable_partition(findings_.begin(), findings_.end(),
                          [](const SceneFinding& f) { return f.is_error; });
    return std::move(findings_);
  }

 private:
  void Warn(std::string message) { findings_.push_back({false, std::move(message)}); }
  void Fail(std::string message) { findings_.push_back({true, std::move(message)}); }

  void CheckLight() {
    const auto shines = [](const Material& m) { return Largest(m.emission) > 0; };
    const bool emits = std::any_of(scene_.materials.begin(), scene_.materials.end(), shines);
    if (!scene_.lights.empty() || scene_.environment || Largest(scene_.ambient) > 0) return;
    if (emits) {
      Warn(
          "materials that emit are all that lights the scene: paths aim at them, but baked light "
          "finds them by chance, with noise; add a [[light]]");
    } else {
      Fail("nothing lights the scene: add a [[light]] or an ambient radiance");
    }
  }

  void CheckMaterial(const Material& m) {
    if (!IsFinite(m.diffuse) || !IsFinite(m.emission)) {
      Fail("material '" + m.name + "' has a colour that is not finite");
    } else if (Largest(m.diffuse) > 1) {
      Fail("material '" + m.name +
           "' reflects more than it receives: " + std::to_string(Largest(m.diffuse)) + " of 1");
    }
    for (const float share : {m.specular, m.metallic, m.roughness}) {
      if (share >= 0 && share <= 1) continue;
      Fail("material '" + m.name + "' has a specular, metallic or roughness that is not in 0..1");
      break;
    }
  }

  void CheckTriangles(const Instance& instance) {
    std::size_t flat = 0, inverted = 0;
    bool broken = false;
    for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
      const std::uint32_t t = instance.first_triangle + i;
      const Vec3d front = AreaVector(CornersOf(scene_.mesh, t));
      Vec3f normals;
      for (const std::uint32_t v : scene_.mesh.triangles[t].vertex) {
        const Vec3f& n = scene_.mesh.normals[v];
        broken |= !IsFinite(scene_.mesh.positions[v]) || !(std::abs(Dot(n, n) - 1) < 0.01f);
        normals += n;
      }
      flat += !(Norm(front) > 1e-14);
      inverted += Dot(normals.Cast<double>(), front) < 0;
    }
    if (instance.triangle_count == 0) Fail(Named(instance) + " has no triangle");
    if (broken) Fail(Named(instance) + " has vertices or normals that are not finite, or no unit");
    if (flat > 0) Warn(Named(instance) + " has " + Counted(flat, "triangle") + " without area");
    if (inverted > kInvertedShare * instance.triangle_count) {
      Warn(Named(instance) + " has " + Counted(inverted, "triangle") + " of " +
           std::to_string(instance.triangle_count) + " whose normals point to the back");
    }
  }

  // What shines all over is a backdrop or a light, which may be anywhere.
  void CheckPlace(const Instance& instance) {
    Bounds bounds;
    bool shines = true;
    for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
      const std::uint32_t t = instance.first_triangle + i;
      bounds.Add(BoundsOf(scene_.mesh, t));
      shines &= Largest(scene_.materials[scene_.mesh.triangles[t].material].emission) > 0;
    }
    if (bounds.IsEmpty() || shines || scene_.instances.size() < 2) return;
    if (bounds.low.z < kBelowFloor_m) {
      char text[80];
      std::snprintf(text, sizeof text, " reaches %.0f mm below the floor (z = 0)",
                    -1000.0 * bounds.low.z);
      Warn(Named(instance) + text);
    }
    bool touches = false;
    tree_.Visit(bounds.Grown(kContact_m), [&](std::uint32_t t) {
      touches =
          t - instance.first_triangle >= instance.triangle_count;  // unsigned: before or after
      return !touches;
    });
    if (!touches) Warn(Named(instance) + " floats: nothing else is within 10 mm of it");
  }

  void CheckTies() {
    for (const Tie& tie : FindVisibleTies(scene_, tree_)) {
      const Instance& a = scene_.instances[std::size_t(tie.first_instance)];
      const Instance& b = scene_.instances[std::size_t(tie.second_instance)];
      char text[160];
      std::snprintf(text, sizeof text, " over %.2f cm2 at (%.3f, %.3f, %.3f)%s", 1e4 * tie.area_m2,
                    tie.middle.x, tie.middle.y, tie.middle.z,
                    tie.materials_differ ? "" : ", of one material");
      Warn((&a == &b ? Named(a) + " has faces that lie on each other"
                     : Named(a) + " and " + Named(b) + " have faces in the same place") +
           text);
    }
  }

  const Scene& scene_;
  TriangleTree tree_;
  std::vector<SceneFinding> findings_;
};

}  // namespace

std::vector<SceneFinding> CheckScene(const Scene& scene) { return SceneChecker(scene).Check(); }

}  // namespace silt::sim
