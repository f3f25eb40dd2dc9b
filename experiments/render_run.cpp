// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/render_run.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "silt/experiments/folder_ownership.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/output.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/render_folder.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

double EndOf(const World& world, const Stretch& stretch) {
  const double end_s = stretch.start_s + stretch.duration_s;
  return stretch.duration_s > 0 ? std::min(end_s, world.path.duration_s())
                                : world.path.duration_s();
}

// The frames and all that is written beside them.
class SequenceRender {
 public:
  SequenceRender(const World& world, const RenderRequest& request)
      : world_(world),
        request_(request),
        renderer_(world.scene, request.plan.options),
        folder_(NormalPlace(request.out)),
        description_(Describe()),
        writer_(MakeSequenceWriter(request.format, folder_, description_)),
        truth_(folder_, request.truth, world, renderer_, description_.truth) {}

  int frames() const { return int(description_.truth.size()); }

  std::vector<fs::path> FrameFiles(int number) const {
    std::vector<fs::path> files = writer_->FrameFiles(number);
    for (fs::path& file : truth_.FrameFiles(number)) files.push_back(std::move(file));
    return files;
  }

  RenderFiles Files() const {
    RenderFiles all;
    for (int number = 0; number < frames(); ++number) {
      for (fs::path& file : FrameFiles(number)) all.of_frames.push_back(std::move(file));
    }
    all.of_sequence = writer_->SequenceFiles();
    for (fs::path& file : truth_.SequenceFiles()) all.of_sequence.push_back(std::move(file));
    return all;
  }

  std::vector<int> Missing() const {
    std::vector<int> missing;
    for (int number = 0; number < frames(); ++number) {
      const std::vector<fs::path> files = FrameFiles(number);
      const bool whole = std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
        return fs::is_regular_file(folder_ / file);
      });
      if (!whole) missing.push_back(number);
    }
    return missing;
  }

  void Render(int number) {
    const double time_s = description_.truth[std::size_t(number)].time_s;
    // Of the whole path, so that a stretch has the noise that it has within the whole.
    const int index = int(std::llround(time_s * request_.plan.stretch.fps));
    writer_->Write(number, renderer_.Render(world_.Pose(), time_s, index));
    truth_.Write(number, index);
  }

  void Finish() {
    writer_->Finish();
    truth_.Finish(description_.imu, EndOf(world_, request_.plan.stretch));
  }

 private:
  SequenceDescription Describe() const {
    const RenderPlan& plan = request_.plan;
    SequenceDescription description{plan.options.camera, TruePoses(world_, plan.stretch), {}};
    description.lens = plan.options.lens;
    const double start_s = description.truth.front().time_s;
    if (request_.truth.imu || request_.format == "euroc") {
      description.imu =
          sim::RecordImu(world_.path, request_.imu, start_s, EndOf(world_, plan.stretch) - start_s);
    }
    return description;
  }

  const World& world_;
  const RenderRequest& request_;
  sim::Renderer renderer_;
  fs::path folder_;
  SequenceDescription description_;
  std::unique_ptr<SequenceWriter> writer_;
  TruthWriter truth_;
};

void RenderMissing(SequenceRender& render, const std::vector<int>& missing) {
  Progress progress(double(missing.size()));
  const std::string of = " of " + std::to_string(render.frames());
  for (std::size_t i = 0; i < missing.size(); ++i) {
    try {
      ThrowIfInterrupted();
    } catch (const Interrupted&) {
      const std::size_t done = std::size_t(render.frames()) - missing.size() + i;
      throw Interrupted{std::to_string(done) + of + " frames are there; the same command goes on"};
    }
    render.Render(missing[i]);
    progress.Advance(1, "frame " + std::to_string(missing[i] + 1) + of);
  }
}

}  // namespace

Json RenderRequest::ToJson(const World& world) const {
  Json json{{"world", world.ToJson()}, {"render", plan.ToJson()}, {"format", format}};
  json["truth"] = truth.ToJson();
  json["imu"] = {{"rate_hz", imu.rate_hz},
                 {"gyro_density", imu.noise.gyro_density},
                 {"gyro_walk", imu.noise.gyro_walk},
                 {"accelerometer_density", imu.noise.accelerometer_density},
                 {"accelerometer_walk", imu.noise.accelerometer_walk},
                 {"seed", imu.seed}};
  return json;
}

void RunRender(const World& world, const RenderRequest& request, const std::string& command_line) {
  SequenceRender render(world, request);
  const Json manifest =
      MakeManifest(command_line, request.ToJson(world), request.plan.options.seed);
  RenderFolder folder(request.out, manifest, render.Files(), request.overwrite);
  const std::string frames = std::to_string(render.frames()) + " frames";
  if (folder.IsWhole()) {
    Print(frames + " are in " + request.out + " already\n");
    return;
  }
  folder.Begin();
  const std::vector<int> missing = render.Missing();
  RenderMissing(render, missing);
  render.Finish();
  folder.Commit();
  const bool resumed = int(missing.size()) < render.frames();
  Print(frames + " in " + request.out +
        (resumed ? ", " + std::to_string(missing.size()) + " of them new\n" : "\n"));
}

}  // namespace silt::experiments
