// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/align_course.h"
#include "silt/cuda/block/align_task.h"
#include "silt/cuda/block/pyramid_bodies.h"

namespace silt::cuda {

// Whole alignments, from the first pose to the last. Each group of blocks takes every groups-th
// start, and goes through rounds: all its blocks work on what the round says (Work, in WorkPhases
// phases), meet, and the first block alone decides what the next round is (Decide, in DecidePhases
// phases; see AlignCourse), while the others wait; a first decision comes before all work. Between
// two phases the threads of a block meet; within one, no thread may read what another one of the
// group writes. A block's Shared stays from round to round.
struct AlignBody {
  struct Shared {
    UnitSums unit;
    // The rest is the first block's.
    TileSums tiles;
    ImageSums image;
    tracker::NormalEquations equations;
    AlignCourse::State state;
  };

  AlignCourse course;
  Round* rounds;    // [groups]
  Scratch scratch;  // of group 0; those of the others follow
  ScratchSize size;
  int references;  // of the task that has most

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
    for (int r = 0; r < course.tasks[round.task].references; ++r) FindHidden(round, r, place);
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
    if (phase + 1 == phases && place.thread == 0) {
      course.Advance(place, shared.equations, &rounds[place.group], shared.state);
    }
  }

 private:
  SILT_HOST_DEVICE static bool Evaluates(const Round& round) {
    return round.step == Round::Step::kEvaluate || round.step == Round::Step::kJudge ||
           round.step == Round::Step::kCompareInitial || round.step == Round::Step::kCompareCoarse;
  }
  SILT_HOST_DEVICE int References(const Round& round) const {
    return round.step == Round::Step::kJudge ? 1 : course.tasks[round.task].references;
  }
  // How many units of an image the block takes, one after the other.
  SILT_HOST_DEVICE int Turns(const Round& round, const GroupPlace& place) const {
    const int units = TilingAt(round).units();
    return units > place.block ? (units - place.block + place.blocks - 1) / place.blocks : 0;
  }
  SILT_HOST_DEVICE const PinholeCamera& CameraAt(const Round& round, int level) const {
    return course.tasks[round.task].reference[0].cameras[level];
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
    const AlignTask& task = course.tasks[round.task];
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
    const TaskReference& reference = course.tasks[round.task].reference[r];
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
    return round.step == Round::Step::kJudge ? course.tasks[round.task].judged_norm
                                             : shared.state.optimizer.norm();
  }
};

}  // namespace silt::cuda
