// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/align_task.h"
#include "silt/cuda/block/pyramid_bodies.h"

namespace silt::cuda {

// Whole alignments, from the first pose to the last. Each group of blocks takes every groups-th
// start, and goes through rounds: all its blocks work on what the round says (Work, in WorkPhases
// phases), meet, and the first block alone decides what the next round is (Decide, in DecidePhases
// phases), while the others wait; a first decision comes before all work. Between two phases the
// threads of a block meet; within one, no thread may read what another one of the group writes. A
// block's Shared stays from round to round.
struct AlignBody {
  using Optimizer = tracker::LevenbergMarquardt;

  struct Outcome {
    Optimizer optimizer;
    tracker::NormalEquations::Spread judged;  // of the intensity; zeros where it was not
    bool starts_coarsely;                     // from `coarse`, where the stages have ended
    SE3d coarse;
  };

  struct Shared {
    UnitSums unit;
    // The rest is the first block's.
    TileSums tiles;
    ImageSums image;
    tracker::NormalEquations equations;
    Optimizer optimizer;
    int start;          // the alignment under way
    int stage;          // of its stages, the one under way; as many as there are: past them
    bool found_hidden;  // by the keyframe's own depth
    bool starts_coarsely;
    SE3d coarse;
    tracker::PhotometricCost at_initial;
  };

  const AlignTask* tasks;
  const AlignStart* starts;
  int count;        // of starts
  Round* rounds;    // [groups]
  Scratch scratch;  // of group 0; those of the others follow
  ScratchSize size;
  int references;     // of the task that has most
  Outcome* outcomes;  // [count]

  SILT_HOST_DEVICE bool Finished(const GroupPlace& place) const {
    return rounds[place.group].step == Round::Step::kStop;
  }

  SILT_HOST_DEVICE int WorkPhases(const GroupPlace& place) const {
    const Round& round = rounds[place.group];
    return Evaluates(round) ? UnitSums::kPhases * References(round) * Turns(round, place) : 1;
  }

  SILT_HOST_DEVICE void Work(int phase, const GroupPlace& place, Shared& shared) const {
    const Round& round = rounds[place.group];
    if (Evaluates(round)) {
      const int turns = Turns(round, place), turn = phase / UnitSums::kPhases;
      const int unit = place.block + turn % turns * place.blocks;
      return Evaluate(phase % UnitSums::kPhases, round, turn / turns, unit, place, shared.unit);
    }
    for (int r = 0; r < tasks[round.task].references; ++r) FindHidden(round, r, place);
  }

  SILT_HOST_DEVICE int DecidePhases(const GroupPlace& place) const {
    const Round& round = rounds[place.group];
    return Evaluates(round) ? (TileSums::kPhases + 1) * References(round) : 1;
  }

  SILT_HOST_DEVICE void Decide(int phase, int phases, const GroupPlace& place,
                               Shared& shared) const {
    if (phases > 1) {
      // After an evaluation: add up what its units have found, reference by reference.
      const int r = phase / (TileSums::kPhases + 1), step = phase % (TileSums::kPhases + 1);
      if (step < TileSums::kPhases) return AddUnits(step, r, place, shared);
      if (place.thread == 0) AddReference(r, place, shared);
    }
    if (phase + 1 == phases && place.thread == 0) Advance(place, shared);
  }

 private:
  SILT_HOST_DEVICE static bool Evaluates(const Round& round) {
    return round.step == Round::Step::kEvaluate || round.step == Round::Step::kJudge ||
           round.step == Round::Step::kCompareInitial || round.step == Round::Step::kCompareCoarse;
  }
  SILT_HOST_DEVICE int References(const Round& round) const {
    return round.step == Round::Step::kJudge ? 1 : tasks[round.task].references;
  }
  // How many units of an image the block takes, one after the other.
  SILT_HOST_DEVICE int Turns(const Round& round, const GroupPlace& place) const {
    const int units = TilingAt(round).units();
    return units > place.block ? (units - place.block + place.blocks - 1) / place.blocks : 0;
  }
  SILT_HOST_DEVICE const PinholeCamera& CameraAt(const Round& round, int level) const {
    return tasks[round.task].reference[0].cameras[level];
  }
  SILT_HOST_DEVICE Tiling TilingAt(const Round& round) const {
    const PinholeCamera& camera = CameraAt(round, round.level);
    return TilingOf(camera.width, camera.height);
  }

