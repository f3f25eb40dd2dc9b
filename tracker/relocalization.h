// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

// Which keyframes a camera that is lost may be looking at.
namespace silt::tracker {

// A small blurred picture: means of blocks, 16 along the longer side, less their mean and over
// their root sum of squares, so that brightness and contrast do not count. All 0 for one that is
// even.
Image<float> Thumbnail(const Image<float>& intensity);
Image<float> Thumbnail(const Image<Rgb8>& rgb);

// Indices of the `count` thumbnails, or fewer where there are not so many, whose correlation with
// `current` is largest, largest first, the earlier of equal ones. One of another size has none.
std::vector<int> MostAlike(const std::vector<const Image<float>*>& thumbnails,
                           const Image<float>& current, int count);

}  // namespace silt::tracker
