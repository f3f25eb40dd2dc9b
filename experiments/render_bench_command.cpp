// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/render_bench.h"
#include "silt/experiments/resources.h"
#include "silt/sim/light_cache.h"
#include "silt/sim/path_file.h"

namespace silt::experiments {
namespace {

struct Options {
  RenderBenchOptions bench;
  std::string scene = "office", trajectory, json;
  bool no_bake = false;
  int threads = 0;
};

class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The light of a scene from scratch, and into the cache, whatever is there.
double BakeSeconds(const sim::Scene& scene) {
  Progress progress(1);
  double done = 0;
  sim::LightingOptions options;
  options.progress = [&](double share) {
    progress.Advance(share - std::exchange(done, share), "light");
  };
  const sim::RayTracer tracer(scene);
  const sim::SurfaceGrid grid(scene.mesh, options.direct_spacing_m);
  const Stopwatch watch;
  const sim::BakedLight light = SolveLight(scene, tracer, grid, options);
  const double seconds = watch.Seconds();
  if (const auto file = LightCacheFile(scene, options)) WriteLight(*file, light);
  return seconds;
}

// A scene with its light, and how long that took.
struct Built {
  std::shared_ptr<const sim::LitScene> scene;
  double seconds = 0;
  bool computed_light = false;
};

Built Build(sim::Scene scene) {
  Built built;
  sim::LightingOptions options;
  options.progress = [&built](double) { built.computed_light = true; };
  const Stopwatch watch;
  built.scene = std::make_shared<const sim::LitScene>(std::move(scene), options);
  built.seconds = watch.Seconds();
  return built;
}

// Light that the cache lacks is computed first and read in a second go, which is the one that
// counts. (That of a small scene is computed each time: it is not kept.)
Built BuildFromCache(sim::Scene scene, const std::filesystem::path& file) {
  Built built = Build(std::move(scene));
  if (!built.computed_light) return built;
  built.scene.reset();
  return Build(sim::LoadScene(file));
}

// Of this process, or of the one among its children, which import the models, that took most.
double PeakMegabytes() {
  long peak_kib = 0;  // Linux counts in KiB
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage;
    getrusage(who, &usage);
    peak_kib = std::max(peak_kib, usage.ru_maxrss);
  }
  return double(peak_kib) / 1024;
}

void Run(const Options& options, const Invocation& invocation) {
  SetThreadCount(options.threads);
  const auto scene_file = SceneFile(options.scene);
  const auto path_file = PathFile(scene_file, options.trajectory);
  const Stopwatch load;
  sim::Scene scene = sim::LoadScene(scene_file);
  double load_s = load.Seconds();
  std::optional<double> bake_s;
  if (!options.no_bake) bake_s = BakeSeconds(scene);
  const Built built = BuildFromCache(std::move(scene), scene_file);
  load_s += built.seconds;

  const World world{scene_file, path_file, built.scene, sim::LoadCameraPath(path_file)};
  const RenderBench bench = MeasureRendering(world, options.bench);
  const int threads = ThreadCount();
  Json json = bench.ToJson(threads);
  json["load_s"] = load_s;
  json["bake_s"] = bake_s ? Json(*bake_s) : Json(nullptr);
  json["peak_rss_mb"] = PeakMegabytes();
  const Json config{{"world", world.ToJson()}, {"bench", options.bench.ToJson()}};
  json["manifest"] = MakeManifest(invocation.command_line, config, 0);
  if (!options.json.empty()) WriteJson(options.json, json);
  if (options.json == "-") return;
  char line[200];
  std::snprintf(line, sizeof line, "Load and build %.2f s, bake %s, peak memory %.0f MiB.\n",
                load_s,
                bake_s ? (std::to_string(int(*bake_s + 0.5)) + " s").c_str() : "not measured",
                PeakMegabytes());
  Print(bench.Format(threads) + line);
}

}  // namespace

void AddRenderBench(CLI::App& bench, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand("render", "How fast frames are rendered");
  command->add_option("--scene", options->scene, "Scene by name or path")->capture_default_str();
  command->add_option("--trajectory", options->trajectory,
                      "Camera path by name or path; default: desk, or the only one");
  const auto integer = [&](const char* name, int& value, int low, int high, const char* help) {
    RequireInteger(command->add_option(name, value, help)->capture_default_str(), low, high);
  };
  integer("--width", options->bench.width, 16, 8192, "Width of the image; its height is 3/4 of it");
  integer("--instants", options->bench.instants, 1, 1000, "Instants of the path, evenly spread");
  integer("--repeats", options->bench.repeats, 1, 1000, "Of which the fastest counts");
  integer("--threads", options->threads, 0, 1024, "Threads; 0: one per processor");
  command->add_flag("--no-bake", options->no_bake,
                    "Take the light from the cache if it is there, and do not time it");
  command->add_option("--json", options->json, "File for the results; -: stdout");
  command->footer(
      "Embree's own speed is that of rtcIntersect16 on the same rays, packed beforehand, and is\n"
      "measured in turn with silt's. Mrays/s and ratio are of processor time, of which other\n"
      "programs on the machine steal less; frames per second are by the clock.\n"
      "Example: silt bench render --json render.json");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
