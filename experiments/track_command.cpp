// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/io/icl_camera.h"
#include "silt/core/io/sequence_format.h"
#include "silt/core/parallel.h"
#include "silt/core/undistortion.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/evaluation.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/keyframe_map.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/simulation_options.h"
#include "silt/experiments/tracker_setup.h"
#include "silt/experiments/tracking_run.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string folder, layout = "auto", out, json, map;
  double voxel_m = 0.01;
  std::vector<double> camera;  // fx fy cx cy, or empty
  std::optional<double> tolerance_s;
  int every = 1;
  SimulationOptions simulation;
  TrackerSetup tracker;
  std::string graph = "none";
};

struct Tracked {
  TrackingResult result;
  std::vector<tracker::Keyframe> keyframes;
  PinholeCamera camera;
  Trajectory truth;  // empty where there is none
  Json source, graph;
};

// The tracker knows pinhole cameras only.
constexpr const char* kUndistorts = "the frames are undistorted before they are tracked";

std::string FrameOf(int number, int frames) {
  return "frame " + std::to_string(number) + " of " + std::to_string(frames);
}

// The size is that of the first image.
PinholeCamera CameraFrom(const std::vector<double>& values) {
  if (values.empty()) return {};
  if (!(values[0] > 0) || values[1] == 0) throw Error("--camera: fx must be above 0 and fy not 0");
  return {values[0], values[1], values[2], values[3]};
}

// The true pose nearest in time, where one is near enough to be that of the frame.
std::optional<SE3d> TruthAt(const Trajectory& truth, double time_s) {
  constexpr double kTolerance_s = 0.02;
  if (truth.empty()) return {};
  const StampedPose& nearest = truth[NearestIndex(Times(truth), time_s)];
  if (std::abs(nearest.time_s - time_s) > kTolerance_s) return {};
  return nearest.world_from_camera;
}

void Take(const TrackingRun& run, const PinholeCamera& camera, Tracked* tracked) {
  tracked->result = run.Result();
  tracked->keyframes = run.Keyframes();
  tracked->graph = run.GraphJson();
  tracked->camera = camera;
}

// As the folder's ground truth has them: ICL-NUIM's, whose fy is negative, have axes of their own.
Trajectory InAxesOf(const std::vector<double>& camera, Trajectory poses) {
  if (camera.empty() || camera[1] > 0) return poses;
  for (StampedPose& pose : poses) pose.world_from_camera = IclFromSilt(pose.world_from_camera);
  return poses;
}

// The folder's ground truth serves for the first pose and for the evaluation.
Tracked TrackFolder(const Options& options) {
  const auto sequence =
      OpenSequence(options.layout, options.folder,
                   {CameraFrom(options.camera), options.every, options.tolerance_s});
  Tracked tracked;
  tracked.source = {{"folder", options.folder}, {"take_every", options.every}};
  if (options.tolerance_s) tracked.source["tolerance_s"] = *options.tolerance_s;
  tracked.truth = sequence->truth();
  SE3d first;
  if (!tracked.truth.empty()) {
    const double start_s = sequence->times_s().front();
    first = tracked.truth[NearestIndex(Times(tracked.truth), start_s)].world_from_camera;
  }
  TrackingRun run(sequence->camera(), options.tracker, first, ParseGraphUse(options.graph));
  Progress progress(sequence->size());
  int number = 0;
  while (const std::optional<Frame> frame = sequence->Next()) {
    ThrowIfInterrupted();
    run.Track(*frame, TruthAt(tracked.truth, frame->time_s));
    progress.Advance(1, FrameOf(++number, sequence->size()));
  }
  Take(run, sequence->camera(), &tracked);
  return tracked;
}

