// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/io/sequence_format.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/truth_writer.h"
#include "silt/sim/imu.h"

namespace silt::experiments {

// What `silt render` is asked for.
struct RenderRequest {
  RenderPlan plan;
  std::string out, format = "tum";
  TruthSelection truth;
  sim::ImuOptions imu;
  bool overwrite = false;

  // Of the whole render: two with the same result in the same bytes.
  Json ToJson(const World& world) const;
};

// Renders the frames that are missing in the folder, ends the sequence and says so on stdout.
void RunRender(const World& world, const RenderRequest& request, const std::string& command_line);

}  // namespace silt::experiments
