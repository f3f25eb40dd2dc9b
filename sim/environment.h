// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// Where `direction` (any length, z up) falls in an equirectangular picture, u and v in [0, 1]: u
// runs clockwise seen from above (+y in the middle, +x at ¾), v from straight up to straight down.
Vec2d EquirectangularFromDirection(const Vec3d& direction);
// Unit.
Vec3d DirectionFromEquirectangular(const Vec2d& uv);

// Radiance that arrives from far away, by direction: an equirectangular picture, bilinear between
// the centres of its texels.
class Environment {
 public:
  // Rows from the zenith down, finite and not negative, 1 × 1 at least; turned by `yaw_rad`
  // counter-clockwise seen from above.
  explicit Environment(Image<Vec3f> radiance, double yaw_rad = 0);

  Vec3f Radiance(const Vec3f& direction) const;

  // A unit direction from two numbers in [0, 1), with a density in proportion to the luminance
  // about each texel: constant within a texel, and above 0 wherever the radiance is.
  struct Sample {
    Vec3f direction, radiance;
    float density = 0;  // per steradian; 0 where all is black
  };
  Sample Draw(const Vec2f& random) const;
  float Density(const Vec3f& direction) const;

  // ∫ L dω / 4π.
  const Vec3f& mean() const { return mean_; }
  const Image<Vec3f>& picture() const { return radiance_; }
  double yaw_rad() const { return yaw_rad_; }

 private:
  Vec2d PlaceOf(const Vec3f& direction) const;
  Vec3f Bilinear(const Vec2d& uv) const;
  double TexelDensity(int x, int y) const;

  Image<Vec3f> radiance_;
  double yaw_rad_;
  std::vector<double> solid_angle_;  // of a texel, by row
  std::vector<double> rows_up_to_;   // cumulative weight × solid angle; one more than rows
  Image<double> columns_up_to_;      // within a row, of weight; one more than columns
  Vec3f mean_;
};

// A clear sky of three colours: from the horizon to the zenith, and the ground below.
struct Sky {
  Vec3d zenith, horizon, ground;  // radiance
};
Environment MakeSky(const Sky& sky);

// A picture in .hdr, or whatever OpenCV reads (8 and 16 bits as sRGB), times `strength`. Throws
// silt::Error where it cannot be read.
Environment LoadEnvironment(const std::filesystem::path& file, double strength, double yaw_rad);

}  // namespace silt::sim