  SILT_HOST_DEVICE double* UnitSumsOf(const GroupPlace& place, int r) const {
    return scratch.unit_sums + (std::size_t(place.group) * references + r) * size.units * kSums;
  }
  SILT_HOST_DEVICE double* TileSumsOf(const GroupPlace& place) const {
    return scratch.tile_sums + std::size_t(place.group) * size.tiles * kSums;
  }
  SILT_HOST_DEVICE float* VisibleOf(const Round& round, const GroupPlace& place, int r,
                                    int level) const {
    float* visible_m =
        scratch.visible_m + (std::size_t(place.group) * references + r) * size.visible;
    for (int finer = 0; finer < level; ++finer) {
      const PinholeCamera& camera = CameraAt(round, finer);
      visible_m += std::size_t(camera.width) * std::size_t(camera.height);
    }
    return visible_m;
  }

  SILT_HOST_DEVICE void Evaluate(int phase, const Round& round, int r, int unit,
                                 const GroupPlace& place, UnitSums& sums) const {
    if (phase == 0) return Linearize(round, r, unit, place, sums.part[place.thread]);
    sums.Reduce(phase, place.thread, UnitSumsOf(place, r) + unit * kSums);
  }

  // A thread reads of the visible depths only those that it wrote itself at this level, or that
  // were there before the round.
  SILT_HOST_DEVICE void Linearize(const Round& round, int r, int unit, const GroupPlace& place,
                                  float* part) const {
    const AlignTask& task = tasks[round.task];
    const TaskReference& reference = task.reference[r];
    const int level = round.level;
    const Tiling tiling = TilingAt(round);
    const float* depth_m = reference.depth_m[level];
    if (round.visible) {
      float* visible_m = VisibleOf(round, place, r, level);
      if (round.hide) {
        const HideBehindCurrent hide{round.warp[r], depth_m,       task.depth_m[level],
                                     tiling.width,  tiling.height, visible_m};
        for (int i = tiling.begin(unit) + place.thread; i < tiling.end(unit); i += kThreads)
          hide(i);
      }
      depth_m = visible_m;
    }
    const PixelPass pass{round.warp[r],
                         reference.intensity[level],
                         depth_m,
                         {task.intensity[level], tiling.width, tiling.height},
                         {task.inverse_depth[level], tiling.width, tiling.height},
                         round.intensity_norm,
                         round.inverse_depth_norm};
    pass.AddPixels(round.kind, tiling, unit, place.thread, part);
  }

  template <typename Function>
  SILT_HOST_DEVICE static void Each(const GroupPlace& place, int n, const Function& function) {
    for (int i = place.block * kThreads + place.thread; i < n; i += place.blocks * kThreads) {
      function(i);
    }
  }

  // The steps of BlockBackend::HiddenByItself, one a round.
  SILT_HOST_DEVICE void FindHidden(const Round& round, int r, const GroupPlace& place) const {
    const TaskReference& reference = tasks[round.task].reference[r];
    const int width = reference.cameras[0].width, height = reference.cameras[0].height;
    const kernel::CellGrid grid = kernel::CellsOf(width, height);
    const int cells = grid.columns * grid.rows;
    const std::size_t first_cell = (std::size_t(place.group) * references + r) * size.cells;
    float *nearest_m = scratch.nearest_m + first_cell, *spread_m = scratch.spread_m + first_cell;
    const float* depth_m = reference.depth_m[0];
    switch (round.step) {
      case Round::Step::kEmptyCells:
        return Each(place, cells, EmptyCells{nearest_m});
      case Round::Step::kFillCells:
        return Each(place, width * height,
                    FillCells{round.warp[r], depth_m, width, height, nearest_m});
      case Round::Step::kSpreadCells:
        return Each(place, cells, SpreadCells{nearest_m, grid, spread_m});
      case Round::Step::kHideBehindCells:
        return Each(place, width * height,
                    HideBehindCells{round.warp[r], depth_m, spread_m, width, height,
                                    VisibleOf(round, place, r, 0)});
      case Round::Step::kHalveVisible:
        return HalveVisible(round, r, place);
      default:
        return;
    }
  }

  SILT_HOST_DEVICE void HalveVisible(const Round& round, int r, const GroupPlace& place) const {
    const PinholeCamera &fine = CameraAt(round, round.level - 1),
                        &half = CameraAt(round, round.level);
    Each(place, half.width * half.height,
         HalveDepth{VisibleOf(round, place, r, round.level - 1), fine.width,
                    VisibleOf(round, place, r, round.level), half.width});
  }

