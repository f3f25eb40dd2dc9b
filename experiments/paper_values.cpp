// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/paper_values.h"

namespace silt::experiments {
namespace {

struct PaperSequenceValues {
  const char* sequence;
  PaperColumn position;
  PaperColumn orientation[3];
};

constexpr PaperSequenceValues kValues[] = {
    {"20fps",
     {"0.74", "4.2", "", "0.44", "0.25", "0.59"},
     {{"0.24", "0.74", "-0.64", "-0.11", "-0.13", "0.21"},
      {"0.21", "1.52", "-0.44", "-0.02", "-0.04", "0.21"},
      {"0.12", "0.75", "-0.24", "-0.04", "-0.06", "0.11"}}},
    {"60fps",
     {"0.52", "4.82", "", "0.33", "0.22", "0.41"},
     {{"0.14", "0.35", "-0.57", "-0.004", "-0.02", "0.14"},
      {"0.16", "1.63", "-1.66", "-0.06", "-0.05", "0.15"},
      {"0.10", "0.93", "-1.15", "-0.04", "-0.03", "0.10"}}},
    {"60fps-blur",
     {"1.12", "4.54", "", "0.92", "0.87", "0.65"},
     {{"0.31", "1.06", "-1.90", "-0.02", "-0.003", "0.31"},
      {"0.34", "1.34", "-0.72", "-0.23", "-0.22", "0.25"},
      {"0.43", "0.70", "0.40", "-0.34", "-0.30", "0.27"}}},
};

const PaperSequenceValues* Find(const std::string& sequence) {
  for (const PaperSequenceValues& values : kValues) {
    if (sequence == values.sequence) return &values;
  }
  return nullptr;
}

}  // namespace

const PaperColumn* PaperPosition(const std::string& sequence) {
  const PaperSequenceValues* values = Find(sequence);
  return values ? &values->position : nullptr;
}

const PaperColumn* PaperOrientation(const std::string& sequence, int axis) {
  const PaperSequenceValues* values = Find(sequence);
  return values && axis >= 0 && axis < 3 ? &values->orientation[axis] : nullptr;
}

}  // namespace silt::experiments
