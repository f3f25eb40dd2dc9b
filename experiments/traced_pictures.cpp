// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/traced_pictures.h"

#include <cstdint>
#include <system_error>

#include "silt/core/error.h"
#include "silt/core/io/npy_file.h"
#include "silt/experiments/case_runner.h"
#include "silt/sim/content_hash.h"
#include "silt/sim/scene_digest.h"

namespace silt::experiments {

namespace {

// Rises with every change of what TraceReference computes.
constexpr std::uint32_t kVersion = 1;

}  // namespace

TracedPictures::TracedPictures(const PathReference& reference, const std::filesystem::path& folder)
    : reference_(reference), folder_(folder) {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw Error(folder_.string() + ": cannot be made a folder: " + error.message());
}

std::filesystem::path TracedPictures::FileOf(const std::string& scene_digest, const LightView& view,
                                             std::uint32_t number, int half) const {
  sim::ContentHash hash;
  hash.Add(kVersion).AddBytes(scene_digest.data(), scene_digest.size());
  const Quaternion<double>& q = view.world_from_camera.rotation;
  const Vec3d& t = view.world_from_camera.translation;
  for (const double value : {q.w, q.x, q.y, q.z, t.x, t.y, t.z}) hash.Add(value);
  hash.Add(number).Add(reference_.width).Add(reference_.samples_per_pixel);
  hash.Add(reference_.reflection).Add(reference_.seed).Add(half);
  return folder_ / (view.name + "_" + hash.Digest() + ".npy");
}

ReferencePicture TracedPictures::Of(const sim::LitScene& scene, const LightView& view,
                                    std::uint32_t number) const {
  if (folder_.empty()) return TraceReference(scene, view, number, reference_);
  const std::string digest = sim::SceneDigest(
      scene.scene(), reference_.reflection ? sim::SurfacesAre::kAsGiven : sim::SurfacesAre::kMatt);
  const std::filesystem::path files[] = {FileOf(digest, view, number, 0),
                                         FileOf(digest, view, number, 1)};
  const PinholeCamera camera = IclNuimCameraOfWidth(reference_.width);
  ReferencePicture picture;
  std::error_code ignored;
  if (exists(files[0], ignored) && exists(files[1], ignored)) {
    for (const int half : {0, 1}) {
      picture.half[half] = ReadNpy(files[half], camera.width, camera.height);
    }
    return picture;
  }
  picture = TraceReference(scene, view, number, reference_);
  for (const int half : {0, 1}) WriteNpy(files[half], picture.half[half]);
  return picture;
}

}  // namespace silt::experiments
