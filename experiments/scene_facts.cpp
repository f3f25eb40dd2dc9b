// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "silt/sim/triangle_tree.h"

namespace silt::experiments {
namespace {

using sim::Bounds;

// Without the digits that a float does not have.
Json ToJson(const Vec3f& v) {
  const auto rounded = [](float x) { return std::round(double(x) * 1e6) / 1e6; };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

double Megabytes(std::size_t bytes) { return double(bytes) / (1 << 20); }

std::size_t MeshBytes(const sim::Mesh& mesh) {
  return mesh.positions.size() * sizeof(Vec3f) + mesh.normals.size() * sizeof(Vec3f) +
         mesh.texcoords.size() * sizeof(Vec2f) + mesh.triangles.size() * sizeof(sim::Triangle);
}

Json InstanceFacts(const sim::Scene& scene) {
  Json list = Json::array();
  for (const sim::Instance& instance : scene.instances) {
    Bounds bounds;
    for (std::uint32_t i = 0; i < instance.triangle_count; ++i) {
      bounds.Add(sim::BoundsOf(scene.mesh, instance.first_triangle + i));
    }
    list.push_back({{"name", instance.name}, {"triangles", instance.triangle_count}});
    if (bounds.IsEmpty()) continue;
    list.back()["size_m"] = ToJson(bounds.Size());
    list.back()["low"] = ToJson(bounds.low);
    list.back()["high"] = ToJson(bounds.high);
  }
  return list;
}

Json MaterialFacts(const sim::Scene& scene) {
  std::vector<std::size_t> triangles(scene.materials.size());
  for (const sim::Triangle& t : scene.mesh.triangles) ++triangles[t.material];
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const sim::Material& m = scene.materials[i];
    list.push_back({{"name", m.name},
                    {"triangles", triangles[i]},
                    {"diffuse", ToJson(m.diffuse)},
                    {"texture", m.texture},
                    {"emission", ToJson(m.emission)},
                    {"cutout", m.cutout}});
  }
  return list;
}

// Radiant flux of a diffuse rectangle: π·area·radiance.
Json LightFacts(const sim::Scene& scene) {
  Json list = Json::array();
  for (const sim::RectLight& light : scene.lights) {
    const float area_m2 = 4 * Norm(Cross(light.half_u, light.half_v));
    list.push_back({{"center", ToJson(light.center)},
                    {"area_m2", area_m2},
                    {"radiance", ToJson(light.radiance)},
                    {"flux", ToJson(3.14159265f * area_m2 * light.radiance)}});
  }
  return list;
}

Json TextureFacts(const sim::Scene& scene) {
  Json list = Json::array();
  for (const sim::Texture& t : scene.textures) {
    list.push_back(
        {{"width", t.width()}, {"height", t.height()}, {"memory_mb", Megabytes(t.bytes())}});
  }
  return list;
}

std::string Line(const char* name, const std::string& value) {
  std::string line = std::string(name) + ":";
  line.resize(12, ' ');
  return line + value + "\n";
}

std::string Metres(const Json& size) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f x %.3f x %.3f m", size[0].get<double>(),
                size[1].get<double>(), size[2].get<double>());
  return text;
}

std::string FormatTextures(const Json& textures) {
  if (textures.empty()) return "none";
  double megapixels = 0;
  int widest = 0, narrowest = 1 << 30;
  for (const Json& t : textures) {
    const int width = t["width"], height = t["height"];
    megapixels += width * double(height) / 1e6;
    widest = std::max({widest, width, height});
    narrowest = std::min({narrowest, std::max(width, height)});
  }
  char text[128];
  std::snprintf(text, sizeof text, "%zu, %.1f megapixels, the longer side from %d to %d",
                textures.size(), megapixels, narrowest, widest);
  return text;
}

std::string FormatInstances(const Json& instances, int limit) {
  std::vector<const Json*> order;
  for (const Json& instance : instances) order.push_back(&instance);
  std::stable_sort(order.begin(), order.end(), [](const Json* a, const Json* b) {
    return a->at("triangles").get<int>() > b->at("triangles").get<int>();
  });
  std::string text;
  for (std::size_t i = 0; i < order.size() && i < std::size_t(limit); ++i) {
    char line[160];
    std::snprintf(line, sizeof line, "%10d  %-28s ", order[i]->at("triangles").get<int>(),
                  order[i]->at("name").get<std::string>().c_str());
    text += line;
    if (order[i]->contains("size_m")) text += Metres(order[i]->at("size_m"));
    text += "\n";
  }
  if (order.size() > std::size_t(limit)) {
    text +=
        "            and " + std::to_string(order.size() - std::size_t(limit)) + " more (--all)\n";
  }
  return text;
}

}  // namespace

Json SceneFacts(const sim::Scene& scene, const std::filesystem::path& file) {
  Bounds bounds;
  for (const Vec3f& p : scene.mesh.positions) bounds.Add(p);
  std::size_t texture_bytes = 0;
  for (const sim::Texture& t : scene.textures) texture_bytes += t.bytes();
  return {{"name", scene.name},
          {"file", file.string()},
          {"size_m", ToJson(bounds.Size())},
          {"low", ToJson(bounds.low)},
          {"high", ToJson(bounds.high)},
          {"triangles", scene.mesh.triangles.size()},
          {"vertices", scene.mesh.positions.size()},
          {"mesh_mb", Megabytes(MeshBytes(scene.mesh))},
          {"textures_mb", Megabytes(texture_bytes)},
          {"ambient", ToJson(scene.ambient)},
          {"exposure", scene.exposure},
          {"lights", LightFacts(scene)},
          {"environment", scene.environment != nullptr},
          {"materials", MaterialFacts(scene)},
          {"textures", TextureFacts(scene)},
          {"instances", InstanceFacts(scene)},
          {"warnings", scene.warnings}};
}

std::string FormatSceneFacts(const Json& facts, int instance_limit) {
  const auto number = [&](const char* key) { return std::to_string(facts[key].get<long long>()); };
  char memory[96];
  std::snprintf(memory, sizeof memory, "mesh %.1f MiB, textures %.1f MiB",
                facts["mesh_mb"].get<double>(), facts["textures_mb"].get<double>());
  std::string text;
  text += Line("scene",
               facts["name"].get<std::string>() + " (" + facts["file"].get<std::string>() + ")");
  text += Line("size", Metres(facts["size_m"]));
  text += Line("triangles", number("triangles") + ", vertices " + number("vertices"));
  text += Line("memory", memory);
  const auto shines = [](const Json& m) { return m["emission"] != Json{0.0, 0.0, 0.0}; };
  const auto emitting = std::count_if(facts["materials"].begin(), facts["materials"].end(), shines);
  text += Line("lights", std::to_string(facts["lights"].size()) +
                             (facts["environment"] ? ", an environment" : "") + ", ambient " +
                             facts["ambient"].dump() + ", exposure " + facts["exposure"].dump());
  text += Line("materials", std::to_string(facts["materials"].size()) + ", of which " +
                                std::to_string(emitting) + " emit light");
  text += Line("textures", FormatTextures(facts["textures"]));
  text += Line("instances", std::to_string(facts["instances"].size()) + "; most triangles:");
  text += FormatInstances(facts["instances"], instance_limit);
  text += Line("loading", std::to_string(facts["warnings"].size()) +
                              " warnings (silt scene check tells them, and what else it finds)");
  return text;
}

}  // namespace silt::experiments
