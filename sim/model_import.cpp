// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_import.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <set>

#include "silt/core/error.h"
#include "silt/sim/assimp_io.h"
#include "silt/sim/assimp_material.h"
#include "silt/sim/assimp_mesh.h"
#include "silt/sim/duplicate_triangles.h"

namespace silt::sim {
namespace {

// Where a model brings no normals, edges sharper than this stay edges.
constexpr float kSmoothingAngleDeg = 40;

constexpr unsigned kPostProcessing = aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                     aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                     aiProcess_TransformUVCoords;

std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\r', ' ');
  return text;
}

bool IsGltf(const std::string& name) {
  const std::string lower = LowerCase(name);
  return lower.ends_with(".gltf") || lower.ends_with(".glb");
}

void RemoveDuplicates(Model& model) {
  RemoveDuplicateTriangles(
      model.mesh, [&](const Triangle& t) { return !model.materials[t.material].invisible; });
}

// A model of glass alone is more likely one whose exporter wrote opacity the wrong way round.
void KeepSomethingVisible(Model& model, const std::string& place) {
  const auto is_visible = [&](const Triangle& t) { return !model.materials[t.material].invisible; };
  if (std::any_of(model.mesh.triangles.begin(), model.mesh.triangles.end(), is_visible)) return;
  for (ModelMaterial& material : model.materials) material.invisible = false;
  model.warnings.push_back(place + ": all its materials are transparent; taken as opaque");
}

}  // namespace

Model ImportModel(const AssetSource& source, const std::string& path) {
  const std::optional<std::string> name = source.Find(path);
  if (!name) throw Error(source.Describe(NormalizedAssetPath(path)) + ": no such file");
  const std::string place = source.Describe(*name);

  std::set<std::string> missing;
  Assimp::Importer importer;
  importer.SetIOHandler(MakeAssimpIo(source, missing).release());
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmoothingAngleDeg);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  const aiScene* scene = importer.ReadFile(*name, kPostProcessing);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string why = OneLine(importer.GetErrorString());
    throw Error(place + ": assimp cannot read it: " + (why.empty() ? "it does not say why" : why));
  }

  Model model;
  model.warnings.assign(missing.begin(), missing.end());
  model.picture_replaces_diffuse = !IsGltf(*name);
  AppendMaterials(model, *scene, {source, *name, /*linear_colours=*/IsGltf(*name)});
  AppendMeshes(model.mesh, *scene);
  for (Triangle& t : model.mesh.triangles) {
    if (t.material >= model.materials.size()) t.material = 0;
  }
  if (model.mesh.triangles.empty())
    throw Error(place + ": has no surface: no triangle with an area");
  RemoveDuplicates(model);
  KeepSomethingVisible(model, place);
  return model;
}

}  // namespace silt::sim
