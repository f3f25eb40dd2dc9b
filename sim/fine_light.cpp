// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/fine_light.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {

FineLight::FineLight(std::vector<Patch> patches, std::vector<Vec3f> irradiance)
    : patches_(std::move(patches)), irradiance_(std::move(irradiance)) {
  SILT_CHECK(irradiance_.size() == patches_.size() * std::size_t(kPlaces));
  SILT_CHECK(std::is_sorted(patches_.begin(), patches_.end()));
}

std::optional<Vec3f> FineLight::At(const SurfaceGrid::CellPlace& place, bool front) const {
  const Patch wanted{place.cell, front ? 1u : 0u};
  const auto found = std::lower_bound(patches_.begin(), patches_.end(), wanted);
  if (found == patches_.end() || *found != wanted) return std::nullopt;
  const Corner corner = CornerOf(place.along, place.up);
  const Vec3f* near =
      &irradiance_[std::size_t(found - patches_.begin()) * kPlaces + std::size_t(corner.first)];
  const Vec3f* far = near + kSide;
  const auto in_row = [&](const Vec3f* row) { return row[0] + corner.along * (row[1] - row[0]); };
  return in_row(near) + corner.up * (in_row(far) - in_row(near));
}

}  // namespace silt::sim
