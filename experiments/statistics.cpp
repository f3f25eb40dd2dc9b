// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/statistics.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"

namespace silt::experiments {

double Median(std::vector<double> values) {
  SILT_CHECK(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Statistics Summarize(std::vector<double> values) {
  SILT_CHECK(!values.empty());
  const double n = double(values.size());
  Statistics s;
  s.count = int(values.size());
  double sum = 0, squares = 0, deviations = 0;
  for (const double v : values) sum += v, squares += v * v;
  s.mean = sum / n;
  s.rmse = std::sqrt(squares / n);
  // Two passes: mean² − (mean of squares) would cancel for a small spread about a large mean.
  for (const double v : values) deviations += (v - s.mean) * (v - s.mean);
  s.std_dev = std::sqrt(deviations / n);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  s.min = *low;
  s.max = *high;
  s.median = Median(std::move(values));
  return s;
}

}  // namespace silt::experiments
