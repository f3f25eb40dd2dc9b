// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/statistics.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt::experiments {

double Median(std::vector<double> values) {
  SILT_CHECK(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Interval MedianDifference(const std::vector<double>& a, const std::vector<double>& b) {
  SILT_CHECK(!a.empty() && a.size() == b.size());
  constexpr int rounds = 4000, tail = rounds / 40;
  const CounterRandom random(0);
  const std::size_t n = a.size();
  std::vector<double> differences, of_a(n), of_b(n);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto drawn = std::size_t(random.Uniform(round * n + i) * double(n));
      of_a[i] = a[drawn];
      of_b[i] = b[drawn];
    }
    differences.push_back(Median(of_a) - Median(of_b));
  }
  std::sort(differences.begin(), differences.end());
  return {differences[tail], differences[rounds - 1 - tail]};
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
