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

struct Interval {
  double low = 0, high = 0;
};

// Where the difference of the medians, a's less b's, lies with a confidence of 95 %: the
// percentiles of a bootstrap over the cases, of which a[i] and b[i] are one (Efron 1979). Where 0
// lies within, the cases do not tell which of both is less. The draws are the same in every run.
Interval MedianDifference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace silt::experiments
