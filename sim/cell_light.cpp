// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/cell_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace silt::sim {

namespace {

// In place of what nobody sees: the mean of what is seen in the same patch, the nearest above all.
void FillClosed(const std::array<bool, FineLight::kPlaces>& closed, Vec3f* values) {
  constexpr int side = FineLight::kSide;
  for (int i = 0; i < FineLight::kPlaces; ++i) {
    if (!closed[std::size_t(i)]) continue;
    Vec3f sum;
    float total = 0;
    for (int k = 0; k < FineLight::kPlaces; ++k) {
      if (closed[std::size_t(k)]) continue;
      const int dx = k % side - i % side, dy = k / side - i / side;
      const float weight = 1 / float((dx * dx + dy * dy) * (dx * dx + dy * dy));
      sum += weight * values[k];
      total += weight;
    }
    values[i] = (1 / total) * sum;
  }
}

}  // namespace

bool LightDiffers(const Vec3f& a, const Vec3f& b, const Vec3f& besides, float share) {
  for (int c = 0; c < 3; ++c) {
    const float x = (&a.x)[c], y = (&b.x)[c];
    if (std::abs(x - y) > share * (std::max(x, y) + (&besides.x)[c])) return true;
  }
  return false;
}

CellLight::CellLight(const Sources& sources, const FineLight::Patch& patch,
                     const LightSamples& samples)
    : sources_(&sources),
      patch_(patch),
      samples_(&samples),
      corners_(sources.mesh, sources.mesh.triangles[patch.cell.triangle]) {}

CellLight CellLight::Next() const {
  CellLight next = *this;
  ++next.patch_.cell.column;
  next.known_.fill(false), next.looked_.fill(false);
  for (int i = 0; i < FineLight::kPlaces; i += FineLight::kSide) {
    next.Copy(std::size_t(i), *this, std::size_t(i + FineLight::kIntervals));
  }
  return next;
}

bool CellLight::Errs(int place) {
  const SurfaceLookup lookup = LookupOf(place);
  const Vec3f stored = samples_->direct.At(lookup, front());
  const Vec3f besides = samples_->indirect.At(lookup, front());
  return LightDiffers(Direct(place), stored, besides, sources_->tolerance) && !IsClosed(place);
}

std::optional<std::array<Vec3f, FineLight::kPlaces>> CellLight::All() {
  for (int i = 0; i < FineLight::kPlaces; ++i) IsClosed(i);
  if (std::all_of(closed_.begin(), closed_.end(), [](bool closed) { return closed; })) return {};
  std::array<Vec3f, FineLight::kPlaces> all;
  for (int i = 0; i < FineLight::kPlaces; ++i) {
    if (closed_[std::size_t(i)]) continue;
    all[std::size_t(i)] = Direct(i) + samples_->indirect.At(LookupOf(i), front());
  }
  FillClosed(closed_, all.data());
  return all;
}

Vec2f CellLight::PointOf(int place) const {
  return sources_->grid.PointOf({patch_.cell,
                                 float(place % FineLight::kSide) / FineLight::kIntervals,
                                 float(place / FineLight::kSide) / FineLight::kIntervals});
}

SurfaceLookup CellLight::LookupOf(int place) const {
  const Vec2f uv = PointOf(place);
  return sources_->grid.Locate(patch_.cell.triangle, uv.x, uv.y);
}

SurfaceSample CellLight::SurfaceAt(int place) const {
  const Vec2f uv = PointOf(place);
  const Vec3f weight{1 - uv.x - uv.y, uv.x, uv.y};
  const Vec3f normal = corners_.Normal(weight);
  return {corners_.Position(weight) + corners_.Inward(weight), front() ? normal : -normal};
}

const Vec3f& CellLight::Direct(int place) {
  Vec3f& direct = direct_[std::size_t(place)];
  if (!std::exchange(known_[std::size_t(place)], true)) direct = sources_->direct(SurfaceAt(place));
  return direct;
}

bool CellLight::IsClosed(int place) {
  bool& closed = closed_[std::size_t(place)];
  if (!std::exchange(looked_[std::size_t(place)], true)) {
    const SurfaceSample at = SurfaceAt(place);
    const auto dark = [](const TriangleHit&, const Vec3f&) { return Vec3f{}; };
    const std::uint64_t number = std::uint64_t(patch_.cell.triangle) * FineLight::kPlaces;
    closed =
        sources_->look.Gather(at.position, at.normal, number + std::uint64_t(place), dark).closed;
  }
  return closed;
}

void CellLight::Copy(std::size_t to, const CellLight& other, std::size_t from) {
  known_[to] = other.known_[from], direct_[to] = other.direct_[from];
  looked_[to] = other.looked_[from], closed_[to] = other.closed_[from];
}

}  // namespace silt::sim