  SILT_HOST_DEVICE void AddUnits(int step, int r, const GroupPlace& place, Shared& shared) const {
    const Round& round = rounds[place.group];
    shared.tiles.Reduce(step, place.thread, TilingAt(round), UnitSumsOf(place, r),
                        TileSumsOf(place), &shared.image);
  }

  SILT_HOST_DEVICE void AddReference(int r, const GroupPlace& place, Shared& shared) const {
    const Round& round = rounds[place.group];
    if (r == 0) shared.equations = {};
    if (round.kind == Residuals::kCost) {
      shared.equations.cost += tracker::CostOf(shared.image.sums);
    } else {
      shared.equations += EquationsOf(shared.image, NormOf(round, shared));
    }
  }
  SILT_HOST_DEVICE const tracker::ResidualNorm& NormOf(const Round& round,
                                                       const Shared& shared) const {
    return round.step == Round::Step::kJudge ? tasks[round.task].judged_norm
                                             : shared.optimizer.norm();
  }

  // The first thread of the group from here on.
  SILT_HOST_DEVICE void Advance(const GroupPlace& place, Shared& shared) const {
    Round& round = rounds[place.group];
    switch (round.step) {
      case Round::Step::kBegin:
        return Begin(place.group, place, &round, shared);
      case Round::Step::kEmptyCells:
        round.step = Round::Step::kFillCells;
        return;
      case Round::Step::kFillCells:
        round.step = Round::Step::kSpreadCells;
        return;
      case Round::Step::kSpreadCells:
        round.step = Round::Step::kHideBehindCells;
        return;
      case Round::Step::kHideBehindCells:
      case Round::Step::kHalveVisible:
        if (round.level + 1 < shared.optimizer.level()) {
          ++round.level;
          round.step = Round::Step::kHalveVisible;
          return;
        }
        return Want(&round, shared);
      case Round::Step::kEvaluate:
        shared.optimizer.Take(tasks[round.task].plan, shared.equations);
        if (shared.optimizer.wanted() == Optimizer::Wanted::kNothing) {
          return GoOn(place, &round, shared);
        }
        return shared.optimizer.starts_level() ? StartLevel(&round, shared) : Want(&round, shared);
      case Round::Step::kCompareInitial:
        shared.at_initial = shared.equations.cost;
        return Compare(Round::Step::kCompareCoarse, shared.coarse, &round);
      case Round::Step::kCompareCoarse:
        shared.starts_coarsely = tracker::IsMoreAlike(shared.equations.cost, shared.at_initial);
        if (!StartTask(starts[shared.start].task, Initial(shared), &round, shared)) {
          GoOn(place, &round, shared);
        }
        return;
      case Round::Step::kJudge:
        return Finish(place, shared.equations.intensity, &round, shared);
      case Round::Step::kStop:
        return;
    }
  }

  // The next alignment of the group, from `start` on, if there is one.
  SILT_HOST_DEVICE void Begin(int start, const GroupPlace& place, Round* round,
                              Shared& shared) const {
    if (!Enter(start, round, shared)) GoOn(place, round, shared);
  }

  // Whether there is anything to do for it.
  SILT_HOST_DEVICE bool Enter(int start, Round* round, Shared& shared) const {
    shared.start = start;
    if (start >= count) {
      round->step = Round::Step::kStop;
      return true;
    }
    const AlignStart& entered = starts[start];
    shared.stage = 0;
    shared.starts_coarsely = false;
    shared.coarse = entered.initial;
    return StartTask(entered.stages > 0 ? entered.first_stage : entered.task, entered.initial,
                     round, shared);
  }

  // Whether it wants anything at all.
  SILT_HOST_DEVICE bool StartTask(int task, const SE3d& initial, Round* round,
                                  Shared& shared) const {
    round->task = task;
    shared.found_hidden = false;
    shared.optimizer = Optimizer(tasks[task].plan, initial);
    if (shared.optimizer.wanted() == Optimizer::Wanted::kNothing) return false;
    StartLevel(round, shared);
    return true;
  }

  SILT_HOST_DEVICE SE3d Initial(const Shared& shared) const {
    return shared.starts_coarsely ? shared.coarse : starts[shared.start].initial;
  }

