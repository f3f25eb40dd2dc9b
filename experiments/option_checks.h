// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace silt::experiments {

// CLI11's own range messages print hundreds of digits; these say "--fps: 0 is not a number from 0.1
// to 10000". Both return the option for chaining.
CLI::Option* RequireNumber(CLI::Option* option, double low, double high);
CLI::Option* RequireInteger(CLI::Option* option, long long low, long long high);

// --backend, as BackendNames has them; "auto" becomes what it stands for, so that whatever is
// written beside results tells where they were computed.
CLI::Option* AddBackendOption(CLI::App& command, std::string& backend);

}  // namespace silt::experiments
