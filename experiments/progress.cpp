// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace silt::experiments {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kTerminalInterval(200), kLogInterval(10000), kSilence(1000);

}  // namespace

std::string FormatDuration(double seconds) {
  const long long s = std::llround(std::clamp(seconds, 0.0, 1e9));
  char text[48];
  if (s < 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld", s / 60, s % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60);
  }
  return text;
}

Progress::Progress(double total)
    : total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_ + (terminal_ ? kSilence : kLogInterval)) {}

Progress::~Progress() {
  if (terminal_ && shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::Advance(double work, const std::string& doing) {
  done_ += work;
  if (Clock::now() >= next_) Show(doing);
}

void Progress::Show(const std::string& doing) {
  const auto now = Clock::now();
  next_ = now + (terminal_ ? kTerminalInterval : kLogInterval);
  const double spent_s = std::chrono::duration<double>(now - start_).count();
  const double share = std::clamp(done_ / total_, 1e-9, 1.0);
  std::fprintf(stderr, "%ssilt: %3.0f %%, %s left: %s%s", terminal_ ? "\r" : "", 100 * share,
               FormatDuration(spent_s / share * (1 - share)).c_str(), doing.c_str(),
               terminal_ ? "\033[K" : "\n");
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace silt::experiments
