// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/assimp_mesh.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace silt::sim {
namespace {

Vec3f FromAssimp(const aiVector3D& v) { return {float(v.x), float(v.y), float(v.z)}; }

// Unit length; zero where `v` is not finite or has no direction.
Vec3f Direction(const Vec3d& v) {
  const double length = Norm(v);
  if (!std::isfinite(length) || length < 1e-30) return {};
  return ((1 / length) * v).Cast<float>();
}

Vec3f GeometricNormal(const Mesh& mesh, const Triangle& t) {
  const Vec3d a = mesh.positions[t.vertex[0]].Cast<double>();
  const Vec3d b = mesh.positions[t.vertex[1]].Cast<double>();
  const Vec3d c = mesh.positions[t.vertex[2]].Cast<double>();
  return Direction(Cross(b - a, c - a));
}

class MeshAppender {
 public:
  MeshAppender(Mesh& mesh, const aiScene& scene) : mesh_(mesh), scene_(scene) {}

  void AppendNode(const aiNode& node, const aiMatrix4x4& root_from_parent) {
    const aiMatrix4x4 root_from_node = root_from_parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) {
        Append(*scene_.mMeshes[node.mMeshes[i]], root_from_node);
      }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      AppendNode(*node.mChildren[i], root_from_node);
    }
  }

 private:
  void Append(const aiMesh& from, const aiMatrix4x4& root_from_node) {
    const auto first = std::uint32_t(mesh_.positions.size());
    AppendVertices(from, root_from_node);
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const unsigned* index = face.mIndices;
      if (std::max({index[0], index[1], index[2]}) >= from.mNumVertices) continue;
      AppendTriangle({{first + index[0], first + index[1], first + index[2]}, from.mMaterialIndex});
    }
  }

  void AppendVertices(const aiMesh& from, const aiMatrix4x4& root_from_node) {
    // Normals are covectors: n' ∝ M⁻ᵀ·n, also where M mirrors.
    aiMatrix3x3 normal_matrix(root_from_node);
    normal_matrix.Inverse().Transpose();
    const aiVector3D* texcoords = from.mTextureCoords[TexcoordChannel(from)];
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      mesh_.positions.push_back(FromAssimp(root_from_node * from.mVertices[i]));
      mesh_.normals.push_back(
          from.HasNormals() ? Direction(FromAssimp(normal_matrix * from.mNormals[i]).Cast<double>())
                            : Vec3f{});
      Vec2f at;
      if (texcoords != nullptr) at = {float(texcoords[i].x), float(texcoords[i].y)};
      mesh_.texcoords.push_back(std::isfinite(at.x) && std::isfinite(at.y) ? at : Vec2f{});
    }
  }

  unsigned TexcoordChannel(const aiMesh& from) const {
    int channel = 0;
    if (from.mMaterialIndex < scene_.mNumMaterials) {
      const aiMaterial& material = *scene_.mMaterials[from.mMaterialIndex];
      for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        if (material.Get(AI_MATKEY_UVWSRC(type, 0), channel) == AI_SUCCESS) break;
      }
    }
    return channel >= 0 && channel < AI_MAX_NUMBER_OF_TEXTURECOORDS ? unsigned(channel) : 0;
  }

  void AppendTriangle(Triangle triangle) {
    Vec3f front = GeometricNormal(mesh_, triangle);
    if (Dot(front, front) == 0) return;
    Vec3f shading;
    for (const std::uint32_t v : triangle.vertex) shading += mesh_.normals[v];
    if (Dot(shading, front) < 0) {
      std::swap(triangle.vertex[1], triangle.vertex[2]);
      front = -front;
    }
    for (const std::uint32_t v : triangle.vertex) {
      Vec3f& normal = mesh_.normals[v];
      if (Dot(normal, normal) == 0) normal = front;
    }
    mesh_.triangles.push_back(triangle);
  }

  Mesh& mesh_;
  const aiScene& scene_;
};

}  // namespace

void AppendMeshes(Mesh& mesh, const aiScene& scene) {
  MeshAppender(mesh, scene).AppendNode(*scene.mRootNode, aiMatrix4x4());
}

}  // namespace silt::sim
