// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/sim/asset_source.h"
#include "silt/sim/material.h"
#include "silt/sim/mesh.h"
#include "silt/sim/picture.h"

namespace silt::sim {

struct ModelMaterial {
  // `texture` is an index into Model::pictures; `cutout` says that its alpha counts, if it has any.
  Material surface;
  bool invisible = false;  // more transparent than not
};

// A model as its file describes it: in its own axes and unit of length.
struct Model {
  Mesh mesh;
  std::vector<ModelMaterial> materials;
  std::vector<EncodedPicture> pictures;
  // A picture replaces the diffuse colour, instead of multiplying it. That is so in all formats but
  // glTF: in MTL exporters leave 0.64 or 0.8 of some default material there.
  bool picture_replaces_diffuse = true;
  std::vector<std::string> warnings;  // one line each: files that the model names and lacks
};

// Reads any format that assimp knows, with the files that it names (materials, pictures, buffers)
// from the same source. Triangles without area, with coordinates that are not finite, or in the
// place of another are left out; nodes are flattened, mirrored ones turned outward again. Colours
// are taken as sRGB-encoded, those of glTF as linear. Throws silt::Error where there is no such
// model, or it is damaged or empty.
Model ImportModel(const AssetSource& source, const std::string& path);

}  // namespace silt::sim
