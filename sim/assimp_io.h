// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <string>

#include "silt/sim/asset_source.h"

namespace Assimp {
class IOSystem;
}

namespace silt::sim {

// Lets one assimp importer read, and only read, from `source`. Files that it asks for in vain go to
// `missing` with the reason; both must outlive the result.
std::unique_ptr<Assimp::IOSystem> MakeAssimpIo(const AssetSource& source,
                                               std::set<std::string>& missing);

}  // namespace silt::sim
