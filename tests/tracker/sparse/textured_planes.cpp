// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "textured_planes.h"

#include <cmath>
#include <utility>

#include "silt/core/parallel.h"
#include "silt/core/random.h"

namespace silt::tracker {
namespace {

// A plane through `origin` with the orthonormal axes u and v, for |s| and |t| below its half sizes.
struct Plane {
  Vec3d origin, u, v;
  double half_u, half_v;
  std::uint64_t seed;
};

const Plane kPlanes[] = {
    {{-0.35, 0, 1.2}, {0.96, 0, 0.28}, {0, 1, 0}, 0.25, 0.4, 1},
    {{0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 50, 50, 2},
};

double ValueNoise(double x, double y, const CounterRandom& random) {
  const auto cell = [&](double i, double j) {
    return random.Uniform(std::uint64_t(std::int64_t(i) * 65537 + std::int64_t(j)));
  };
  const double i = std::floor(x), j = std::floor(y);
  const double fx = x - i, fy = y - j;
  const double sx = fx * fx * (3 - 2 * fx), sy = fy * fy * (3 - 2 * fy);
  return (1 - sy) * ((1 - sx) * cell(i, j) + sx * cell(i + 1, j)) +
         sy * ((1 - sx) * cell(i, j + 1) + sx * cell(i + 1, j + 1));
}

}  // namespace

double Texture(double x_m, double y_m, std::uint64_t seed) {
  double sum = 0;
  for (const auto& [size_m, weight] : {std::pair{0.12, 0.5}, {0.05, 0.3}, {0.02, 0.2}}) {
    const CounterRandom random(seed, std::uint64_t(size_m * 1000));
    sum += weight * ValueNoise(x_m / size_m, y_m / size_m, random);
  }
  return sum;
}

View ViewOfPlanes(const PinholeCamera& camera, const SE3d& world_from_camera) {
  View view{Image<float>(camera.width, camera.height), Image<float>(camera.width, camera.height)};
  const Vec3d eye = world_from_camera.translation;
  ParallelFor(camera.height, [&](int y) {
    for (int x = 0; x < camera.width; ++x) {
      // A ray of depth 1 along z, so that its parameter is the depth.
      const Vec3d ray = world_from_camera.rotation * camera.Unproject(x, y, 1);
      for (const Plane& plane : kPlanes) {
        const Vec3d normal = Cross(plane.u, plane.v);
        const double z = Dot(plane.origin - eye, normal) / Dot(ray, normal);
        const Vec3d at = eye + z * ray - plane.origin;
        const double s = Dot(at, plane.u), t = Dot(at, plane.v);
        if (!(z > 0) || std::abs(s) > plane.half_u || std::abs(t) > plane.half_v) continue;
        view.intensity(x, y) = float(Texture(s, t, plane.seed));
        view.depth_m(x, y) = float(z);
        break;
      }
    }
  });
  return view;
}

Keyframe KeyframeOf(const View& view, int id) {
  Keyframe keyframe;
  keyframe.id = id;
  keyframe.frame.depth_m = view.depth_m;
  keyframe.intensity = view.intensity;
  return keyframe;
}

}  // namespace silt::tracker
