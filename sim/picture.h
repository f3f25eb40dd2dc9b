// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/image.h"
#include "silt/sim/asset_source.h"
#include "silt/sim/texture.h"

namespace silt::sim {

// A texture as a model brings it, not decoded yet.
struct EncodedPicture {
  std::string place;    // for messages; different for different files
  Bytes colour;         // a picture's file; null: `texels` holds the picture
  Image<Rgba8> texels;  // uncompressed
  std::string opacity_place;
  Bytes opacity;  // a file whose alpha, or brightness where it has none, replaces the alpha

  bool IsSameAs(const EncodedPicture& other) const {
    return place == other.place && opacity_place == other.opacity_place;
  }
};

// PNG, JPEG, BMP or TIFF, 8 or 16 bits, gray or colour. Throws silt::Error with the place.
Image<Rgba8> DecodePicture(const EncodedPicture& picture);

}  // namespace silt::sim
