// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/normal_equations.h"

namespace silt::tracker {

// One solve of Algorithm 1.
struct AlignmentStep {
  int level = 0;               // as in the paper: 1 is the finest
  int iteration = 0;           // from 1 at each level
  double damping = 0;          // α of the solve
  double update_norm = 0;      // |dξ|
  PhotometricCost cost;        // at the pose before the step
  PhotometricCost trial_cost;  // at the pose that the step proposes
  bool accepted = false;
};

// One level's share, in the order of the run: coarsest first.
struct AlignmentLevel {
  int level = 0;  // as in the paper: 1 is the finest
  int width = 0, height = 0;
  PhotometricCost initial_cost, final_cost;
  int iterations = 0;
  bool converged = false;  // |dξ| < ε came before the last iteration
};

}  // namespace silt::tracker
