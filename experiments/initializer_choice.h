// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/se3.h"
#include "silt/experiments/pose_difference.h"
#include "silt/tracker/initializer.h"
#include "silt/tracker/options.h"

// Where alignments start, as the command line names it.
namespace silt::experiments {

struct InitializerChoice {
  std::string kind = "auto";    // one of InitializerNames()
  PoseDifference perturbation;  // of "truth"

  bool uses_truth() const { return kind == "truth"; }
};

// auto: as the preset has it, with features. identity: the nearest keyframe's pose. previous: the
// last pose. constant-velocity: where the last motion leads. rotation: a coarse alignment of the
// turn alone. surf, sift, orb, akaze: features. truth: the true pose. The first gives way to
// features where its result is not trusted, as the preset has it; all others are what they are.
std::vector<std::string> InitializerNames();

// "truth:0.02m,1deg": the true pose, with the camera moved by so much in a random direction and
// turned by so much about a random axis. Throws silt::Error for what is no such name.
InitializerChoice ParseInitializer(const std::string& text);

// Null where the choice needs none. "auto" is SURF for a preset that initializes every frame; for
// one that does so only where it is lost, SURF and a wide start together. Coarse alignments are the
// backend's, that of the tracker, so that its images stay where they are; null: the CPU's.
std::unique_ptr<tracker::Initializer> MakeInitializer(
    const InitializerChoice& choice, const tracker::TrackerOptions& preset = {},
    std::shared_ptr<const tracker::Backend> backend = nullptr);

// The preset's options with the choice in force.
tracker::TrackerOptions WithInitializer(const tracker::TrackerOptions& preset,
                                        const InitializerChoice& choice);

// A pure function of its arguments.
SE3d PerturbedTruth(const SE3d& world_from_camera, const PoseDifference& perturbation,
                    std::uint64_t seed, int frame_index);

}  // namespace silt::experiments
