// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/assimp_material.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr float kOpaqueEnough = 0.5f;
constexpr float kDielectric = 0.04f;  // reflectance of glass, plastic and varnish

// The file of a texture slot; empty where the material has none.
std::string TexturePath(const aiMaterial& material, std::initializer_list<aiTextureType> types) {
  for (const aiTextureType type : types) {
    aiString path;
    if (material.GetTexture(type, 0, &path) == AI_SUCCESS && path.length > 0) return path.C_Str();
  }
  return {};
}

std::string String(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  aiString value;
  material.Get(key, type, index, value);
  return value.C_Str();
}

float FiniteOr(float value, float fallback) { return std::isfinite(value) ? value : fallback; }

const aiTexture* EmbeddedTexture(const aiScene& scene, const std::string& path) {
  if (!path.starts_with('*')) return scene.GetEmbeddedTexture(path.c_str());
  unsigned index = 0;
  const auto parsed = std::from_chars(path.data() + 1, path.data() + path.size(), index);
  if (parsed.ec != std::errc() || index >= scene.mNumTextures) return nullptr;
  return scene.mTextures[index];
}

Image<Rgba8> TexelsOf(const aiTexture& texture) {
  Image<Rgba8> texels(int(texture.mWidth), int(texture.mHeight));
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const aiTexel& from = texture.pcData[i];
    texels.data()[i] = {from.r, from.g, from.b, from.a};
  }
  return texels;
}

class MaterialAppender {
 public:
  MaterialAppender(Model& model, const aiScene& scene, const MaterialContext& context)
      : model_(model), scene_(scene), context_(context) {}

  void Append(const aiMaterial& from) {
    ModelMaterial to;
    to.surface.name = String(from, AI_MATKEY_NAME);
    to.surface.diffuse = DiffuseColour(from);
    to.surface.emission = Colour(from, {0, 0, 0}, AI_MATKEY_COLOR_EMISSIVE);
    SetReflection(from, to.surface);
    float opacity = 1;
    from.Get(AI_MATKEY_OPACITY, opacity);
    const std::string alpha_mode = String(from, AI_MATKEY_GLTF_ALPHAMODE);
    const bool opaque = alpha_mode == "OPAQUE";
    to.invisible = !opaque && opacity < kOpaqueEnough;
    const std::string path = TexturePath(from, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    if (!path.empty()) {
      const std::string opacity_path = TexturePath(from, {aiTextureType_OPACITY});
      to.surface.texture = PictureIndex(path, opacity_path, to.surface.name);
      to.surface.cutout = to.surface.texture >= 0 && !opaque;
    }
    model_.materials.push_back(std::move(to));
  }

 private:
  Vec3f Colour(const aiMaterial& from, const Vec3f& fallback, const char* key, unsigned type,
               unsigned index) const {
    aiColor4D colour(fallback.x, fallback.y, fallback.z, 1);
    from.Get(key, type, index, colour);
    Vec3f linear{FiniteOr(colour.r, 0), FiniteOr(colour.g, 0), FiniteOr(colour.b, 0)};
    for (float* c : {&linear.x, &linear.y, &linear.z}) {
      *c = std::max(0.0f, context_.linear_colours ? *c : LinearFromSrgb(*c));
    }
    return linear;
  }

  Vec3f DiffuseColour(const aiMaterial& from) const {
    const Vec3f diffuse = Colour(from, {0.6f, 0.6f, 0.6f}, AI_MATKEY_COLOR_DIFFUSE);
    const Vec3f base =
        context_.linear_colours ? Colour(from, diffuse, AI_MATKEY_BASE_COLOR) : diffuse;
    return {std::min(base.x, 1.0f), std::min(base.y, 1.0f), std::min(base.z, 1.0f)};
  }

  void SetReflection(const aiMaterial& from, Material& to) const {
    float metallic = -1, roughness = -1;
    from.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
    from.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness);
    if (metallic >= 0 && roughness >= 0) {
      // Where a picture tells metal from paint the factor is 1 and says nothing: mostly paint.
      const bool by_picture =
          !TexturePath(from, {aiTextureType_METALNESS, aiTextureType_UNKNOWN}).empty();
      to.metallic = by_picture ? 0 : std::clamp(metallic, 0.0f, 1.0f);
      to.roughness = by_picture ? 0.5f : std::clamp(roughness, 0.0f, 1.0f);
      to.specular = kDielectric;
      return;
    }
    int shading = aiShadingMode_Phong;
    from.Get(AI_MATKEY_SHADING_MODEL, shading);
    const Vec3f phong = Colour(from, {}, AI_MATKEY_COLOR_SPECULAR);
    float exponent = 0;
    from.Get(AI_MATKEY_SHININESS, exponent);
    const float strength = (phong.x + phong.y + phong.z) / 3;
    const bool matt = shading == aiShadingMode_NoShading || shading == aiShadingMode_Flat ||
                      shading == aiShadingMode_Gouraud;
    if (matt || !(strength > 0) || !(exponent > 0) || !std::isfinite(exponent)) return;
    // A lobe cosⁿ is about as wide as GGX with α² = 2/(n + 2). Exporters write Ks = ½ for what
    // reflects 4 % at normal incidence.
    to.specular = std::min(2 * kDielectric * strength, 1.0f);
    to.roughness = std::pow(2 / (exponent + 2), 0.25f);
  }

