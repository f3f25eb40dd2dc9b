// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/sim/asset_source.h"
#include "silt/sim/model_import.h"

struct aiScene;

namespace silt::sim {

struct MaterialContext {
  const AssetSource& source;
  const std::string& model_name;  // pictures are looked for beside it
  bool linear_colours = false;    // or sRGB-encoded
};

// Appends the scene's materials and, once each, the pictures that they name. A picture that is not
// where its path says is looked for beside the model, by its bare name; what is not found at all
// leaves a warning and the plain colour.
void AppendMaterials(Model& model, const aiScene& scene, const MaterialContext& context);

}  // namespace silt::sim
