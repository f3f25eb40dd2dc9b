// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/sim/ggx.h"

namespace silt::sim {

namespace {

constexpr float kInversePi = std::numbers::inv_pi_v<float>;
const Vec3f kWhite{1, 1, 1};

float Mean(const Vec3f& c) { return (c.x + c.y + c.z) / 3; }

// Interpolated normals may turn away from the viewer.
Vec3f Facing(const Vec3f& w) { return w.z > 1e-3f ? w : Normalized(Vec3f{w.x, w.y, 1e-3f}); }

Vec3f CosineDirection(const Vec2f& random) {
  const float radius = std::sqrt(random.x), angle = 2 * std::numbers::pi_v<float> * random.y;
  return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - random.x)};
}

}  // namespace

Bsdf::Bsdf(const Material& material, const Vec3f& color, bool with_reflection) : ground_(color) {
  if (!with_reflection || !material.reflects()) return;
  if (material.mirror) {
    mirror_ = true;
    ground_ = {};
    f0_ = color;
    return;
  }
  glossy_ = true;
  alpha_ = material.roughness * material.roughness;
  const float metal = material.metallic, coat = (1 - metal) * material.specular;
  f0_ = metal * color + coat * kWhite;
  metallic_ = metal;
  ground_ = (1 - metal) * color;
}

Vec3f Bsdf::GroundShare(const Vec3f& out) const {
  if (mirror_) return {};
  if (!glossy_) return kWhite;
  const Vec3f through = kWhite - DirectionalAlbedo(Facing(out).z, alpha_).Of(f0_);
  return (1 - metallic_) * through;
}

Vec3f Bsdf::GroundAlbedo(const Vec3f& out) const {
  if (!glossy_) return ground_;
  return ground_ * (kWhite - DirectionalAlbedo(Facing(out).z, alpha_).Of(f0_));
}

Bsdf Bsdf::Reflection() const {
  Bsdf coat = *this;
  coat.ground_ = {};
  return coat;
}

Vec3f Bsdf::Gloss(const Vec3f& out, const Vec3f& in) const {
  const Ggx facets(alpha_);
  const Vec3f half = Normalized(out + in);
  const float share = facets.Distribution(half) * facets.Shadowing(out, in) / (4 * out.z);
  return share * Schlick(f0_, Dot(in, half));
}

Vec3f Bsdf::Evaluate(const Vec3f& seen_from, const Vec3f& in) const {
  if (in.z <= 0 || mirror_) return {};
  const Vec3f matt = (kInversePi * in.z) * ground_;
  if (!glossy_) return matt;
  const Vec3f out = Facing(seen_from);
  const Vec3f from = kWhite - DirectionalAlbedo(in.z, alpha_).Of(f0_);
  const Vec3f to = kWhite - DirectionalAlbedo(out.z, alpha_).Of(f0_);
  const Vec3f lost = kWhite - MeanAlbedo(alpha_).Of(f0_);
  const Vec3f through =
      from * to *
      Vec3f{1 / std::max(lost.x, 1e-3f), 1 / std::max(lost.y, 1e-3f), 1 / std::max(lost.z, 1e-3f)};
  return matt * through + Gloss(out, in);
}

float Bsdf::GlossShare(const Vec3f& out) const {
  const Vec3f albedo = DirectionalAlbedo(out.z, alpha_).Of(f0_);
  const float gloss = Mean(albedo), matt = Mean(ground_ * (kWhite - albedo));
  return gloss + matt > 0 ? gloss / (gloss + matt) : 1;
}

float Bsdf::Density(const Vec3f& seen_from, const Vec3f& in) const {
  if (in.z <= 0 || mirror_) return 0;
  if (!glossy_) return kInversePi * in.z;
  const Vec3f out = Facing(seen_from);
  const float share = GlossShare(out);
  const Ggx facets(alpha_);
  const float gloss = facets.Masking(out) * facets.Distribution(Normalized(out + in)) / (4 * out.z);
  return share * gloss + (1 - share) * kInversePi * in.z;
}

Bsdf::Sample Bsdf::Draw(const Vec3f& seen_from, float lobe, const Vec2f& random) const {
  if (mirror_) {
    const Vec3f out = Facing(seen_from);
    return {{-out.x, -out.y, out.z}, f0_, 0, true};
  }
  if (!glossy_) {
    const Vec3f in = CosineDirection(random);
    return {in, ground_, kInversePi * in.z, false};
  }
  const Vec3f out = Facing(seen_from);
  Vec3f in = CosineDirection(random);
  if (lobe < GlossShare(out)) {
    const Vec3f half = Ggx(alpha_).DrawVisible(out, random);
    in = (2 * Dot(out, half)) * half - out;
  }
  const float density = Density(out, in);
  if (!(density > 0)) return {in, {}, 0, false};
  return {in, (1 / density) * Evaluate(out, in), density, false};
}

}  // namespace silt::sim
