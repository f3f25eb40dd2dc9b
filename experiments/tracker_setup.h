// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/experiments/initializer_choice.h"
#include "silt/experiments/json.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/keyframe_tracker.h"

namespace silt::experiments {

// Everything of a tracker that has a name on the command line.
struct TrackerSetup {
  std::string preset = "paper";  // as PresetOptions takes it
  std::string backend = "cpu";
  std::string initializer = "auto";  // as ParseInitializer takes it
  std::uint64_t seed = 0;
};

// Those that this build knows, compiled in or not. "cpu" takes the best SIMD level that the
// processor has, "cpu-avx2" that one; the results are the same. "cuda" is the first GPU,
// "cuda-emulated" the GPU's code run by the CPU thread by thread, and "auto" the GPU if there is
// one that can serve.
std::vector<std::string> BackendNames();
inline constexpr const char* kBackendHelp =
    "Where it computes: cpu (or cpu-sse2, cpu-avx2, cpu-avx512), cuda, cuda-emulated, or auto: a "
    "GPU if there is one";

// What "auto" stands for on this machine, which it says on stderr, and why; other names as they
// are.
std::string ResolvedBackend(const std::string& name);

// Each throws silt::Error for an unknown name, and MakeBackend for one that is not compiled in or
// finds no device.
std::unique_ptr<const tracker::Backend> MakeBackend(const std::string& name);

// The tracker is given the first true pose, and no other.
tracker::KeyframeTracker MakeTracker(const PinholeCamera& camera, const TrackerSetup& setup,
                                     const SE3d& first_world_from_camera);

// The resolved options, for the manifest.
Json ToJson(const TrackerSetup& setup);

}  // namespace silt::experiments
