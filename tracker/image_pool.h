// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "silt/core/image.h"

namespace silt::tracker {

// Images that return when their last user lets go of them, to be handed out again: a tracker's
// frames all need the same sizes, and fresh memory costs as much as what is computed in it. Any
// number of threads may use a pool, and its images may outlive it.
class ImagePool {
 public:
  ImagePool();

  // Of arbitrary values.
  std::shared_ptr<Image<float>> Take(int width, int height);

 private:
  struct Store;
  std::shared_ptr<Store> store_;
};

}  // namespace silt::tracker
