// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_file.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/scene_value.h"
#include "silt/sim/toml_table.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

constexpr int kSegments = 48;
constexpr std::array<const char*, 6> kBoxFaces{"top", "bottom", "front", "back", "left", "right"};

class SceneReader {
 public:
  explicit SceneReader(const fs::path& file) : root_(TomlTable::ReadFile(file)) {
    scene_.path = file;
    folder_ = file.parent_path();
  }

  SceneFile Read() && {
    ReadHead();
    for (const TomlTable& table : root_.Tables("archive")) ReadArchive(table);
    for (const TomlTable& table : root_.Tables("material")) ReadMaterial(table);
    for (const TomlTable& table : root_.Tables("box")) ReadBox(table);
    for (const TomlTable& table : root_.Tables("quad")) ReadQuad(table);
    for (const TomlTable& table : root_.Tables("sphere")) ReadSphere(table);
    for (const TomlTable& table : root_.Tables("cylinder")) ReadCylinder(table);
    for (const TomlTable& table : root_.Tables("model")) ReadModel(table);
    for (const TomlTable& table : root_.Tables("light")) ReadLight(table);
    root_.RejectUnknownKeys();
    if (scene_.boxes.empty() && scene_.quads.empty() && scene_.spheres.empty() &&
        scene_.cylinders.empty() && scene_.models.empty()) {
      throw Error(scene_.path.string() + ":1: the scene is empty: add a [[box]] or a [[model]]");
    }
    return std::move(scene_);
  }

 private:
  void ReadHead() {
    const fs::path folder = fs::absolute(scene_.path).lexically_normal().parent_path();
    scene_.name = root_.String("name", folder.filename().string());
    scene_.ambient = root_.Has("ambient") ? ReadRadiance(root_, "ambient") : Vec3d{0.2, 0.2, 0.2};
    ReadEnvironment();
    if (root_.Has("exposure")) scene_.exposure = ReadPositive(root_, "exposure");
  }

  void ReadEnvironment() {
    const std::optional<TomlTable> table = root_.Table("environment");
    if (!table) return;
    if (root_.Has("ambient")) {
      root_.Fail("ambient", "and [environment] exclude each other: remove one");
    }
    EnvironmentEntry entry;
    if (table->Has("file")) {
      entry.file = ReadFilePath(*table, "file");
      if (table->Has("strength")) entry.strength = ReadPositive(*table, "strength");
      entry.yaw_deg = table->Number("yaw_deg", 0);
    } else {
      entry.sky = {ReadRadiance(*table, "zenith"), ReadRadiance(*table, "horizon"),
                   ReadRadiance(*table, "ground")};
    }
    table->RejectUnknownKeys();
    scene_.environment = entry;
  }

