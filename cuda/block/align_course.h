// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/align_task.h"

namespace silt::cuda {

// What the first thread of a group of blocks decides: from start to start, through the stages that
// come before each, and from round to round as its optimizer wants. It touches no image.
struct AlignCourse {
  using Optimizer = tracker::LevenbergMarquardt;

  struct Outcome {
    Optimizer optimizer;
    tracker::NormalEquations::Spread judged;  // of the intensity; zeros where it was not
    bool starts_coarsely;                     // from `coarse`, where the stages have ended
    SE3d coarse;
  };

  struct State {
    Optimizer optimizer;
    int start;          // the alignment under way
    int stage;          // of its stages, the one under way; as many as there are: past them
    bool in_last;       // the stage that comes last is under way
    bool found_hidden;  // by the keyframe's own depth
    bool starts_coarsely;
    SE3d coarse;
    tracker::PhotometricCost at_initial;
  };

  const AlignTask* tasks;
  const AlignStart* starts;
  int count;          // of starts
  Outcome* outcomes;  // [count]
  Outcome* last;      // [count], of the stages that come last; none need be there without them

  // From the round that is done, whose sums over pixels are `found` if it had any, to the next one.
  SILT_HOST_DEVICE void Advance(const GroupPlace& place, const tracker::NormalEquations& found,
                                Round* round, State& state) const {
    switch (round->step) {
      case Round::Step::kBegin:
        return Begin(place.group, place, round, state);
      case Round::Step::kEmptyCells:
        round->step = Round::Step::kFillCells;
        return;
      case Round::Step::kFillCells:
        round->step = Round::Step::kSpreadCells;
        return;
      case Round::Step::kSpreadCells:
        round->step = Round::Step::kHideBehindCells;
        return;
      case Round::Step::kHideBehindCells:
      case Round::Step::kHalveVisible:
        if (round->level + 1 < state.optimizer.level()) {
          ++round->level;
          round->step = Round::Step::kHalveVisible;
          return;
        }
        return Want(round, state);
      case Round::Step::kEvaluate:
        state.optimizer.Take(tasks[round->task].plan, found);
        if (state.optimizer.wanted() == Optimizer::Wanted::kNothing) {
          return GoOn(place, round, state);
        }
        return state.optimizer.starts_level() ? StartLevel(round, state) : Want(round, state);
      case Round::Step::kCompareInitial:
        state.at_initial = found.cost;
        return Compare(Round::Step::kCompareCoarse, state.coarse, round);
      case Round::Step::kCompareCoarse:
        state.starts_coarsely = tracker::IsMoreAlike(found.cost, state.at_initial);
        if (!StartTask(starts[state.start].task, Initial(state), round, state)) {
          GoOn(place, round, state);
        }
        return;
      case Round::Step::kJudge:
        return Finish(place, found.intensity, round, state);
      case Round::Step::kStop:
        return;
    }
  }

 private:
  // The next alignment of the group, from `start` on, if there is one.
  SILT_HOST_DEVICE void Begin(int start, const GroupPlace& place, Round* round,
                              State& state) const {
    if (!Enter(start, round, state)) GoOn(place, round, state);
  }

  // Whether there is anything to do for it.
  SILT_HOST_DEVICE bool Enter(int start, Round* round, State& state) const {
    state.start = start;
    if (start >= count) {
      round->step = Round::Step::kStop;
      return true;
    }
    const AlignStart& entered = starts[start];
    state.stage = 0;
    state.in_last = false;
    state.starts_coarsely = false;
    state.coarse = entered.initial;
    return StartTask(entered.stages > 0 ? entered.first_stage : entered.task, entered.initial,
                     round, state);
  }

  // Whether it wants anything at all.
  SILT_HOST_DEVICE bool StartTask(int task, const SE3d& initial, Round* round, State& state) const {
    round->task = task;
    state.found_hidden = false;
    state.optimizer = Optimizer(tasks[task].plan, initial);
    if (state.optimizer.wanted() == Optimizer::Wanted::kNothing) return false;
    StartLevel(round, state);
    return true;
  }

