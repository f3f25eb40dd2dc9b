// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/texture.h"

#include "silt/core/error.h"

namespace silt::sim {

Texture::Texture(const Image<Rgba8>& picture) {
  SILT_CHECK(!picture.empty());
  levels_.emplace_back(picture);
  while (levels_.back().width() > 1 || levels_.back().height() > 1) {
    levels_.push_back(levels_.back().Halved());
  }
  for (std::size_t i = levels_.size() - 1; i > 0; --i) {
    levels_[i - 1].FillInvisible(levels_[i]);
  }
}

float Texture::Alpha(float u, float v) const {
  MipLevel::Place place;
  FindIn(levels_.front(), Wrapped(u), Wrapped(-v), place);
  return place.Bilinear()[3] / 65535;
}

}  // namespace silt::sim
