// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/core/io/image_file.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/light_comparison.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/resources.h"
#include "silt/experiments/traced_pictures.h"
#include "silt/sim/response_curve.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string scene = "office", traced, out;
  std::vector<std::string> trajectories{"desk", "tour"};
  int views = 10, threads = 0;
  bool quick = false;
  PathReference reference;
};

Options Resolved(const Options& given) {
  Options o = given;
  if (!o.quick) return o;
  o.scene = "studio";
  o.trajectories = {"orbit"};
  o.views = 2;
  o.reference.width = 80;
  o.reference.samples_per_pixel = 64;
  return o;
}

Json ConfigOf(const Options& o) {
  return {{"scene", o.scene},
          {"trajectories", o.trajectories},
          {"views", o.views},
          {"width", o.reference.width},
          {"reference_samples_per_pixel", o.reference.samples_per_pixel},
          {"specular", o.reference.reflection}};
}

std::shared_ptr<const sim::LitScene> Bake(const Options& options, std::uint64_t seed) {
  Progress progress(1);
  double done = 0;
  sim::LightingOptions lighting;
  lighting.seed = seed;
  lighting.specular = options.reference.reflection;
  lighting.progress = [&](double share) {
    ThrowIfInterrupted();
    progress.Advance(share - std::exchange(done, share), "light of seed " + std::to_string(seed));
  };
  return std::make_shared<const sim::LitScene>(sim::LoadScene(SceneFile(options.scene)), lighting);
}

std::vector<Image<Vec3f>> RenderAll(const std::shared_ptr<const sim::LitScene>& scene,
                                    const std::vector<LightView>& views, int width) {
  std::vector<Image<Vec3f>> pictures;
  for (const LightView& view : views) pictures.push_back(RenderBaked(scene, view, width));
  return pictures;
}

Image<Rgb8> Developed(Image<Vec3f> radiance, double exposure) {
  for (Vec3f& value : radiance) value = float(exposure) * value;
  return sim::ResponseCurve().Encode8(radiance);
}

void Run(const Options& given, const Invocation& invocation) {
  const Options options = Resolved(given);
  SetThreadCount(options.threads);
  OutputFolder folder(options.out);
  const TracedPictures traced(options.reference, options.traced);
  const std::vector<LightView> views =
      ViewsAlong(options.scene, options.trajectories, options.views);
  const auto scene = Bake(options, options.reference.seed);
  const double exposure = scene->scene().exposure;
  const std::vector<Image<Vec3f>> baked = RenderAll(scene, views, options.reference.width);
  const double seeds = RmsDifference(
      baked, RenderAll(Bake(options, options.reference.seed + 1), views, options.reference.width),
      exposure);

  Progress progress(double(views.size()));
  std::vector<ReferencePicture> references;
  Json rows = Json::array();
  std::string table = "view            mean   p99   bias  noise  (of 255)\n";
  const auto add_row = [&](const std::string& name, const LightDifference& d) {
    Json row{{"view", name}};
    row.update(ToJson(d));
    rows.push_back(row);
    char line[120];
    std::snprintf(line, sizeof(line), "%-14s %5.2f %5.2f %6.2f %6.2f\n", name.c_str(), d.mean,
                  d.percentile_99, d.bias, d.reference_noise);
    table += line;
  };
  for (std::size_t i = 0; i < views.size(); ++i) {
    ThrowIfInterrupted();
    references.push_back(traced.Of(*scene, views[i], std::uint32_t(i)));
    progress.Advance(1, "paths of " + views[i].name);
    const Image<Vec3f> reference = references.back().Mean();
    const auto file = [&](const char* kind) { return folder.path() / (views[i].name + kind); };
    WriteRgb(file("_baked.png"), Developed(baked[i], exposure));
    WriteRgb(file("_traced.png"), Developed(reference, exposure));
    WriteRgb(file("_difference.png"), DifferencePicture(baked[i], reference, exposure));
    add_row(views[i].name, Compare({baked[i]}, {references[i]}, exposure));
  }
  add_row("all", Compare(baked, references, exposure));

  const Json manifest =
      MakeManifest(invocation.command_line, ConfigOf(options), options.reference.seed);
  WriteJson(folder.path() / "light.json",
            {{"manifest", manifest}, {"differences", rows}, {"rms_of_two_bakes", seeds}});
  WriteFileAtomically(folder.path() / "differences.csv", FormatCsv(rows));
  folder.Commit(manifest);
  char line[120];
  std::snprintf(line, sizeof(line), "two bakes differ by %.3f of 255 rms\n", seeds);
  Print(table + line + "Results: " + options.out + "\n");
}

}  // namespace

void AddLightExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "light", "Baked light against path-traced light, and two bakes against each other");
  command->add_option("--scene", options->scene, "Scene by name or path")->capture_default_str();
  command->add_option("--trajectory", options->trajectories, "Camera paths that share the views")
      ->capture_default_str();
  const auto integer = [&](const char* name, int& value, int low, int high, const char* help) {
    RequireInteger(command->add_option(name, value, help)->capture_default_str(), low, high);
  };
  integer("--views", options->views, 1, 1000, "Views, evenly along the paths");
  integer("--spp", options->reference.samples_per_pixel, 2, 1 << 20,
          "Paths per pixel of the reference");
  integer("--width", options->reference.width, 16, 4096, "Width of the image; its height is 3/4");
  command->add_flag("--specular", options->reference.reflection,
                    "Compare with reflections; else all surfaces are matt");
  RequireInteger(
      command->add_option("--seed", options->reference.seed, "Seed")->capture_default_str(), 0,
      1LL << 60);
  integer("--threads", options->threads, 0, 1024, "Threads; 0: one per processor");
  command->add_option("--traced", options->traced,
                      "Folder where the traced pictures are kept: what an earlier run with the\n"
                      "same scene, views and paths left there is not traced again");
  command->add_flag("--quick", options->quick, "Two small views of the studio, 64 paths per pixel");
  command->add_option("--out", options->out, "Folder to make; refused where others' files lie")
      ->required();
  command->footer(
      "Differences are those of 8-bit sRGB pictures before rounding, in 1/255; noise is the\n"
      "standard error of the reference. 4096 paths per pixel take about an hour on two cores.\n"
      "Example: silt experiment light --spp 256 --out results/light");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
