// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/case_runner.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "silt/core/error.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/resources.h"
#include "silt/experiments/sensor_options.h"
#include "silt/sim/content_hash.h"
#include "silt/sim/path_file.h"
#include "silt/sim/scene_digest.h"

namespace silt::experiments {
namespace {

constexpr double kPaperFps = 60;

std::shared_ptr<const sim::LitScene> LoadLitScene(const std::filesystem::path& file,
                                                  sim::LightingOptions lighting) {
  sim::Scene scene = sim::LoadScene(file);
  for (const std::string& warning : scene.warnings) spdlog::debug("{}", warning);
  Progress progress(1);
  double done = 0;
  lighting.progress = [&](double share) {
    ThrowIfInterrupted();
    progress.Advance(share - std::exchange(done, share), "light of " + file.string());
  };
  return std::make_shared<const sim::LitScene>(std::move(scene), lighting);
}

// Of the text alone: tells an edited scene file from the one of an earlier run.
std::string HashOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return sim::ContentHash().AddBytes(text.str().data(), text.str().size()).Digest();
}

// Of all that the scene file's text led to: models and pictures change without it.
std::string HashOf(const sim::Scene& scene) {
  const std::string look = sim::SceneDigest(scene, sim::SurfacesAre::kAsGiven);
  sim::ContentHash hash;
  hash.AddBytes(look.data(), look.size()).Add(scene.exposure);
  for (const sim::Instance& i : scene.instances) hash.Add(i.first_triangle).Add(i.triangle_count);
  return hash.Digest();
}

// Of poses 10 ms apart (a million at most): a recording that is replayed changes without the text.
std::string HashOf(const sim::CameraPath& path) {
  sim::ContentHash hash;
  for (const StampedPose& pose : path.Sample(std::min(100.0, 1e6 / path.duration_s()))) {
    const Quaterniond& q = pose.world_from_camera.rotation;
    const Vec3d& t = pose.world_from_camera.translation;
    for (const double value : {q.w, q.x, q.y, q.z, t.x, t.y, t.z}) hash.Add(value);
  }
  return hash.Digest();
}

}  // namespace

sim::PoseAtTime World::Pose() const {
  return [this](double time_s) { return path.WorldFromCamera(time_s); };
}

Json World::ToJson() const {
  const sim::PathStatistics s = path.Statistics();
  return {{"scene", scene->scene().name},
          {"scene_file", scene_file.string()},
          {"scene_hash", HashOf(scene_file)},
          {"scene_contents_hash", HashOf(scene->scene())},
          {"path_file", path_file.string()},
          {"path_hash", HashOf(path_file)},
          {"path_poses_hash", HashOf(path)},
          {"path_duration_s", s.duration_s},
          {"path_length_m", s.length_m},
          {"triangles", scene->scene().mesh.triangles.size()},
          {"light", scene->light() == sim::LightMode::kPath ? "path" : "baked"},
          {"specular", scene->reflection() != nullptr}};
}

World LoadWorld(const std::string& scene, const std::string& path,
                const sim::LightingOptions& lighting) {
  const std::filesystem::path scene_file = SceneFile(scene);
  const std::filesystem::path path_file = PathFile(scene_file, path);
  sim::CameraPath camera_path = sim::LoadCameraPath(path_file);
  return {scene_file, path_file, LoadLitScene(scene_file, lighting), std::move(camera_path)};
}

Json Stretch::ToJson() const {
  return {{"fps", fps}, {"start_s", start_s}, {"duration_s", duration_s}};
}

Trajectory TruePoses(const World& world, const Stretch& stretch) {
  const double rest_s = world.path.duration_s() - stretch.start_s;
  const double duration_s = stretch.duration_s > 0 ? stretch.duration_s : rest_s;
  const bool inside = stretch.start_s >= 0 && duration_s > 0 && duration_s <= rest_s + 1e-9;
  if (!inside) {
    throw Error(world.path_file.string() + ": lasts " + std::to_string(world.path.duration_s()) +
                " s; --start and --duration ask for more");
  }
  Trajectory poses = world.path.Sample(stretch.fps, stretch.start_s, std::min(duration_s, rest_s));
  if (poses.empty()) throw Error("the stretch is too short to hold a frame; raise --duration");
  return poses;
}

