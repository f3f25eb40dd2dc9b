// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace silt::experiments {

// Of a list of errors, in their unit. The standard deviation is the population's (÷ n), as in numpy
// and in the field's tools; max and min are signed.
struct Statistics {
  int count = 0;
  double rmse = 0, mean = 0, median = 0, std_dev = 0, min = 0, max = 0;
};

// The values must be finite and at least one.
Statistics Summarize(std::vector<double> values);

// Mean of the two middle values for an even number.
double Median(std::vector<double> values);

}  // namespace silt::experiments
