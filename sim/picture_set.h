// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "silt/sim/picture.h"
#include "silt/sim/texture.h"

namespace silt::sim {

// The pictures that a scene needs, each once however often it is named, decoded together.
class PictureSet {
 public:
  struct Decoded {
    std::optional<Texture> texture;  // nothing: it could not be decoded
    bool has_holes = false;          // some of it is more transparent than not
    std::string problem;             // then says why, in one line
  };

  // Returns the picture's index. `place`, "file:line" of the scene file, makes it an error if the
  // picture cannot be decoded; empty: only a problem.
  int Add(const EncodedPicture& picture, const std::string& place);

  // By index, in parallel. Throws silt::Error for the first picture with a place that is damaged.
  std::vector<Decoded> Decode() &&;

 private:
  struct Entry {
    EncodedPicture encoded;
    std::string place;
  };
  std::vector<Entry> entries_;
};

}  // namespace silt::sim
