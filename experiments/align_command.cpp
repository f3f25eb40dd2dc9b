// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/align.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

struct Options {
  std::vector<std::string> reference, current;  // rgb depth; rgb [depth]
  std::string pairs, json;
  std::vector<double> camera, initial;
  int threads = 0;
  AlignSetup setup;
};

std::vector<PairFiles> Pairs(const Options& options) {
  const bool one = !options.reference.empty() || !options.current.empty();
  if (one == !options.pairs.empty()) throw Error("align: give either --ref and --cur, or --pairs");
  if (!one) return ReadPairList(options.pairs);
  if (options.reference.size() != 2) throw Error("--ref: give its colour and its depth");
  if (options.current.empty()) throw Error("--cur: give its colour, and its depth if there is one");
  return {{options.reference[0], options.reference[1], options.current[0],
           options.current.size() == 2 ? options.current[1] : ""}};
}

void SetCamera(const std::vector<double>& k, AlignSetup* setup) {
  for (const double value : k) {
    if (!std::isfinite(value)) throw Error("--camera: fx fy cx cy must be finite");
  }
  if (k[0] <= 0 || k[1] == 0) throw Error("--camera: fx must be above 0 and fy not 0");
  setup->mirrored = k[1] < 0;
  setup->camera = {k[0], std::abs(k[1]), k[2], k[3]};
}

void SetInitial(const std::vector<double>& t, AlignSetup* setup) {
  if (t.empty()) return;
  const Quaterniond q{t[6], t[3], t[4], t[5]};
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(norm > 0.99 && norm < 1.01 && std::isfinite(t[0] + t[1] + t[2]))) {
    throw Error("--initial: tx ty tz qx qy qz qw must be finite, the quaternion of unit length");
  }
  setup->initial = SE3d{q.Normalized(), {t[0], t[1], t[2]}};
}

void Run(Options options, const Invocation& invocation) {
  SetThreadCount(options.threads);
  SetCamera(options.camera, &options.setup);
  SetInitial(options.initial, &options.setup);
  CheckStart(options.setup);
  const std::vector<PairFiles> pairs = Pairs(options);
  Json results = Json::array();
  std::string text;
  for (const PairFiles& files : pairs) {
    ThrowIfInterrupted();
    const AlignedPair pair = AlignFiles(files, options.setup);
    Json result{{"reference", files.reference_rgb.string()},
                {"current", files.current_rgb.string()}};
    result.update(ToJson(pair));
    results.push_back(std::move(result));
    if (pairs.size() > 1) text += files.current_rgb.string() + "\n";
    text += Format(pair);
  }
  if (!options.json.empty()) {
    const Json config{{"camera", options.camera},
                      {"depth_per_metre", options.setup.depth_per_metre},
                      {"initial", options.initial.empty() ? Json() : Json(options.initial)},
                      {"tracker", ToJson(options.setup.tracker)}};
    WriteJson(options.json,
              {{"manifest", MakeManifest(invocation.command_line, config, 0)}, {"pairs", results}});
  }
  if (options.json != "-") Print(text);
}

}  // namespace

void AddAlignCommand(CLI::App& program, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  AlignSetup& setup = options->setup;
  setup.tracker.preset = "accurate";
  CLI::App* command = program.add_subcommand(
      "align", "Estimate the motion between two RGB-D images, or those of a list of pairs");
  command->add_option("--ref", options->reference, "Reference image: colour and depth")
      ->expected(2);
  command->add_option("--cur", options->current, "Current image: colour, and depth if any")
      ->expected(1, 2);
  command->add_option("--pairs", options->pairs,
                      "List of pairs, a line each: ref_rgb ref_depth cur_rgb [cur_depth]");
  command
      ->add_option("--camera", options->camera,
                   "fx fy cx cy in pixels; fy < 0: y points up, as in ICL-NUIM's own poses")
      ->expected(4)
      ->required();
  RequireNumber(
      command
          ->add_option("--depth-scale", setup.depth_per_metre, "Steps of the depth files per metre")
          ->capture_default_str(),
      1e-3, 1e9);
  command
      ->add_option("--initial", options->initial,
                   "Where to start, with --init auto, identity or rotation:\n"
                   "current_from_reference as tx ty tz qx qy qz qw")
      ->expected(7);
  command
      ->add_option("--init", setup.tracker.initializer,
                   "Where it starts: auto (as the preset has it), identity, rotation (a coarse\n"
                   "alignment), surf, sift, orb or akaze")
      ->capture_default_str();
  command->add_option("--preset", setup.tracker.preset, "accurate, fast, paper, paper-all-pixels")
      ->capture_default_str();
  AddBackendOption(*command, setup.tracker.backend);
  RequireInteger(command->add_option("--threads", options->threads, "0: one per processor"), 0,
                 1024);
  command->add_option("--json", options->json, "Write results and manifest here (-: to stdout)");
  command->footer(
      "current_from_reference takes points of the reference camera into the current one (x right, "
      "y\n"
      "down, z forward, unless fy < 0); its covariance is that of ξ = (ω, v), applied on the "
      "left.\n"
      "Its TUM line starts with the time that the current image's name tells, or with 0. A pair "
      "that is\n"
      "lost has none of these; in JSON they are null. Colours of 16 bits count as their upper 8.\n"
      "Example: silt align --ref a.png a_depth.png --cur b.png b_depth.png --camera 525 525 319.5 "
      "239.5");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