Tracked TrackSimulation(const Options& options) {
  const RenderPlan plan = options.simulation.Plan();
  const World world = LoadWorld(options.simulation.scene, options.simulation.trajectory,
                                options.simulation.Lighting());
  Tracked tracked;
  tracked.source = {{"world", world.ToJson()}, {"render", plan.ToJson()}};
  tracked.truth = TruePoses(world, plan.stretch);
  const int frames = int(tracked.truth.size());
  TrackingRun run(plan.options.camera, options.tracker, tracked.truth.front().world_from_camera,
                  ParseGraphUse(options.graph));
  Progress progress(frames);
  std::optional<Undistortion> undistortion;
  if (!plan.options.lens.IsNone()) {
    spdlog::info("{}", kUndistorts);
    undistortion.emplace(plan.options.camera, plan.options.lens);
  }
  ForEachFrame(world, plan, [&](const RenderedFrame& rendered) {
    run.Track(undistortion ? undistortion->Apply(rendered.frame) : rendered.frame,
              rendered.truth.world_from_camera);
    progress.Advance(1, FrameOf(rendered.number + 1, frames));
  });
  Take(run, plan.options.camera, &tracked);
  return tracked;
}

Json ToJson(const tracker::StageTimes& times) {
  return {{"pyramid", times.pyramid_ms},   {"initial_estimate", times.initial_estimate_ms},
          {"residual", times.residual_ms}, {"jacobian", times.jacobian_ms},
          {"update", times.update_ms},     {"total", times.total_ms}};
}

// A row per frame; the covariance is that of TrackedFrame.
Json FrameRows(const TrackingResult& r) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < r.estimate.size(); ++i) {
    const tracker::Covariance6& c = r.covariance[i];
    rows.push_back({{"time_s", r.estimate[i].time_s},
                    {"status", tracker::Name(r.status[i])},
                    {"keyframe", bool(r.is_keyframe[i])},
                    {"position_deviation_m", std::sqrt(c[21] + c[28] + c[35])},
                    {"orientation_deviation_rad", std::sqrt(c[0] + c[7] + c[14])},
                    {"covariance", c}});
  }
  return rows;
}

Json Summary(const Tracked& tracked, const std::optional<Evaluation>& evaluation) {
  const TrackingResult& r = tracked.result;
  Json json{{"frames", r.estimate.size()},
            {"keyframes", r.keyframes()},
            {"doubtful", r.doubtful()},
            {"lost", r.lost()},
            {"ms_per_frame", r.mean_times.total_ms},
            {"stages_ms", ToJson(r.mean_times)},
            {"graph", tracked.graph},
            {"messages", r.messages}};
  json["evaluation"] = evaluation ? ToJson(*evaluation) : Json(nullptr);
  return json;
}

void MakeMap(const Options& options, const Tracked& tracked, Json manifest) {
  OutputFolder folder(options.map);
  manifest["map"] = WriteMap(
      folder.path(), {tracked.keyframes, tracked.camera, tracked.result.estimate, options.voxel_m});
  folder.Commit(manifest);
}

void Run(Options options, const Invocation& invocation) {
  if (options.folder.empty() == options.simulation.scene.empty()) {
    throw Error("track: give either a sequence's folder or --scene");
  }
  if (options.folder.empty() && !options.camera.empty()) {
    throw Error("track: --camera is for a sequence's folder; a rendered one has its own");
  }
  SetThreadCount(options.simulation.threads);
  options.tracker.seed = options.simulation.seed;
  const Tracked tracked = options.folder.empty() ? TrackSimulation(options) : TrackFolder(options);
  const TrackingResult& result = tracked.result;
  for (const std::string& message : result.messages) spdlog::warn("{}", message);
  std::optional<Evaluation> evaluation;
  if (!tracked.truth.empty()) evaluation = Evaluate(tracked.truth, result.estimate);

  const Json config{
      {"source", tracked.source}, {"tracker", ToJson(options.tracker)}, {"graph", options.graph}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.tracker.seed);
  WriteTumTrajectory(options.out, InAxesOf(options.camera, result.estimate));
  if (!options.json.empty()) {
    Json json = Summary(tracked, evaluation);
    json["per_frame"] = FrameRows(result);
    json["manifest"] = manifest;
    WriteJson(options.json, json);
  }
  if (!options.map.empty()) MakeMap(options, tracked, manifest);
  if (options.json == "-") return;
  char line[200];
  std::snprintf(line, sizeof line,
                "%zu frames, %d keyframes, %d doubtful, %d lost, %.1f ms per frame: %s\n",
                result.estimate.size(), result.keyframes(), result.doubtful(), result.lost(),
                result.mean_times.total_ms, options.out.c_str());
  Print(line + (evaluation ? FormatEvaluation(*evaluation) : std::string()));
}

