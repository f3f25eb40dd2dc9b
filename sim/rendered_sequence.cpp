// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/rendered_sequence.h"

#include <cmath>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {

RenderedSequence::RenderedSequence(std::shared_ptr<const Renderer> renderer,
                                   std::shared_ptr<const CameraPath> path,
                                   const SequenceTiming& timing)
    : renderer_(std::move(renderer)), path_(std::move(path)) {
  const double duration_s =
      timing.duration_s == 0 ? path_->duration_s() - timing.start_s : timing.duration_s;
  ground_truth_ = path_->Sample(timing.fps, timing.start_s, duration_s);
  if (!ground_truth_.empty()) {
    first_frame_ = int(std::lround(ground_truth_.front().time_s * timing.fps));
  }
}

std::optional<Frame> RenderedSequence::Next() {
  if (next_ >= size()) return std::nullopt;
  return At(next_++);
}

Frame RenderedSequence::At(int index) const {
  SILT_CHECK(index >= 0 && index < size());
  const auto pose = [this](double time_s) { return path_->WorldFromCamera(time_s); };
  return renderer_->Render(pose, ground_truth_[std::size_t(index)].time_s, first_frame_ + index);
}

}  // namespace silt::sim
