// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracker_setup.h"

#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/cuda/block/emulated_backend.h"
#include "silt/experiments/tracker_options.h"
#include "silt/tracker/cpu_backend.h"
#ifdef SILT_HAVE_CUDA
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#endif

namespace silt::experiments {
namespace {

[[noreturn]] void Unknown(const std::string& kind, const std::string& name,
                          const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  throw Error("no " + kind + " is named '" + name + "'; there are: " + list);
}

// Empty where the GPU's backend can be had.
std::string WhyNoGpu() {
#ifdef SILT_HAVE_CUDA
  try {
    return cuda::WhyNoUsableDevice();
  } catch (const Error& error) {
    return error.what();
  }
#else
  return "built without nvcc";
#endif
}

}  // namespace

std::vector<std::string> BackendNames() {
  return {"cpu", "cpu-sse2", "cpu-avx2", "cpu-avx512", "cuda", "cuda-emulated", "auto"};
}

std::string ResolvedBackend(const std::string& name) {
  if (name != "auto") return name;
  const std::string why_not = WhyNoGpu();
  spdlog::info("--backend auto: {}", why_not.empty() ? "cuda" : "cpu (" + why_not + ")");
  return why_not.empty() ? "cuda" : "cpu";
}

std::unique_ptr<const tracker::Backend> MakeBackend(const std::string& name) {
  if (name == "cpu") return tracker::MakeCpuBackend();
  if (name == "cpu-sse2" || name == "cpu-avx2" || name == "cpu-avx512") {
    return tracker::MakeCpuBackend(tracker::SimdLevelFromName(name.substr(4)));
  }
  if (name == "cuda-emulated") return cuda::MakeEmulatedBackend();
#ifdef SILT_HAVE_CUDA
  if (name == "cuda") return cuda::MakeCudaBackend();
#else
  if (name == "cuda") {
    throw Error(
        "--backend cuda: this build was made without nvcc and holds no CUDA backend; use --backend "
        "cpu");
  }
#endif
  if (name == "auto") return MakeBackend(ResolvedBackend(name));
  Unknown("backend", name, BackendNames());
}

tracker::KeyframeTracker MakeTracker(const PinholeCamera& camera, const TrackerSetup& setup,
                                     const SE3d& first_world_from_camera) {
  const InitializerChoice choice = ParseInitializer(setup.initializer);
  const tracker::TrackerOptions preset = PresetOptions(setup.preset);
  tracker::TrackerOptions options = WithInitializer(preset, choice);
  options.seed = setup.seed;
  const std::shared_ptr<const tracker::Backend> backend = MakeBackend(setup.backend);
  return tracker::KeyframeTracker(
      camera, options, backend, MakeInitializer(choice, preset, backend), first_world_from_camera);
}

Json ToJson(const TrackerSetup& setup) {
  Json json = experiments::ToJson(
      WithInitializer(PresetOptions(setup.preset), ParseInitializer(setup.initializer)));
  json["preset"] = setup.preset;
  json["backend"] = setup.backend;
  json["initializer"] = setup.initializer;
  json["seed"] = setup.seed;
  return json;
}

}  // namespace silt::experiments