void AddTrackerOptions(CLI::App& command, Options& options) {
  command
      .add_option("--preset", options.tracker.preset,
                  "Tracker: paper, paper-all-pixels (hidden ones too), accurate, fast")
      ->capture_default_str();
  AddBackendOption(command, options.tracker.backend);
  command
      .add_option(
          "--init", options.tracker.initializer,
          "Where an alignment starts: auto (as the preset has it), identity (the keyframe's "
          "pose), previous, constant-velocity, rotation (a coarse alignment), surf, sift, "
          "orb, akaze, or truth, which may be off: truth:0.02m,1deg")
      ->capture_default_str();
  command
      .add_flag("--graph{after}", options.graph,
                "Write poses as a graph over the keyframes corrects them in the end: it aligns\n"
                "keyframes with others that they share views with, old ones too.\n"
                "--graph=background: it works while tracking goes on and moves the keyframes,\n"
                "and poses are written as they were told")
      ->check(CLI::IsMember({"none", "after", "background"}));
}

}  // namespace

void AddTrackCommand(CLI::App& program, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "track", "Estimate the camera's poses, from a folder or with the simulation in the loop");
  command->add_option("folder", options->folder, "Sequence in a folder");
  std::vector<std::string> layouts = ReadableFormats();
  layouts.insert(layouts.begin(), "auto");
  command->add_option("--layout", options->layout, "Its layout: tum, icl, euroc, raw; auto: look")
      ->check(CLI::IsMember(layouts))
      ->capture_default_str();
  command
      ->add_option(
          "--camera", options->camera,
          "fx fy cx cy of a tum folder in pixels, instead of its camera.txt; fy < 0: with\n"
          "ICL-NUIM's poses, in whose axes the estimate is then written as well")
      ->expected(4);
  command->add_option("--out", options->out, "Trajectory to write, in TUM's format")->required();
  command->add_option("--json", options->json, "Write figures and manifest here (-: to stdout)");
  command->add_option(
      "--map", options->map,
      "Folder to make of what the keyframes saw: cloud.ply, mesh.ply (by Open3D, where the\n"
      "build has found it), cameras.ply (keyframes and path), path.txt and figures/map.png");
  RequireNumber(command->add_option("--voxel", options->voxel_m, "Size of the map's voxels [m]")
                    ->capture_default_str(),
                1e-4, 10);
  RequireInteger(command
                     ->add_option("--fps-skip,--every", options->every,
                                  "Of the folder, every n-th frame alone")
                     ->capture_default_str(),
                 1, 1000000);
  RequireNumber(command->add_option("--tolerance", options->tolerance_s,
                                    "Of a tum folder without associations.txt: seconds between\n"
                                    "colour and depth of one frame at most; default: 0.02"),
                0, 1000);
  AddTrackerOptions(*command, *options);
  AddSimulationOptions(*command, options->simulation, false);
  command->footer(
      "The tracker is given the first true pose, where there is one, and no other.\n"
      "Examples: silt track office20 --out estimate.txt\n"
      "          silt track rgbd_dataset_freiburg1_xyz --camera 525 525 319.5 239.5 --out xyz.txt\n"
      "          silt track --scene office --trajectory desk --duration 2 --out estimate.txt");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
