// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/cuda/block/align_body.h"
#include "silt/cuda/block/block_pyramids.h"
#include "silt/tracker/backend.h"

namespace silt::cuda {

// Runs alignments on a machine without coming back for each of their steps; see AlignBody. The
// result of each is that of BlockBackend's reductions, bit by bit, however many run at once.
template <typename Machine>
class BlockAlignments {
 public:
  explicit BlockAlignments(const Machine& machine) : machine_(machine) {}

  static bool CanRun(const tracker::AlignmentJob& job) {
    bool logs = job.plan.keep_log;
    for (const tracker::AlignmentStage& stage : job.first) logs = logs || stage.plan.keep_log;
    if (job.last) logs = logs || job.last->plan.keep_log;
    return !logs;
  }

  std::vector<tracker::FinishedAlignment> Run(const tracker::AlignmentJobs& jobs) const {
    std::vector<AlignTask> tasks;
    std::vector<AlignStart> starts;
    std::map<std::pair<const void*, const void*>, int> of_pair;
    for (const tracker::AlignmentJob& job : jobs) {
      int task = int(tasks.size());
      if (job.references.size() == 1 && job.first.empty() && !job.last) {
        task = of_pair.emplace(std::pair(&job.references[0].pyramid, &job.current), task)
                   .first->second;
      }
      if (task == int(tasks.size())) tasks.push_back(TaskOf(job));
      SILT_CHECK(tasks[std::size_t(task)].plan == job.plan);  // one for all jobs of a pair
      starts.push_back({task, job.initial, int(tasks.size()), int(job.first.size())});
      AddStages(job, &tasks);
      if (!job.last) continue;
      starts.back().last_stage = int(tasks.size());
      tasks.push_back(TaskOf(*job.last));
    }
    return Run(std::move(tasks), starts);
  }

 private:
  using Reference = BlockReference<Machine>;
  using Current = BlockCurrent<Machine>;
  template <typename T>
  using Array = typename Machine::template Array<T>;

  // Of all groups together: more would not run faster than those that this much serves.
  static constexpr std::size_t kScratchBytes = std::size_t(4) << 30;

  static void AddStages(const tracker::AlignmentJob& job, std::vector<AlignTask>* tasks) {
    if (job.first.empty()) return;
    for (const tracker::AlignmentStage& stage : job.first) tasks->push_back(TaskOf(stage));
    SILT_CHECK(job.compared.has_value());
    tracker::AlignmentStage compared{{}, *job.compared};
    compared.plan.levels = 1;
    tasks->push_back(TaskOf(compared));
  }

  static AlignTask TaskOf(const tracker::AlignmentJob& job) {
    AlignTask task = TaskOf(job.plan, job.references, job.current, job.exclude_hidden);
    task.judged_level = job.judged_level;
    task.judged_norm = job.judged_norm;
    return task;
  }

  static AlignTask TaskOf(const tracker::AlignmentStage& stage) {
    return TaskOf(stage.plan, {{stage.images.reference, {}}}, stage.images.current,
                  stage.exclude_hidden);
  }

  static AlignTask TaskOf(const tracker::AlignmentPlan& plan,
                          const tracker::ReferenceViews& references,
                          const tracker::CurrentPyramid& image, bool exclude_hidden) {
    const auto& current = dynamic_cast<const Current&>(image);
    AlignTask task{};
    task.plan = plan;
    task.exclude_hidden = exclude_hidden;
    SILT_CHECK(int(references.size()) <= kMaxReferences);
    task.references = int(references.size());
    SILT_CHECK(int(current.intensity.size()) >= plan.levels);
    SILT_CHECK(!plan.use_depth || !current.inverse_depth.empty());
    for (std::size_t l = 0; l < current.intensity.size(); ++l) {
      task.intensity[l] = current.intensity[l].data();
      task.depth_m[l] = current.has_depth() ? current.depth_m[l].data() : nullptr;
      task.inverse_depth[l] =
          current.inverse_depth.empty() ? nullptr : current.inverse_depth[l].data();
    }
    for (int r = 0; r < task.references; ++r) {
      task.reference[r] = ReferenceOf(references[r], current);
    }
    return task;
  }

  static TaskReference ReferenceOf(const tracker::ReferenceView& view, const Current& current) {
    const auto& pyramid = dynamic_cast<const Reference&>(view.pyramid);
    SILT_CHECK(pyramid.depth_m.size() <= current.intensity.size());
    TaskReference reference{};
    reference.anchor_from_reference = view.anchor_from_reference;
    for (std::size_t l = 0; l < pyramid.depth_m.size(); ++l) {
      SILT_CHECK(current.intensity[l].width == pyramid.depth_m[l].width &&
                 current.intensity[l].height == pyramid.depth_m[l].height);
      reference.intensity[l] = pyramid.intensity[l].data();
      reference.depth_m[l] = pyramid.depth_m[l].data();
      reference.cameras[l] = pyramid.camera(int(l));
    }
    return reference;
  }

  static ScratchSize SizeOf(const std::vector<AlignTask>& tasks) {
    ScratchSize size;
    for (const AlignTask& task : tasks) {
      std::size_t pixels = 0;
      for (int l = 0; l < task.plan.levels; ++l) {
        const PinholeCamera& camera = task.reference[0].cameras[l];
        const Tiling tiling = TilingOf(camera.width, camera.height);
        pixels += std::size_t(camera.width) * std::size_t(camera.height);
        size.units = std::max(size.units, std::size_t(tiling.units()));
        size.tiles = std::max(size.tiles, std::size_t(tiling.tiles));
      }
      if (!task.exclude_hidden) continue;
      size.visible = std::max(size.visible, pixels);
      if (task.depth_m[0] != nullptr) continue;
      const PinholeCamera& camera = task.reference[0].cameras[0];
      const kernel::CellGrid cells = kernel::CellsOf(camera.width, camera.height);
      size.cells = std::max(size.cells, std::size_t(cells.columns) * std::size_t(cells.rows));
    }
    return size;
  }

