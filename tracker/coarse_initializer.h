// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "silt/tracker/backend.h"
#include "silt/tracker/initializer.h"
#include "silt/tracker/options.h"

namespace silt::tracker {

// Dense alignment of small pictures, which reaches farther than that of large ones, if less
// exactly.
struct CoarseOptions {
  int max_width = 160;                   // both pictures are halved until they are no wider
  std::vector<AlignmentOptions> stages;  // one after the other, each from where the last one ended
  // The first stage starts from the expected pose turned by each of these about the current camera,
  // and the one goes on that ends with pictures most alike.
  std::vector<Vec3d> turns_rad = {{}};

  // Throws silt::Error where an option is out of range.
  void Validate() const;
};

// The turn alone, by intensities alone: most of what moves a picture between two frames.
CoarseOptions TurnAlone();

// Of what the presets refine with, all that reaches far: a pyramid down to 10×7 pixels, from five
// starts 8° apart. Depth edges and hidden pixels stay in: at a coarse level the edges are
// everywhere, and where the pose is far off, what is hidden is not what seems so.
CoarseOptions WideStart();

// Starts from the expected pose and, if another initializer is given, from its estimate as well.
// No estimate where a stage finds no pose, or where that of the last one makes the pictures no more
// alike than the expected pose does.
class CoarseInitializer : public Initializer {
 public:
  // `other` may be null. Throws silt::Error for invalid options.
  CoarseInitializer(std::shared_ptr<const Backend> backend, const CoarseOptions& options,
                    std::unique_ptr<Initializer> other = nullptr);

  // Small pictures are made where the backend holds the images already, if it can.
  InitialEstimate Estimate(const InitializerInput& input) override;
  bool needs_intensities(const Backend& backend) const override;
  // Where there is one start alone, of images whose backend runs whole alignments.
  std::optional<CoarseStart> StartOf(const InitializerInput& input) const override;

  // The same for many expected poses of one pair at once, without the other initializer; that of
  // the input does not count.
  std::vector<std::optional<SE3d>> FindFrom(const InitializerInput& input,
                                            const std::vector<SE3d>& expected) const;

 private:
  std::vector<std::optional<SE3d>> Find(const InitializerInput& input,
                                        const std::vector<SE3d>& expected,
                                        const std::optional<SE3d>& other) const;

  bool HalvesWhatIsHeldBy(const Backend& backend) const;
  // Until the pictures are small; nothing where they show nothing.
  std::optional<int> Halvings(const InitializerInput& input) const;

  std::shared_ptr<const Backend> backend_;
  CoarseOptions options_;
  std::unique_ptr<Initializer> other_;
};

}  // namespace silt::tracker
