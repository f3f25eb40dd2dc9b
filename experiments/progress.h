// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace silt::experiments {

// Tells on stderr how far a long run is and how much time is left: on a terminal one line that is
// rewritten, elsewhere a line now and then. Says nothing of runs that are over within a second.
class Progress {
 public:
  // `total` is the work in any unit.
  explicit Progress(double total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Some work is done; `doing` says what is next or was just done ("60fps, frame 12 of 90").
  void Advance(double work, const std::string& doing);

 private:
  void Show(const std::string& doing);

  double total_, done_ = 0;
  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_, next_;
};

// "0:07", "12:30", "1:02:03".
std::string FormatDuration(double seconds);

}  // namespace silt::experiments
