// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/irradiance.h"

#include <algorithm>
#include <numbers>

#include "silt/core/parallel.h"
#include "silt/sim/denormals.h"
#include "silt/sim/indirect_light.h"

namespace silt::sim {

namespace {

// Calls body(i) for i in [0, n) in blocks, in parallel, and reports `from` … `to` as it goes.
void ForSamples(std::size_t n, const LightingOptions& options, double from, double to,
                const std::function<void(std::size_t)>& body) {
  constexpr std::size_t block = 64, blocks_per_report = 256;
  for (std::size_t begin = 0; begin < n; begin += block * blocks_per_report) {
    const std::size_t end = std::min(n, begin + block * blocks_per_report);
    ParallelFor(int((end - begin + block - 1) / block), [&](int b) {
      const ScopedFlushDenormals flush;
      const std::size_t first = begin + std::size_t(b) * block;
      for (std::size_t i = first; i < std::min(end, first + block); ++i) body(i);
    });
    if (options.progress) options.progress(from + (to - from) * double(end) / double(n));
  }
}

// Mean reflectance of each material, over its texture.
std::vector<Vec3f> MeanAlbedos(const Scene& scene) {
  std::vector<Vec3f> albedos;
  for (const Material& material : scene.materials) {
    Vec3f albedo = material.diffuse;
    if (material.texture >= 0) {
      const Texture& texture = scene.textures[std::size_t(material.texture)];
      albedo = albedo * texture.Sample(0, 0, float(texture.level_count()));
    }
    albedos.push_back(albedo);
  }
  return albedos;
}

}  // namespace

Irradiance::Irradiance(const Scene& scene, const RayTracer& tracer, const LightingOptions& options)
    : grid_(scene.mesh, options.direct_spacing_m) {
  const std::vector<SurfaceSample>& samples = grid_.samples();
  front_.resize(samples.size());
  back_.resize(samples.size());
  const DirectLight direct(scene, tracer, options.light_points);
  ForSamples(samples.size(), options, 0, 0.5, [&](std::size_t i) {
    front_[i] = direct.Irradiance(samples[i].position, samples[i].normal);
    back_[i] = direct.Irradiance(samples[i].position, -samples[i].normal);
  });

  const std::vector<Vec3f> albedos = MeanAlbedos(scene);
  const SurfaceRadiance radiance = [&](std::uint32_t triangle, float u, float v, bool front) {
    const std::uint32_t material = scene.mesh.triangles[triangle].material;
    if (!front && !scene.materials[material].two_sided) return Vec3f{};
    return albedos[material] *
           (std::numbers::inv_pi_v<float> * At(triangle, u, v, front) + scene.ambient);
  };
  const IndirectLight indirect(scene, tracer, options.gather_directions);
  const SurfaceGrid coarse(scene.mesh, options.indirect_spacing_m);
  const std::vector<SurfaceSample>& points = coarse.samples();
  std::vector<TwoSided> gathered(points.size());
  ForSamples(points.size(), options, 0.5, 1, [&](std::size_t i) {
    gathered[i].front = indirect.Irradiance(points[i].position, points[i].normal, radiance);
    gathered[i].back = indirect.Irradiance(points[i].position, -points[i].normal, radiance);
  });

  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SurfaceGrid::Origin& origin = grid_.origins()[i];
    const SurfaceLookup at = coarse.Locate(origin.triangle, origin.u, origin.v);
    for (int k = 0; k < 4; ++k) {
      front_[i] += at.weight[k] * gathered[at.sample[k]].front;
      back_[i] += at.weight[k] * gathered[at.sample[k]].back;
    }
  }
}

Vec3f Irradiance::Interpolate(const SurfaceLookup& at, bool front) const {
  const Vec3f* values = front ? front_.data() : back_.data();
  return at.weight[0] * values[at.sample[0]] + at.weight[1] * values[at.sample[1]] +
         at.weight[2] * values[at.sample[2]] + at.weight[3] * values[at.sample[3]];
}

}  // namespace silt::sim
