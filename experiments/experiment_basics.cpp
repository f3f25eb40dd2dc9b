// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/experiment_basics.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "silt/experiments/option_checks.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {

ExperimentBasics ExperimentBasics::Resolved() const {
  ExperimentBasics resolved = *this;
  if (scene.empty()) resolved.scene = quick ? "studio" : "office";
  if (width == 0) resolved.width = quick ? 320 : 640;
  return resolved;
}

sim::RenderOptions ExperimentBasics::Rendering(bool blur_and_noise) const {
  sim::RenderOptions options = PaperRenderOptions(blur_and_noise);
  options.camera = IclNuimCameraOfWidth(width);
  options.samples_per_pixel = samples_per_pixel;
  options.seed = seed;
  return options;
}

Json ExperimentBasics::ToJson() const {
  return {{"scene", scene},     {"trajectory", trajectory},
          {"backend", backend}, {"width", width},
          {"seed", seed},       {"samples_per_pixel", samples_per_pixel},
          {"quick", quick}};
}

void AddExperimentBasics(CLI::App& command, ExperimentBasics& o) {
  command.add_option("--out", o.out, "Folder to make; silt's own earlier results are replaced")
      ->required();
  command.add_flag("--quick", o.quick, "Little, of the studio at 320x240: to see that all works");
  command.add_option("--scene", o.scene, "Scene by name or path; default: office");
  command.add_option("--trajectory", o.trajectory,
                     "Camera path by name or path; default: desk, or the only one");
  AddBackendOption(command, o.backend);
  RequireInteger(command.add_option("--width", o.width, "Width of the image; default: 640"), 64,
                 8192);
  RequireInteger(
      command.add_option("--spp", o.samples_per_pixel, "Samples per pixel")->capture_default_str(),
      1, 4096);
  RequireInteger(
      command.add_option("--seed", o.seed, "Seed of all randomness")->capture_default_str(), 0,
      1000000000);
  RequireInteger(command.add_option("--threads", o.threads, "Threads; 0: one per processor")
                     ->capture_default_str(),
                 0, 1024);
}

}  // namespace silt::experiments