  // From what the optimizer has ended to the next thing that is to be done.
  SILT_HOST_DEVICE void GoOn(const GroupPlace& place, Round* round, Shared& shared) const {
    for (bool busy = false; !busy;) {
      const AlignStart& start = starts[shared.start];
      const bool ok = shared.optimizer.failure() == tracker::AlignmentFailure::kNone;
      if (shared.stage < start.stages) {
        busy = EndStage(ok, start, round, shared);
      } else if (ok && tasks[round->task].judged_level >= 0) {
        return StartJudging(round, shared);
      } else {
        TellOutcome({}, shared);
        busy = Enter(shared.start + place.groups, round, shared);
      }
    }
  }

  SILT_HOST_DEVICE bool EndStage(bool ok, const AlignStart& start, Round* round,
                                 Shared& shared) const {
    if (!ok) {
      shared.stage = start.stages;
      return StartTask(start.task, start.initial, round, shared);
    }
    shared.coarse = shared.optimizer.accepted_pose();
    if (++shared.stage < start.stages) {
      return StartTask(start.first_stage + shared.stage, shared.coarse, round, shared);
    }
    round->task = start.first_stage + start.stages;
    Compare(Round::Step::kCompareInitial, start.initial, round);
    return true;
  }

  SILT_HOST_DEVICE void Compare(Round::Step step, const SE3d& pose, Round* round) const {
    round->step = step;
    round->level = 0;
    round->hide = round->visible = false;
    SetResiduals(Residuals::kCost, {}, round);
    SetWarp(pose, 0, round);
  }

  SILT_HOST_DEVICE void StartJudging(Round* round, Shared& shared) const {
    const AlignTask& task = tasks[round->task];
    round->step = Round::Step::kJudge;
    round->level = task.judged_level;
    round->hide = round->visible = false;
    SetResiduals(ResidualsOf(task.judged_norm), task.judged_norm, round);
    SetWarp(shared.optimizer.accepted_pose(), 0, round);
  }

  SILT_HOST_DEVICE void StartLevel(Round* round, Shared& shared) const {
    const AlignTask& task = tasks[round->task];
    round->visible = task.exclude_hidden;
    if (!task.exclude_hidden || task.depth_m[0] != nullptr) {
      Want(round, shared);
      round->hide = task.exclude_hidden;
      return;
    }
    // The keyframe's own depth tells at the first level, and again where the pose is all but known.
    if (shared.found_hidden && shared.optimizer.level() > 1) return Want(round, shared);
    shared.found_hidden = true;
    round->step = Round::Step::kEmptyCells;
    round->level = 0;
    SetWarps(shared.optimizer.pose(), round);
  }

  // What the optimizer wants.
  SILT_HOST_DEVICE void Want(Round* round, Shared& shared) const {
    const Optimizer& optimizer = shared.optimizer;
    round->step = Round::Step::kEvaluate;
    round->level = optimizer.level() - 1;
    round->hide = false;
    SetResiduals(optimizer.wanted() == Optimizer::Wanted::kCost ? Residuals::kCost
                                                                : ResidualsOf(optimizer.norm()),
                 optimizer.norm(), round);
    SetWarps(optimizer.pose(), round);
  }

  SILT_HOST_DEVICE void SetResiduals(Residuals kind, const tracker::ResidualNorm& norm,
                                     Round* round) const {
    round->kind = kind;
    round->intensity_norm = tracker::FloatNorm<kernel::RobustNorm<float>>(norm.intensity);
    round->inverse_depth_norm = tracker::FloatNorm<kernel::RobustNorm<float>>(norm.inverse_depth);
  }
  SILT_HOST_DEVICE void SetWarps(const SE3d& current_from_anchor, Round* round) const {
    const AlignTask& task = tasks[round->task];
    for (int r = 0; r < task.references; ++r) {
      SetWarp(current_from_anchor * task.reference[r].anchor_from_reference, r, round);
    }
  }
  SILT_HOST_DEVICE void SetWarp(const SE3d& current_from_reference, int r, Round* round) const {
    const PinholeCamera& camera = tasks[round->task].reference[r].cameras[round->level];
    round->warp[r] = kernel::Warp<float>(kernel::Warp<double>(current_from_reference, camera));
  }

  SILT_HOST_DEVICE void TellOutcome(const tracker::NormalEquations::Spread& judged,
                                    const Shared& shared) const {
    outcomes[shared.start] = {shared.optimizer, judged, shared.starts_coarsely, shared.coarse};
  }

  SILT_HOST_DEVICE void Finish(const GroupPlace& place,
                               const tracker::NormalEquations::Spread& judged, Round* round,
                               Shared& shared) const {
    TellOutcome(judged, shared);
    Begin(shared.start + place.groups, place, round, shared);
  }
};

}  // namespace silt::cuda
