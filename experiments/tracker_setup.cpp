// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracker_setup.h"

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/sparse/sparse_initializer.h"

namespace silt::experiments {
namespace {

[[noreturn]] void Unknown(const std::string& kind, const std::string& name,
                          const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  throw Error("no " + kind + " is named '" + name + "'; there are: " + list);
}

}  // namespace

std::vector<std::string> PresetNames() { return {"paper", "paper-all-pixels", "accurate", "fast"}; }
std::vector<std::string> BackendNames() {
  return {"cpu", "cpu-sse2", "cpu-avx2", "cpu-avx512", "cuda"};
}
std::vector<std::string> InitializerNames() { return {"sparse", "previous"}; }

tracker::TrackerOptions PresetOptions(const std::string& preset) {
  if (preset == "paper") return tracker::PaperPreset();
  if (preset == "paper-all-pixels") return tracker::PaperAllPixelsPreset();
  if (preset == "accurate") return tracker::AccuratePreset();
  if (preset == "fast") return tracker::FastPreset();
  Unknown("preset", preset, PresetNames());
}

std::unique_ptr<const tracker::Backend> MakeBackend(const std::string& name) {
  if (name == "cpu") return tracker::MakeCpuBackend();
  if (name == "cpu-sse2" || name == "cpu-avx2" || name == "cpu-avx512") {
    return tracker::MakeCpuBackend(tracker::SimdLevelFromName(name.substr(4)));
  }
  if (name == "cuda") {
    throw Error("--backend cuda: this build holds no CUDA tracker; use --backend cpu");
  }
  Unknown("backend", name, BackendNames());
}

std::unique_ptr<tracker::Initializer> MakeInitializer(const std::string& name) {
  if (name == "sparse") return std::make_unique<tracker::SparseInitializer>();
  if (name == "previous") return nullptr;
  Unknown("initializer", name, InitializerNames());
}

tracker::KeyframeTracker MakeTracker(const PinholeCamera& camera, const TrackerSetup& setup,
                                     const SE3d& first_world_from_camera) {
  tracker::TrackerOptions options = PresetOptions(setup.preset);
  options.seed = setup.seed;
  return tracker::KeyframeTracker(camera, options, MakeBackend(setup.backend),
                                  MakeInitializer(setup.initializer), first_world_from_camera);
}

Json ToJson(const TrackerSetup& setup) {
  const tracker::TrackerOptions o = PresetOptions(setup.preset);
  return {{"preset", setup.preset},
          {"backend", setup.backend},
          {"initializer", setup.initializer},
          {"seed", setup.seed},
          {"alignment",
           {{"max_iterations_fine_to_coarse", o.alignment.max_iterations},
            {"initial_damping", o.alignment.initial_damping},
            {"damping_factor", o.alignment.damping_factor},
            {"min_update_norm", o.alignment.min_update_norm},
            {"min_overlap", o.alignment.min_overlap},
            {"exclude_hidden", o.alignment.exclude_hidden},
            {"use_current_depth", o.alignment.use_current_depth},
            {"depth_edge_margin_px", o.alignment.depth_edge_margin_px},
            {"robust_scale", o.alignment.robust_scale},
            {"robust_gradient", o.alignment.robust_gradient},
            {"depth_residual", o.alignment.depth_residual}}},
          {"keyframes",
           {{"max_distance_m", o.keyframes.max_distance_m},
            {"max_rotation_deg", o.keyframes.max_rotation_deg},
            {"min_measured_depth", o.keyframes.min_measured_depth},
            {"metres_per_radian", o.keyframes.metres_per_radian},
            {"joint", o.keyframes.joint}}},
          {"always_initialize", o.always_initialize},
          {"max_unexplained_variance", o.max_unexplained_variance},
          {"max_depth_disagreement", o.max_depth_disagreement}};
}

}  // namespace silt::experiments
