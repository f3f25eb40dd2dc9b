// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/model_library.h"
#include "silt/sim/model_placement.h"
#include "silt/sim/picture_set.h"
#include "silt/sim/primitives.h"
#include "silt/sim/scene_file.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

constexpr float kFarthest_m = 1e6f;

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

void CheckOverrides(const ModelEntry& entry, const Model& model) {
  for (const auto& [name, index] : entry.materials) {
    const auto has_name = [&](const ModelMaterial& m) { return m.surface.name == name; };
    if (name == "*" || std::any_of(model.materials.begin(), model.materials.end(), has_name)) {
      continue;
    }
    std::string known;
    for (const ModelMaterial& m : model.materials) known += " '" + m.surface.name + "'";
    throw Error(entry.place + ": the model has no material '" + name + "'; it has" + known);
  }
}

ModelPlacement PlacementOf(const ModelEntry& entry) {
  ModelPlacement placement;
  placement.rotation = entry.rotation;
  placement.z_up = entry.z_up;
  placement.size = entry.size;
  placement.scale = entry.scale;
  placement.mirror = entry.mirror;
  placement.yaw_rad = Radians(entry.yaw_deg);
  placement.at = entry.at;
  return placement;
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const SceneFile& file) : file_(file), library_(file) {}

  Scene Build() && {
    scene_.name = file_.name;
    scene_.ambient = file_.ambient.Cast<float>();
    AddEnvironment();
    scene_.exposure = file_.exposure;
    AddFileMaterials();
    AddPrimitives();
    AddModels();
    for (const LightEntry& entry : file_.lights) AddLight(entry);
    AddTextures();
    return std::move(scene_);
  }

 private:
  void AddEnvironment() {
    if (!file_.environment) return;
    const EnvironmentEntry& entry = *file_.environment;
    scene_.environment = std::make_shared<const Environment>(
        entry.file.empty() ? MakeSky(entry.sky)
                           : LoadEnvironment(entry.file, entry.strength, Radians(entry.yaw_deg)));
    scene_.ambient = scene_.environment->mean();
  }

  void AddFileMaterials() {
    for (const MaterialEntry& entry : file_.materials) {
      Material material = entry.material;
      if (!entry.texture.empty()) {
        EncodedPicture picture;
        picture.place = entry.texture.string();
        picture.colour = FolderSource().Read(picture.place);
        material.texture = pictures_.Add(picture, entry.place);
      }
      scene_.materials.push_back(std::move(material));
    }
  }

  Cover CoverOf(int material) const {
    return {std::uint32_t(material), file_.materials[std::size_t(material)].tile_m};
  }

  // Adds the instance that consists of the triangles that `append` appends.
  template <typename Append>
  void AddInstance(const std::string& name, const Append& append) {
    const std::size_t first = scene_.mesh.triangles.size();
    const std::size_t first_vertex = scene_.mesh.positions.size();
    append();
    for (std::size_t v = first_vertex; v < scene_.mesh.positions.size(); ++v) {
      const Vec3f& p = scene_.mesh.positions[v];
      if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest_m) continue;
      throw Error(file_.path.string() + ": '" + name + "' reaches farther than 1000 km away");
    }
    scene_.instances.push_back(
        {name, std::uint32_t(first), std::uint32_t(scene_.mesh.triangles.size() - first)});
  }

  void AddPrimitives() {
    Mesh& mesh = scene_.mesh;
    for (const BoxEntry& entry : file_.boxes) {
      Box box{entry.size, entry.at, Radians(entry.yaw_deg), {}};
      for (std::size_t i = 0; i < box.faces.size(); ++i) box.faces[i] = CoverOf(entry.faces[i]);
      AddInstance(entry.name, [&] { AppendBox(mesh, box); });
    }
    for (const QuadEntry& q : file_.quads) {
      AddInstance(q.name, [&] { AppendQuad(mesh, q.corner, q.u, q.v, CoverOf(q.material)); });
    }
    for (const SphereEntry& s : file_.spheres) {
      AddInstance(s.name, [&] {
        AppendSphere(mesh, {s.center, s.radius, s.segments, CoverOf(s.material)});
      });
    }
    for (const CylinderEntry& c : file_.cylinders) {
      AddInstance(c.name, [&] {
        AppendCylinder(mesh, {c.at, c.radius, c.height, c.segments, CoverOf(c.material)});
      });
    }
  }

  void AddModels() {
    for (const Model& model : library_.models()) {
      scene_material_.emplace_back(model.materials.size(), -1);
      scene_.warnings.insert(scene_.warnings.end(), model.warnings.begin(), model.warnings.end());
    }
    for (const ModelEntry& entry : file_.models) {
      const int index = library_.IndexOf(entry);
      const Model& model = library_.models()[std::size_t(index)];
      CheckOverrides(entry, model);
      std::vector<MaterialUse> uses;
      for (std::size_t i = 0; i < model.materials.size(); ++i) {
        uses.push_back(UseOf(entry, index, i));
      }
      AddInstance(entry.name, [&] { AppendModel(scene_.mesh, model, PlacementOf(entry), uses); });
    }
  }

  MaterialUse UseOf(const ModelEntry& entry, int model_index, std::size_t material_index) {
    const Model& model = library_.models()[std::size_t(model_index)];
    const ModelMaterial& own = model.materials[material_index];
    auto replaced = entry.materials.find(own.surface.name);
    if (replaced == entry.materials.end() && !own.invisible) replaced = entry.materials.find("*");
    if (replaced != entry.materials.end()) {
      const Cover cover = CoverOf(replaced->second);
      return {cover.material, false, cover.tile_m};
    }
    if (own.invisible) return {0, true, {}};
    int& material = scene_material_[std::size_t(model_index)][material_index];
    if (material < 0) material = AddModelMaterial(model, own.surface);
    return {std::uint32_t(material), false, {}};
  }

  int AddModelMaterial(const Model& model, Material surface) {
    const auto index = int(scene_.materials.size());
    if (surface.texture >= 0) {
      surface.texture = pictures_.Add(model.pictures[std::size_t(surface.texture)], "");
      if (model.picture_replaces_diffuse) white_under_picture_.push_back(index);
    }
    scene_.materials.push_back(std::move(surface));
    return index;
  }

  void AddLight(const LightEntry& entry) {
    Material material;
    material.name = entry.name;
    material.diffuse = {};
    material.emission = entry.radiance.Cast<float>();
    material.two_sided = false;
    const Cover cover{std::uint32_t(scene_.materials.size()), {}};
    scene_.materials.push_back(std::move(material));
    AddInstance(entry.name, [&] {
      const Vec3d corner = entry.center - entry.u - entry.v;
      AppendQuad(scene_.mesh, corner, 2.0 * entry.u, 2.0 * entry.v, cover);
    });
    scene_.lights.push_back({entry.center.Cast<float>(), entry.u.Cast<float>(),
                             entry.v.Cast<float>(), entry.radiance.Cast<float>()});
  }

  // Until here the materials' texture indices are those of pictures.
  void AddTextures() {
    std::vector<PictureSet::Decoded> decoded = std::move(pictures_).Decode();
    for (const int i : white_under_picture_) {
      Material& material = scene_.materials[std::size_t(i)];
      if (decoded[std::size_t(material.texture)].texture) material.diffuse = {1, 1, 1};
    }
    std::vector<int> texture_of(decoded.size(), -1);
    for (std::size_t i = 0; i < decoded.size(); ++i) {
      if (decoded[i].texture) {
        texture_of[i] = int(scene_.textures.size());
        scene_.textures.push_back(std::move(*decoded[i].texture));
      } else {
        scene_.warnings.push_back(decoded[i].problem + "; its plain colour is used");
      }
    }
    for (Material& material : scene_.materials) {
      if (material.texture < 0) continue;
      const auto picture = std::size_t(material.texture);
      material.cutout = material.cutout && decoded[picture].has_holes;
      material.texture = texture_of[picture];
    }
  }

  const SceneFile& file_;
  ModelLibrary library_;
  Scene scene_;
  PictureSet pictures_;
  std::vector<std::vector<int>> scene_material_;  // by model and its material; −1: not used yet
  std::vector<int> white_under_picture_;          // materials whose picture replaces their colour
};

}  // namespace

Scene LoadScene(const fs::path& file) {
  const SceneFile parsed = ReadSceneFile(file);
  return SceneBuilder(parsed).Build();
}

}  // namespace silt::sim
