// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_solver.h"

#include <algorithm>
#include <numbers>

#include "silt/core/parallel.h"
#include "silt/sim/denormals.h"
#include "silt/sim/direct_light.h"
#include "silt/sim/indirect_light.h"

namespace silt::sim {

namespace {

// Share of the progress that direct light takes; measured on the office.
constexpr double kDirectShare = 0.3;

struct ProgressRange {
  double from, to;
};

// Calls body(i) for i in [0, n) in blocks, in parallel, and reports progress between them.
void ForSamples(std::size_t n, const LightingOptions& options, const ProgressRange& range,
                const std::function<void(std::size_t)>& body) {
  constexpr std::size_t block = 64, blocks_per_report = 256;
  for (std::size_t begin = 0; begin < n; begin += block * blocks_per_report) {
    const std::size_t end = std::min(n, begin + block * blocks_per_report);
    ParallelFor(int((end - begin + block - 1) / block), [&](int b) {
      const ScopedFlushDenormals flush;
      const std::size_t first = begin + std::size_t(b) * block;
      for (std::size_t i = first; i < std::min(end, first + block); ++i) body(i);
    });
    if (options.progress) {
      options.progress(range.from + (range.to - range.from) * double(end) / double(n));
    }
  }
}

StoredLight SolveDirect(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                        const LightingOptions& options) {
  const std::vector<SurfaceSample>& samples = grid.samples();
  StoredLight light{std::vector<Vec3f>(samples.size()), std::vector<Vec3f>(samples.size())};
  const DirectLight direct(scene, tracer, options.light_points);
  ForSamples(samples.size(), options, {0, kDirectShare}, [&](std::size_t i) {
    light.front[i] = direct.Irradiance(samples[i].position, samples[i].normal);
    light.back[i] = direct.Irradiance(samples[i].position, -samples[i].normal);
  });
  return light;
}

// On a coarser grid of its own, since indirect light is smooth.
StoredLight SolveIndirect(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                          const SurfaceRadiance& radiance, const LightingOptions& options) {
  const IndirectLight wide(scene, tracer, options.wide_gather_directions);
  const IndirectLight small(scene, tracer, options.small_gather_directions);
  const std::vector<SurfaceSample>& samples = grid.samples();
  StoredLight light{std::vector<Vec3f>(samples.size()), std::vector<Vec3f>(samples.size())};
  ForSamples(samples.size(), options, {kDirectShare, 1}, [&](std::size_t i) {
    const SurfaceSample& sample = samples[i];
    const IndirectLight& indirect = sample.on_wide_triangle ? wide : small;
    light.front[i] = indirect.Irradiance(sample.position, sample.normal, radiance);
    light.back[i] = indirect.Irradiance(sample.position, -sample.normal, radiance);
  });
  return light;
}

}  // namespace

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

StoredLight SolveLight(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                       const LightingOptions& options) {
  StoredLight light = SolveDirect(scene, tracer, grid, options);
  const std::vector<Vec3f> albedos = MeanAlbedos(scene);
  const SurfaceRadiance radiance = [&](std::uint32_t triangle, float u, float v, bool front) {
    const std::uint32_t material = scene.mesh.triangles[triangle].material;
    if (!front && !scene.materials[material].two_sided) return Vec3f{};
    const Vec3f irradiance = light.At(grid.Locate(triangle, u, v), front);
    return albedos[material] * (std::numbers::inv_pi_v<float> * irradiance + scene.ambient);
  };
  const SurfaceGrid coarse(scene.mesh, options.indirect_spacing_m);
  const StoredLight indirect = SolveIndirect(scene, tracer, coarse, radiance, options);
  for (std::size_t i = 0; i < grid.samples().size(); ++i) {
    const SurfaceGrid::Origin& origin = grid.origins()[i];
    const SurfaceLookup at = coarse.Locate(origin.triangle, origin.u, origin.v);
    light.front[i] += indirect.At(at, true);
    light.back[i] += indirect.At(at, false);
  }
  return light;
}

}  // namespace silt::sim