  SILT_HOST_DEVICE SE3d Initial(const State& state) const {
    return state.starts_coarsely ? state.coarse : starts[state.start].initial;
  }

  // From what the optimizer has ended to the next thing that is to be done.
  SILT_HOST_DEVICE void GoOn(const GroupPlace& place, Round* round, State& state) const {
    for (bool busy = false; !busy;) {
      const AlignStart& start = starts[state.start];
      const bool ok = state.optimizer.failure() == tracker::AlignmentFailure::kNone;
      if (state.in_last) {
        last[state.start] = {state.optimizer, {}, false, {}};
        busy = Enter(state.start + place.groups, round, state);
      } else if (state.stage < start.stages) {
        busy = EndStage(ok, start, round, state);
      } else if (ok && tasks[round->task].judged_level >= 0) {
        const AlignTask& task = tasks[round->task];
        return LookAt(state.optimizer.accepted_pose(), Round::Step::kJudge, task.judged_level,
                      task.judged_norm, round);
      } else {
        TellOutcome({}, state);
        busy = EndJob(place, round, state);
      }
    }
  }

  // Whether there is anything to do after a job whose outcome is told: its last stage, or the next
  // job of the group.
  SILT_HOST_DEVICE bool EndJob(const GroupPlace& place, Round* round, State& state) const {
    const AlignStart& start = starts[state.start];
    const bool ok = state.optimizer.failure() == tracker::AlignmentFailure::kNone;
    if (start.last_stage < 0 || !ok) return Enter(state.start + place.groups, round, state);
    state.in_last = true;
    return StartTask(start.last_stage, state.optimizer.accepted_pose(), round, state);
  }

  SILT_HOST_DEVICE bool EndStage(bool ok, const AlignStart& start, Round* round,
                                 State& state) const {
    if (!ok) {
      state.stage = start.stages;
      return StartTask(start.task, start.initial, round, state);
    }
    state.coarse = state.optimizer.accepted_pose();
    if (++state.stage < start.stages) {
      return StartTask(start.first_stage + state.stage, state.coarse, round, state);
    }
    round->task = start.first_stage + start.stages;
    Compare(Round::Step::kCompareInitial, start.initial, round);
    return true;
  }

  SILT_HOST_DEVICE void Compare(Round::Step step, const SE3d& pose, Round* round) const {
    LookAt(pose, step, 0, {}, round);
    round->kind = Residuals::kCost;
  }

  // The first reference alone, hidden pixels too.
  SILT_HOST_DEVICE void LookAt(const SE3d& pose, Round::Step step, int level,
                               const tracker::ResidualNorm& norm, Round* round) const {
    round->step = step;
    round->level = level;
    round->hide = round->visible = false;
    SetResiduals(ResidualsOf(norm), norm, round);
    SetWarp(pose, 0, round);
  }

  SILT_HOST_DEVICE void StartLevel(Round* round, State& state) const {
    const AlignTask& task = tasks[round->task];
    round->visible = task.exclude_hidden;
    if (!task.exclude_hidden || task.depth_m[0] != nullptr) {
      Want(round, state);
      round->hide = task.exclude_hidden;
      return;
    }
    // The keyframe's own depth tells at the first level, and again where the pose is all but known.
    if (state.found_hidden && state.optimizer.level() > 1) return Want(round, state);
    state.found_hidden = true;
    round->step = Round::Step::kEmptyCells;
    round->level = 0;
    SetWarps(state.optimizer.pose(), round);
  }

  // What the optimizer wants.
  SILT_HOST_DEVICE void Want(Round* round, State& state) const {
    const Optimizer& optimizer = state.optimizer;
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
                                    const State& state) const {
    outcomes[state.start] = {state.optimizer, judged, state.starts_coarsely, state.coarse};
  }

  SILT_HOST_DEVICE void Finish(const GroupPlace& place,
                               const tracker::NormalEquations::Spread& judged, Round* round,
                               State& state) const {
    TellOutcome(judged, state);
    if (!EndJob(place, round, state)) GoOn(place, round, state);
  }
};

}  // namespace silt::cuda
