// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/picture_set.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

constexpr std::uint8_t kHoleBelow = 128;  // opacity

PictureSet::Decoded DecodeOne(EncodedPicture encoded) {
  PictureSet::Decoded decoded;
  try {
    Image<Rgba8> picture = DecodePicture(encoded);
    encoded = {};  // frees the file before the levels are built
    decoded.has_holes = std::any_of(picture.begin(), picture.end(),
                                    [](const Rgba8& texel) { return texel.a < kHoleBelow; });
    decoded.texture.emplace(std::move(picture));
  } catch (const Error& e) {
    decoded.problem = e.what();
  }
  return decoded;
}

}  // namespace

int PictureSet::Add(const EncodedPicture& picture, const std::string& place) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!entries_[i].encoded.IsSameAs(picture)) continue;
    if (entries_[i].place.empty()) entries_[i].place = place;
    return int(i);
  }
  entries_.push_back({picture, place});
  return int(entries_.size()) - 1;
}

std::vector<PictureSet::Decoded> PictureSet::Decode() && {
  std::vector<Decoded> decoded(entries_.size());
  ParallelFor(int(entries_.size()), [&](int i) {
    decoded[std::size_t(i)] = DecodeOne(std::move(entries_[std::size_t(i)].encoded));
  });
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::string& place = entries_[i].place;
    if (!decoded[i].texture && !place.empty()) throw Error(place + ": " + decoded[i].problem);
  }
  return decoded;
}

}  // namespace silt::sim