  // A path in the scene file that must name an existing file, made absolute.
  fs::path ReadFilePath(const TomlTable& table, const std::string& key) const {
    const fs::path file = folder_ / table.String(key);
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) {
      table.Fail(key, "names no file: there is no " + file.string());
    }
    return fs::canonical(file);
  }

  std::string ReadName(const TomlTable& table, const std::string& kind, std::size_t number) const {
    return table.String("name", kind + " " + std::to_string(number));
  }

  int MaterialIndex(const TomlTable& table, const std::string& key, const std::string& name) const {
    const auto found = material_index_.find(name);
    if (found == material_index_.end()) {
      table.Fail(key, "names no [[material]] of this file: '" + name + "'");
    }
    return found->second;
  }

  int ReadMaterialName(const TomlTable& table) const {
    return MaterialIndex(table, "material", table.String("material"));
  }

  void ReadArchive(const TomlTable& table) {
    const std::string id = table.String("id");
    const ArchiveEntry entry{ReadFilePath(table, "file"), table.PlaceOf("file")};
    table.RejectUnknownKeys();
    if (!scene_.archives.emplace(id, entry).second) {
      table.Fail("id", "is taken by another [[archive]]: '" + id + "'");
    }
  }

  void ReadMaterial(const TomlTable& table) {
    MaterialEntry entry;
    entry.place = table.place();
    entry.material.name = table.String("name");
    if (table.Has("texture")) {
      entry.texture = ReadFilePath(table, "texture");
      entry.place = table.PlaceOf("texture");
      entry.material.diffuse = {1, 1, 1};
    }
    if (table.Has("color")) entry.material.diffuse = ReadColour(table, "color");
    if (table.Has("tile_m")) {
      const std::vector<double> tile = table.Numbers("tile_m", 2);
      if (tile[0] <= 0 || tile[1] <= 0) table.Fail("tile_m", "must be above 0");
      entry.tile_m = Vec2f{float(tile[0]), float(tile[1])};
    }
    if (table.Has("emission")) {
      entry.material.emission = ReadRadiance(table, "emission").Cast<float>();
    }
    entry.material.cutout = table.Bool("cutout", false);
    entry.material.two_sided = table.Bool("two_sided", true);
    ReadReflection(table, entry.material);
    table.RejectUnknownKeys();
    const int index = int(scene_.materials.size());
    if (!material_index_.emplace(entry.material.name, index).second) {
      table.Fail("name", "is taken by another [[material]]: '" + entry.material.name + "'");
    }
    scene_.materials.push_back(std::move(entry));
  }

  static void ReadReflection(const TomlTable& table, Material& material) {
    material.mirror = table.Bool("mirror", false);
    for (const auto& [key, value] :
         {std::pair{"specular", &material.specular}, std::pair{"metallic", &material.metallic},
          std::pair{"roughness", &material.roughness}}) {
      *value = float(ReadShare(table, key, *value));
      if (material.mirror && table.Has(key)) table.Fail(key, "does not go with mirror = true");
    }
  }

  void ReadBox(const TomlTable& table) {
    BoxEntry entry;
    entry.name = ReadName(table, "box", scene_.boxes.size() + 1);
    const auto faces = table.Strings("faces");
    if (faces.size() < kBoxFaces.size() || table.Has("material")) {
      entry.faces.fill(ReadMaterialName(table));
    }
    for (const auto& [face, material] : faces) {
      const auto* const found = std::find(kBoxFaces.begin(), kBoxFaces.end(), face);
      if (found == kBoxFaces.end()) {
        table.Fail("faces", "has no '" + face + "': top, bottom, front, back, left or right");
      }
      entry.faces[std::size_t(found - kBoxFaces.begin())] = MaterialIndex(table, "faces", material);
    }
    entry.size = ReadSize(table, "size");
    entry.at = table.Vector("at", {});
    entry.yaw_deg = table.Number("yaw_deg", 0);
    table.RejectUnknownKeys();
    scene_.boxes.push_back(std::move(entry));
  }

  void ReadQuad(const TomlTable& table) {
    QuadEntry entry;
    entry.name = ReadName(table, "quad", scene_.quads.size() + 1);
    entry.material = ReadMaterialName(table);
    entry.corner = table.Vector("corner");
    const Edges edges = ReadEdges(table);
    entry.u = edges.u;
    entry.v = edges.v;
    table.RejectUnknownKeys();
    scene_.quads.push_back(std::move(entry));
  }

  void ReadSphere(const TomlTable& table) {
    SphereEntry entry;
    entry.name = ReadName(table, "sphere", scene_.spheres.size() + 1);
    entry.material = ReadMaterialName(table);
    entry.center = table.Vector("center");
    entry.radius = ReadPositive(table, "radius");
    entry.segments = ReadSegments(table, "segments", kSegments);
    table.RejectUnknownKeys();
    scene_.spheres.push_back(std::move(entry));
  }

  void ReadCylinder(const TomlTable& table) {
    CylinderEntry entry;
    entry.name = ReadName(table, "cylinder", scene_.cylinders.size() + 1);
    entry.material = ReadMaterialName(table);
    entry.at = table.Vector("at", {});
    entry.radius = ReadPositive(table, "radius");
    entry.height = ReadPositive(table, "height");
    entry.segments = ReadSegments(table, "segments", kSegments);
    table.RejectUnknownKeys();
    scene_.cylinders.push_back(std::move(entry));
  }

  void ReadModelSource(const TomlTable& table, ModelEntry& entry) const {
    if (!table.Has("archive")) {
      entry.file = ReadFilePath(table, "file").string();
      return;
    }
    entry.archive = table.String("archive");
    entry.file = table.String("file");
    if (!scene_.archives.contains(entry.archive)) {
      table.Fail("archive", "names no [[archive]] of this file: '" + entry.archive + "'");
    }
  }

  void ReadModelAxes(const TomlTable& table, ModelEntry& entry) const {
    const std::string up = table.String("up", "y");
    if (up != "y" && up != "z") table.Fail("up", "must be \"y\" or \"z\"");
    entry.z_up = up == "z";
    entry.rotation = ReadRotation(table, "rotation");
    entry.mirror = table.Bool("mirror", false);
  }

  void ReadModel(const TomlTable& table) {
    ModelEntry entry;
    entry.name = ReadName(table, "model", scene_.models.size() + 1);
    entry.place = table.PlaceOf("file");
    ReadModelSource(table, entry);
    if (table.Has("size")) entry.size = ReadSize(table, "size");
    if (table.Has("scale")) {
      entry.scale = ReadPositive(table, "scale");
      if (entry.size) table.Fail("scale", "and size exclude each other: remove one");
    }
    entry.at = table.Vector("at", {});
    entry.yaw_deg = table.Number("yaw_deg", 0);
    ReadModelAxes(table, entry);
    for (const auto& [old, material] : table.Strings("materials")) {
      entry.materials[old] = MaterialIndex(table, "materials", material);
    }
    table.RejectUnknownKeys();
    scene_.models.push_back(std::move(entry));
  }

  void ReadLight(const TomlTable& table) {
    LightEntry entry;
    entry.name = ReadName(table, "light", scene_.lights.size() + 1);
    entry.center = table.Vector("center");
    const Edges edges = ReadEdges(table);
    entry.u = edges.u;
    entry.v = edges.v;
    entry.radiance = ReadRadiance(table, "radiance");
    table.RejectUnknownKeys();
    scene_.lights.push_back(std::move(entry));
  }

  TomlTable root_;
  SceneFile scene_;
  fs::path folder_;
  std::map<std::string, int> material_index_;
};

}  // namespace

SceneFile ReadSceneFile(const fs::path& file) { return SceneReader(file).Read(); }

}  // namespace silt::sim
