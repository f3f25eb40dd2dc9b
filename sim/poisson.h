// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/random.h"

namespace silt::sim {

// A number of the Poisson distribution with the given mean, exact, as a function of (random, index)
// alone; 0 for means that are not above 0. Uses the sub-indices 64·index to 64·index + 63.
double Poisson(const CounterRandom& random, std::uint64_t index, double mean);

}  // namespace silt::sim
