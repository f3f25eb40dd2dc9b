// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/io/sequence_format.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/progress.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string in, out, from = "auto", to;
  std::vector<double> camera;  // fx fy cx cy, or empty
  int every = 1;
};

// Recorded truth (motion capture, say) has a clock of its own.
constexpr double kWidestGap_s = 0.1;

ReadingOptions ReadingOf(const Options& options) {
  ReadingOptions reading;
  reading.take_every = options.every;
  if (options.camera.empty()) return reading;
  const std::vector<double>& v = options.camera;
  if (!(v[0] > 0 && v[1] != 0)) throw Error("--camera: fx must be positive, and fy not 0");
  reading.camera = {v[0], v[1], v[2], v[3]};
  return reading;
}

// Poses of the frames that have one, and which these are.
SequenceDescription Describe(const RecordedSequence& sequence, std::vector<bool>& posed) {
  SequenceDescription description{sequence.camera(), {}, {}};
  for (const double time_s : sequence.times_s()) {
    const std::optional<SE3d> pose = InterpolatedPose(sequence.truth(), time_s, kWidestGap_s);
    posed.push_back(pose.has_value());
    if (pose) description.truth.push_back({time_s, *pose});
  }
  return description;
}

void Copy(RecordedSequence& sequence, const std::vector<bool>& posed, SequenceWriter& writer) {
  Progress progress(sequence.size());
  int number = 0;
  for (const bool has_pose : posed) {
    ThrowIfInterrupted();
    std::optional<Frame> frame = sequence.Next();
    if (!has_pose || !frame) continue;
    if (frame->depth_m.empty()) {
      frame->depth_m = Image<float>(frame->rgb.width(), frame->rgb.height());
    }
    writer.Write(number++, *frame);
    progress.Advance(1, "frame " + std::to_string(number));
  }
  writer.Finish();
}

void Run(const Options& options, const Invocation& invocation) {
  const auto sequence = OpenSequence(options.from, options.in, ReadingOf(options));
  std::vector<bool> posed;
  const SequenceDescription description = Describe(*sequence, posed);
  const std::size_t frames = description.truth.size();
  if (frames == 0) {
    throw Error(options.in + ": no frame has a true pose, which every layout but this needs");
  }
  if (frames < posed.size()) {
    spdlog::warn("{}: {} frames without a true pose are left out", options.in,
                 posed.size() - frames);
  }
  OutputFolder folder(options.out);
  Copy(*sequence, posed, *MakeSequenceWriter(options.to, folder.path(), description));
  const Json config{{"in", options.in},
                    {"from", options.from},
                    {"to", options.to},
                    {"camera", options.camera},
                    {"take_every", options.every}};
  folder.Commit(MakeManifest(invocation.command_line, config, 0));
  Print(std::to_string(frames) + " frames in " + options.out + "\n");
}

}  // namespace

void AddConvertCommand(CLI::App& program, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("convert", "Turn a sequence into another layout, conventions and all");
  command->add_option("in", options->in, "Folder of the sequence")->required();
  command->add_option("out", options->out, "Folder to make; refused where others' files lie")
      ->required();
  std::vector<std::string> from = ReadableFormats();
  from.insert(from.begin(), "auto");
  command->add_option("--from", options->from, "Its layout: tum, icl, euroc, raw; auto: look")
      ->check(CLI::IsMember(from))
      ->capture_default_str();
  command->add_option("--to", options->to, "tum, icl, euroc, nerfstudio, colmap or raw")
      ->check(CLI::IsMember(SequenceFormats()))
      ->required();
  command
      ->add_option("--camera", options->camera,
                   "fx fy cx cy of a tum folder, instead of its camera.txt; fy < 0 where its "
                   "poses are in ICL-NUIM's mirrored axes")
      ->expected(4);
  RequireInteger(
      command->add_option("--every", options->every, "Every n-th frame")->capture_default_str(), 1,
      1000000);
  command->footer(
      "What differs between the layouts is converted: depth along z or along the ray and its\n"
      "scale, the camera's and the world's axes, which way a pose points, where a pixel's centre\n"
      "is. `silt render --help` describes them. Poses are interpolated to the frames' times.\n"
      "Examples: silt convert office20 office20-colmap --to colmap\n"
      "          silt convert living_room_traj2_frei_png kt2 --camera 481.2 -480 319.5 239.5 --to "
      "tum");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
