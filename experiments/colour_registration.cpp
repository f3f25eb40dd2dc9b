// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/colour_registration.h"

#include "silt/core/formatted.h"
#include "silt/experiments/tracker_options.h"

namespace silt::experiments {

std::string DoubtOfColours(const std::string& preset, double edge_contrast) {
  const tracker::AlignmentOptions options = PresetOptions(preset).alignment;
  // Where all are doubted whatever their edges tell, that has been asked for.
  if (options.registered_contrast == 0 || !options.DoubtsColours(edge_contrast)) return "";
  return Formatted(
      "colours do not lie on their depths, as edges of both tell (contrast %.2f, and %.2f or more "
      "where they do): depths count where both contradict each other",
      edge_contrast, options.registered_contrast);
}

}  // namespace silt::experiments
