// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/scene_digest.h"

#include <vector>

#include "silt/core/parallel.h"
#include "silt/sim/content_hash.h"

namespace silt::sim {

namespace {

void AddMaterials(const Scene& scene, SurfacesAre surfaces, ContentHash& hash) {
  for (const Material& m : scene.materials) {
    hash.AddBytes(&m.diffuse, sizeof(m.diffuse)).AddBytes(&m.emission, sizeof(m.emission));
    hash.Add(m.two_sided).Add(m.cutout).Add(m.texture);
    if (surfaces == SurfacesAre::kMatt) continue;
    hash.Add(m.specular).Add(m.metallic).Add(m.roughness).Add(m.mirror);
  }
  std::vector<std::string> digests(scene.textures.size());
  ParallelFor(int(digests.size()),
              [&](int i) { digests[std::size_t(i)] = scene.textures[std::size_t(i)].Digest(); });
  for (const std::string& digest : digests) hash.AddBytes(digest.data(), digest.size());
}

void AddEnvironment(const Scene& scene, ContentHash& hash) {
  if (!scene.environment) return;
  const Image<Vec3f>& picture = scene.environment->picture();
  hash.Add(picture.width()).AddBytes(picture.data(), picture.size() * sizeof(Vec3f));
  hash.Add(scene.environment->yaw_rad());
}

}  // namespace

std::string SceneDigest(const Scene& scene, SurfacesAre surfaces) {
  ContentHash hash;
  hash.AddArray(scene.mesh.positions).AddArray(scene.mesh.normals);
  hash.AddArray(scene.mesh.texcoords).AddArray(scene.mesh.triangles);
  hash.AddArray(scene.lights).AddBytes(&scene.ambient, sizeof(scene.ambient));
  AddEnvironment(scene, hash);
  AddMaterials(scene, surfaces, hash);
  return hash.Digest();
}

}  // namespace silt::sim
