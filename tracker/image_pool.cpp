// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_pool.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "silt/core/memory_pool.h"

namespace silt::tracker {
namespace {

// Some dozens are in use for a frame; those of lengths that no longer come would stay for ever.
constexpr std::size_t kMostIdle = 96;

}  // namespace

struct ImagePool::Store {
  std::mutex mutex;
  std::vector<std::unique_ptr<Image<float>>> idle;  // the longest idle first

  std::unique_ptr<Image<float>> Find(int width, int height) {
    const std::lock_guard lock(mutex);
    const auto fits = [&](const auto& image) {
      return image->width() == width && image->height() == height;
    };
    const auto found = std::find_if(idle.rbegin(), idle.rend(), fits);
    if (found == idle.rend()) return nullptr;
    std::unique_ptr<Image<float>> image = std::move(*found);
    idle.erase(std::next(found).base());
    return image;
  }

  void Return(std::unique_ptr<Image<float>> image) {
    const std::lock_guard lock(mutex);
    if (idle.size() == kMostIdle) idle.erase(idle.begin());
    idle.push_back(std::move(image));
  }
};

ImagePool::ImagePool() : store_(std::make_shared<Store>()) { store_->idle.reserve(kMostIdle); }

std::shared_ptr<Image<float>> ImagePool::Take(int width, int height) {
  std::unique_ptr<Image<float>> image = store_->Find(width, height);
  if (!image) image = std::make_unique<Image<float>>(width, height);
  const auto give_back = [store = store_](Image<float>* used) {
    store->Return(std::unique_ptr<Image<float>>(used));
  };
  return {image.release(), give_back, PoolAllocator<Image<float>>()};
}

}  // namespace silt::tracker