Json RenderPlan::ToJson() const {
  const PinholeCamera& c = options.camera;
  Json json{{"camera", {c.fx, c.fy, c.cx, c.cy, c.width, c.height}},
            {"samples_per_pixel", options.samples_per_pixel},
            {"exposure_s", options.shutter.exposure_s},
            {"time_samples", options.shutter.time_samples},
            {"row_time_s", options.shutter.row_time_s},
            {"filter", options.filter == sim::PixelFilter::kBox ? "box" : "gaussian"},
            {"pattern", options.pattern == sim::PixelPattern::kShared ? "shared" : "scrambled"},
            {"seeds", noise_seeds.empty() ? std::vector{options.seed} : noise_seeds}};
  using Kind = sim::Exposure::Kind;
  if (options.exposure.kind == Kind::kGiven) json["exposure"] = options.exposure.value;
  if (options.exposure.kind == Kind::kScene) json["exposure"] = "scene";
  if (options.exposure.kind == Kind::kPerFrame) json["exposure"] = "auto-frame";
  json.update(SensorJson(options));
  json.update(stretch.ToJson());
  return json;
}

RenderPlan WithExposure(const World& world, const RenderPlan& plan) {
  RenderPlan resolved = plan;
  if (!plan.meter_exposure) return resolved;
  constexpr std::size_t pictures = 8;
  sim::RenderOptions options;
  options.camera = IclNuimCameraOfWidth(160);
  const sim::Renderer renderer(world.scene, options);
  const Trajectory poses = TruePoses(world, plan.stretch);
  std::vector<Image<Vec3f>> radiance;
  for (std::size_t i = 0; i < pictures; ++i) {
    const StampedPose& pose = poses[i * (poses.size() - 1) / (pictures - 1)];
    radiance.push_back(renderer.RenderLinear(world.Pose(), pose.time_s));
  }
  resolved.options.exposure = {sim::Exposure::Kind::kGiven, sim::MeteredExposure(radiance)};
  resolved.meter_exposure = false;
  return resolved;
}

void ForEachFrame(const World& world, const RenderPlan& plan,
                  const std::function<void(const RenderedFrame&)>& visit) {
  const sim::Renderer renderer(world.scene, WithExposure(world, plan).options);
  const std::vector<std::uint64_t> seeds =
      plan.noise_seeds.empty() ? std::vector{plan.options.seed} : plan.noise_seeds;
  RenderedFrame rendered;
  for (const StampedPose& truth : TruePoses(world, plan.stretch)) {
    ThrowIfInterrupted();
    // Of the whole path, so that a stretch has the noise that it has within the whole.
    const auto index = std::uint32_t(std::llround(truth.time_s * plan.stretch.fps));
    const Image<Vec3f> linear = renderer.RenderLinear(world.Pose(), truth.time_s, int(index));
    const sim::GeometryBuffers geometry = renderer.RenderGeometry(world.Pose(), truth.time_s);
    rendered.truth = truth;
    for (const std::uint64_t seed : seeds) {
      rendered.seed = seed;
      const sim::NoiseKey key{seed, index};
      rendered.frame = {truth.time_s, renderer.Develop(linear, key),
                        renderer.MeasureDepth(geometry, key)};
      visit(rendered);
    }
    ++rendered.number;
  }
}

Frame RenderAt(const World& world, const sim::RenderOptions& options, double time_s) {
  const sim::Renderer renderer(world.scene, options);
  return renderer.Render(world.Pose(), time_s, int(std::llround(time_s * kPaperFps)));
}

const std::vector<PaperSequence>& PaperSequences() {
  static const std::vector<PaperSequence> sequences{
      {"20fps", 3, false}, {"60fps", 1, false}, {"60fps-blur", 1, true}};
  return sequences;
}

sim::RenderOptions PaperRenderOptions(bool blur_and_noise) {
  sim::RenderOptions options;
  if (blur_and_noise) {
    options.shutter.exposure_s = 1 / kPaperFps;
    options.shutter.time_samples = 16;
    options.sensor.noise = sim::HandaNoise{};
  }
  return options;
}

PinholeCamera IclNuimCameraOfWidth(int width) {
  const PinholeCamera& camera = kIclNuimCamera;
  if (width == camera.width) return camera;
  const double scale = double(width) / camera.width;
  return {camera.fx * scale,
          camera.fy * scale,
          (camera.cx + 0.5) * scale - 0.5,
          (camera.cy + 0.5) * scale - 0.5,
          width,
          width * 3 / 4};
}

}  // namespace silt::experiments
