// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/trajectory.h"
#include "silt/experiments/json.h"
#include "silt/sim/camera_path.h"
#include "silt/sim/lit_scene.h"
#include "silt/sim/renderer.h"

// What all experiments share: a scene with a camera path, and frames of it in memory.
namespace silt::experiments {

// A scene and a path through it, loaded and lit.
struct World {
  std::filesystem::path scene_file, path_file;
  std::shared_ptr<const sim::LitScene> scene;
  sim::CameraPath path;

  sim::PoseAtTime Pose() const;
  Json ToJson() const;
};

// Names or paths, as SceneFile and PathFile take them. Tells of its progress and of the scene's
// warnings on stderr.
World LoadWorld(const std::string& scene, const std::string& path,
                const sim::LightingOptions& lighting = {});

// The frames at the instants k/fps of a stretch of the path; k numbers a frame, whatever stretch it
// is part of.
struct Stretch {
  double fps = 60;
  double start_s = 0;
  double duration_s = 0;  // 0: to the end of the path

  Json ToJson() const;
};

// True poses of the stretch. Throws silt::Error where it reaches beyond the path or has no frame.
Trajectory TruePoses(const World& world, const Stretch& stretch);

// What is rendered: a stretch with one shutter and sensor.
struct RenderPlan {
  sim::RenderOptions options;
  bool meter_exposure = false;  // one for the whole stretch, instead of options.exposure
  Stretch stretch;
  // With noise, each instant is rendered once and handed over once for each of these seeds; empty:
  // for options.seed alone.
  std::vector<std::uint64_t> noise_seeds;

  Json ToJson() const;
};

// The plan with the exposure that its stretch of the path asks for, where it is to be metered: that
// of eight small pictures along it.
RenderPlan WithExposure(const World& world, const RenderPlan& plan);

struct RenderedFrame {
  int number = 0;  // from 0 within the stretch
  std::uint64_t seed = 0;
  StampedPose truth;
  Frame frame;
};

// Renders the stretch and hands over frame after frame, in order; checks for an interruption before
// each.
void ForEachFrame(const World& world, const RenderPlan& plan,
                  const std::function<void(const RenderedFrame&)>& visit);

// One frame at any time of the path.
Frame RenderAt(const World& world, const sim::RenderOptions& options, double time_s);

// The sequences of the paper (§4.3), by name: "20fps", "60fps" and "60fps-blur", whose shutter is
// open for the whole 1/60 s (16 instants) and whose colours have Handa's noise. Rendered at 60 fps;
// the first takes every third frame.
struct PaperSequence {
  std::string name;
  int take_every = 1;
  bool blur_and_noise = false;
};
const std::vector<PaperSequence>& PaperSequences();
sim::RenderOptions PaperRenderOptions(bool blur_and_noise);

// The paper's camera with pictures of another width (a multiple of 4) that show the same.
PinholeCamera IclNuimCameraOfWidth(int width);

}  // namespace silt::experiments