  // How a batch is dealt out.
  struct Shares {
    ScratchSize size;
    int references = 1;  // of the task that has most
    int resident = 1;    // blocks
    int groups = 1;      // at most

    // Where so many groups work. No image has more work for a group than its units.
    int BlocksOf(int of_groups) const {
      return std::clamp(int(references * size.units), 1, resident / of_groups);
    }
  };

  Shares SharesOf(const std::vector<AlignTask>& tasks, std::size_t starts) const {
    Shares shares{SizeOf(tasks)};
    for (const AlignTask& task : tasks) {
      shares.references = std::max(shares.references, task.references);
    }
    const ScratchSize& size = shares.size;
    const std::size_t of_group =
        shares.references * ((size.visible + 2 * size.cells) * sizeof(float) +
                             size.units * kSums * sizeof(double)) +
        size.tiles * kSums * sizeof(double);
    shares.resident = machine_.template ResidentBlocks<AlignBody>();
    if (shares.resident < 1) {
      throw Error(
          "CUDA: the device cannot run a single block of an alignment (its registers or shared "
          "memory do not suffice); use --backend cpu");
    }
    // Images too small for any residual need no memory at all.
    const std::size_t fit = kScratchBytes / std::max<std::size_t>(of_group, 1);
    shares.groups =
        int(std::clamp<std::size_t>(fit, 1, std::min(starts, std::size_t(shares.resident))));
    return shares;
  }

  // Several launches, one after the other, with what each of them needs: memory does not grow with
  // the number of starts.
  std::vector<tracker::FinishedAlignment> Run(std::vector<AlignTask> tasks,
                                              const std::vector<AlignStart>& starts) const {
    const Shares shares = SharesOf(tasks, starts.size());
    // Where many blocks work on one alignment, they wait for each other longer than they compute.
    for (AlignTask& task : tasks) task.plan.linearize_trials = shares.BlocksOf(shares.groups) > 1;
    Array<AlignTask> task_array(machine_, tasks.size());
    machine_.Upload(tasks.data(), task_array);
    const std::size_t of_launch = std::size_t(shares.groups) * Machine::kStartsOfGroup;
    std::vector<tracker::FinishedAlignment> finished;
    finished.reserve(starts.size());
    double batch_ms = 0;
    for (std::size_t first = 0; first < starts.size(); first += of_launch) {
      const int count = int(std::min(of_launch, starts.size() - first));
      const std::vector<AlignCourse::Outcome> outcomes =
          Launch(shares, task_array, &starts[first], count, &batch_ms);
      for (int i = 0; i < count; ++i) {
        const AlignCourse::Outcome& outcome = outcomes[std::size_t(i)];
        finished.push_back({outcome.optimizer, outcome.judged, {}, {}, 0});
        if (outcome.starts_coarsely) finished.back().coarse = outcome.coarse;
        const bool ok = outcome.optimizer.failure() == tracker::AlignmentFailure::kNone;
        if (ok && starts[first + std::size_t(i)].last_stage >= 0) {
          finished.back().last = outcomes[std::size_t(count + i)].optimizer;
        }
      }
    }
    for (tracker::FinishedAlignment& each : finished) each.batch_ms = batch_ms;
    return finished;
  }

  // Of all jobs, and behind them, if any of them has a last stage, of those.
  std::vector<AlignCourse::Outcome> Launch(const Shares& shares, const Array<AlignTask>& tasks,
                                           const AlignStart* starts, int count,
                                           double* batch_ms) const {
    const ScratchSize& size = shares.size;
    const int groups = std::min(shares.groups, count);
    const std::size_t n = std::size_t(groups), of_all = n * std::size_t(shares.references);
    Array<AlignStart> start_array(machine_, std::size_t(count));
    Array<Round> rounds(machine_, n);
    const bool any_last = std::any_of(
        starts, starts + count, [](const AlignStart& start) { return start.last_stage >= 0; });
    Array<AlignCourse::Outcome> outcomes(machine_, std::size_t(any_last ? 2 * count : count));
    Array<float> visible(machine_, of_all * size.visible);
    Array<float> nearest(machine_, of_all * size.cells);
    Array<float> spread(machine_, of_all * size.cells);
    Array<double> unit_sums(machine_, of_all * size.units * kSums);
    Array<double> tile_sums(machine_, n * size.tiles * kSums);
    machine_.Upload(starts, start_array);
    machine_.Upload(std::vector<Round>(n).data(), rounds);
    const Scratch scratch{visible.data(), nearest.data(), spread.data(), unit_sums.data(),
                          tile_sums.data()};
    typename Machine::Timer timer;
    machine_.RunGroups(groups, shares.BlocksOf(groups),
                       AlignBody{{tasks.data(), start_array.data(), count, outcomes.data(),
                                  outcomes.data() + count},
                                 rounds.data(),
                                 scratch,
                                 size,
                                 shares.references},
                       &timer);
    std::vector<AlignCourse::Outcome> result = machine_.Download(outcomes);
    *batch_ms += timer.Milliseconds();  // now that it has been waited for
    return result;
  }

  const Machine& machine_;
};

}  // namespace silt::cuda