  // The true name of a picture's file; empty, with a warning, where there is none.
  std::string FindPicture(const std::string& path, const std::string& material) {
    const std::string normal = NormalizedAssetPath(path);
    for (const std::string& candidate : {normal, normal.substr(normal.rfind('/') + 1)}) {
      const auto found = context_.source.Find(BesideAsset(context_.model_name, candidate));
      if (found) return *found;
    }
    model_.warnings.push_back(context_.source.Describe(context_.model_name) + ": material '" +
                              material + "' lacks its picture '" + path + "'");
    return {};
  }

  // A picture's file, from wherever it is. Without colour and texels where it cannot be had.
  EncodedPicture LoadPicture(const std::string& path, const std::string& material) {
    EncodedPicture picture;
    if (const aiTexture* embedded = EmbeddedTexture(scene_, path)) {
      picture.place = context_.source.Describe(context_.model_name) + "#" + path;
      if (embedded->mHeight > 0) {
        picture.texels = TexelsOf(*embedded);
      } else {
        picture.colour = std::make_shared<const std::string>(
            reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
      }
      return picture;
    }
    const std::string name = FindPicture(path, material);
    if (name.empty()) return picture;
    picture.place = context_.source.Describe(name);
    try {
      picture.colour = context_.source.Read(name);
    } catch (const Error& e) {
      model_.warnings.push_back(e.what());
    }
    return picture;
  }

  // Index into the model's pictures; −1 where the picture cannot be had.
  int PictureIndex(const std::string& path, const std::string& opacity_path,
                   const std::string& material) {
    EncodedPicture picture = LoadPicture(path, material);
    if (!picture.colour && picture.texels.empty()) return -1;
    if (!opacity_path.empty() && opacity_path != path) {
      const EncodedPicture opacity = LoadPicture(opacity_path, material);
      picture.opacity_place = opacity.place;
      picture.opacity = opacity.colour;
    }
    for (std::size_t i = 0; i < model_.pictures.size(); ++i) {
      if (model_.pictures[i].IsSameAs(picture)) return int(i);
    }
    model_.pictures.push_back(std::move(picture));
    return int(model_.pictures.size()) - 1;
  }

  Model& model_;
  const aiScene& scene_;
  const MaterialContext& context_;
};

}  // namespace

void AppendMaterials(Model& model, const aiScene& scene, const MaterialContext& context) {
  MaterialAppender appender(model, scene, context);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) appender.Append(*scene.mMaterials[i]);
  // A mesh without a material of its own still names one.
  if (scene.mNumMaterials == 0) model.materials.emplace_back();
}

}  // namespace silt::sim
