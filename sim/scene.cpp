// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene.h"

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/archive_io.h"
#include "silt/sim/model_import.h"
#include "silt/sim/model_placement.h"
#include "silt/sim/picture.h"
#include "silt/sim/primitives.h"
#include "silt/sim/scene_file.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t kHoleBelow = 128;  // opacity

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

// ParallelFor, such that of several errors the first in order is the one that is reported.
void ParallelForInOrder(std::size_t n, const std::function<void(std::size_t)>& body) {
  std::vector<std::exception_ptr> errors(n);
  ParallelFor(int(n), [&](int i) {
    try {
      body(std::size_t(i));
    } catch (...) {
      errors[std::size_t(i)] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

// Runs `body`, putting the place in the scene file before the message of its error.
template <typename Body>
auto AtPlace(const std::string& place, const Body& body) {
  try {
    return body();
  } catch (const Error& e) {
    throw Error(place + ": " + e.what());
  }
}

bool HasHoles(const Image<Rgba8>& picture) {
  return std::any_of(picture.begin(), picture.end(),
                     [](const Rgba8& texel) { return texel.a < kHoleBelow; });
}

class SceneBuilder {
 public:
  explicit SceneBuilder(SceneFile file) : file_(std::move(file)) {}

  Scene Build() && {
    scene_.name = file_.name;
    scene_.ambient = file_.ambient.Cast<float>();
    scene_.exposure = file_.exposure;
    AddFileMaterials();
    AddPrimitives();
    ImportModels();
    for (const ModelEntry& entry : file_.models) AddModel(entry);
    for (const LightEntry& entry : file_.lights) AddLight(entry);
    DecodePictures();
    return std::move(scene_);
  }

 private:
  // A picture waiting to be decoded.
  struct Picture {
    EncodedPicture encoded;
    std::string place;  // in the scene file; empty: a model's, whose lack is only a warning
    std::optional<Texture> texture;
    bool has_holes = false;
    std::string problem;
  };

  // A model and which scene material each of its own became, if it was used yet.
  struct Imported {
    Model model;
    std::vector<int> scene_material;
  };

  using ModelKey = std::pair<std::string, std::string>;  // archive id, file

  void AddFileMaterials() {
    for (const MaterialEntry& entry : file_.materials) {
      Material material = entry.material;
      if (!entry.texture.empty()) {
        const std::string name = entry.texture.string();
        EncodedPicture picture;
        picture.place = fs::absolute(entry.texture).lexically_normal().string();
        picture.colour = AtPlace(entry.place, [&] { return FolderSource().Read(name); });
        material.texture = PictureIndex(picture, entry.place);
      }
      scene_.materials.push_back(std::move(material));
    }
  }

  int PictureIndex(const EncodedPicture& picture, const std::string& place) {
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      if (!pictures_[i].encoded.IsSameAs(picture)) continue;
      if (pictures_[i].place.empty()) pictures_[i].place = place;
      return int(i);
    }
    pictures_.push_back({picture, place, {}, false, {}});
    return int(pictures_.size()) - 1;
  }

  Cover CoverOf(int material) const {
    return {std::uint32_t(material), file_.materials[std::size_t(material)].tile_m};
  }

  // Adds the instance that consists of the triangles that `append` appends.
  template <typename Append>
  void AddInstance(const std::string& name, const Append& append) {
    const std::size_t first = scene_.mesh.triangles.size();
    append();
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

  // Opens each archive and reads each model once, however many entries use it.
  void ImportModels() {
    std::vector<const ModelEntry*> first_uses;
    for (const ModelEntry& entry : file_.models) {
      if (!models_.contains({entry.archive, entry.file})) first_uses.push_back(&entry);
      models_[{entry.archive, entry.file}];
      if (!entry.archive.empty() && !archives_.contains(entry.archive)) {
        const ArchiveEntry& archive = file_.archives.at(entry.archive);
        archives_[entry.archive] =
            AtPlace(archive.place, [&] { return std::make_unique<Archive>(archive.file); });
      }
    }
    ParallelForInOrder(first_uses.size(), [&](std::size_t i) {
      const ModelEntry& entry = *first_uses[i];
      Imported& imported = models_.at({entry.archive, entry.file});
      imported.model =
          AtPlace(entry.place, [&] { return ImportModel(SourceOf(entry), entry.file); });
      imported.scene_material.assign(imported.model.materials.size(), -1);
    });
    for (const ModelEntry* entry : first_uses) {
      for (const std::string& warning : models_.at({entry->archive, entry->file}).model.warnings) {
        scene_.warnings.push_back(warning);
      }
    }
  }

  const AssetSource& SourceOf(const ModelEntry& entry) const {
    if (entry.archive.empty()) return folder_;
    return *archives_.at(entry.archive);
  }

  void AddModel(const ModelEntry& entry) {
    Imported& imported = models_.at({entry.archive, entry.file});
    CheckOverrides(entry, imported.model);
    std::vector<MaterialUse> uses;
    for (std::size_t i = 0; i < imported.model.materials.size(); ++i) {
      uses.push_back(UseOf(entry, imported, i));
    }
    ModelPlacement placement;
    placement.rotation = entry.rotation;
    placement.z_up = entry.z_up;
    placement.size = entry.size;
    placement.scale = entry.scale;
    placement.mirror = entry.mirror;
    placement.yaw_rad = Radians(entry.yaw_deg);
    placement.at = entry.at;
    AddInstance(entry.name, [&] { AppendModel(scene_.mesh, imported.model, placement, uses); });
  }

  static void CheckOverrides(const ModelEntry& entry, const Model& model) {
    for (const auto& [name, index] : entry.materials) {
      const auto has_name = [&](const ModelMaterial& m) { return m.surface.name == name; };
      if (name == "*" || std::any_of(model.materials.begin(), model.materials.end(), has_name)) {
        continue;
      }
      std::string known;
      for (const ModelMaterial& m : model.materials) known += " '" + m.surface.name + "'";
      throw Error(entry.place + ": the model has no material '" + name + "', it has" + known);
    }
  }

  MaterialUse UseOf(const ModelEntry& entry, Imported& imported, std::size_t index) {
    const ModelMaterial& own = imported.model.materials[index];
    auto replaced = entry.materials.find(own.surface.name);
    if (replaced == entry.materials.end() && !own.invisible) replaced = entry.materials.find("*");
    if (replaced != entry.materials.end()) {
      const Cover cover = CoverOf(replaced->second);
      return {cover.material, false, cover.tile_m};
    }
    if (own.invisible) return {0, true, {}};
    int& material = imported.scene_material[index];
    if (material < 0) material = AddModelMaterial(imported.model, own.surface);
    return {std::uint32_t(material), false, {}};
  }

  int AddModelMaterial(const Model& model, Material surface) {
    const auto index = int(scene_.materials.size());
    if (surface.texture >= 0) {
      surface.texture = PictureIndex(model.pictures[std::size_t(surface.texture)], "");
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
      AppendQuad(scene_.mesh, entry.center - entry.u - entry.v, 2.0 * entry.u, 2.0 * entry.v,
                 cover);
    });
    scene_.lights.push_back({entry.center.Cast<float>(), entry.u.Cast<float>(),
                             entry.v.Cast<float>(), entry.radiance.Cast<float>()});
  }

  void DecodePictures() {
    ParallelForInOrder(pictures_.size(), [this](std::size_t i) { Decode(pictures_[i]); });
    std::vector<int> texture_of(pictures_.size(), -1);
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      if (!pictures_[i].texture) {
        scene_.warnings.push_back(pictures_[i].problem);
        continue;
      }
      texture_of[i] = int(scene_.textures.size());
      scene_.textures.push_back(std::move(*pictures_[i].texture));
    }
    for (const int i : white_under_picture_) {
      Material& material = scene_.materials[std::size_t(i)];
      if (texture_of[std::size_t(material.texture)] >= 0) material.diffuse = {1, 1, 1};
    }
    for (Material& material : scene_.materials) {
      if (material.texture < 0) continue;
      const auto picture = std::size_t(material.texture);
      material.cutout = material.cutout && pictures_[picture].has_holes;
      material.texture = texture_of[picture];
    }
  }

  static void Decode(Picture& picture) {
    try {
      Image<Rgba8> decoded = DecodePicture(picture.encoded);
      picture.encoded = {};
      picture.has_holes = HasHoles(decoded);
      picture.texture.emplace(std::move(decoded));
    } catch (const Error& e) {
      picture.problem = e.what();
      if (!picture.place.empty()) throw Error(picture.place + ": " + e.what());
    }
  }

  SceneFile file_;
  Scene scene_;
  FolderSource folder_;
  std::map<std::string, std::unique_ptr<Archive>> archives_;  // by id
  std::map<ModelKey, Imported> models_;
  // Until DecodePictures(), the materials' texture indices point here.
  std::vector<Picture> pictures_;
  std::vector<int> white_under_picture_;  // materials
};

}  // namespace

Scene LoadScene(const std::filesystem::path& file) {
  return SceneBuilder(ReadSceneFile(file)).Build();
}

}  // namespace silt::sim
