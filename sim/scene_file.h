// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/environment.h"
#include "silt/sim/material.h"

// clang-format off
// A scene in TOML. Metres, degrees, world z up, floor at z = 0. Paths are relative to the scene
// file. Unknown keys are errors. Keys without "default" are required.
//
//   name = "Office"            default: the folder's name
//   ambient = [r, g, b]        linear radiance of what nothing occludes; default [0.2, 0.2, 0.2]
//                              (instead of it: [environment])
//   exposure = 1.0             linear radiance × exposure → [0, 1]; default 1
//
//   [environment]              what nothing occludes: a picture, or a sky of three colours
//   file = "sky.hdr"           equirectangular, z up, +y in its middle, +x to the right of it; linear
//                              (.hdr), or what OpenCV reads, as sRGB. Or else all of
//   zenith = [r, g, b]         linear radiance straight up
//   horizon = [r, g, b]        and level
//   ground = [r, g, b]         and below the horizon
//   strength = 1               factor of the picture; default 1
//   yaw_deg = 0                turns the picture about z, counter-clockwise from above; default 0
//
//   [[archive]]                a .zip, .sh3f or other archive that models are taken from
//   id = "scopia"
//   file = "/usr/share/sweethome3d/furniture/Scopia.sh3f"
//
//   [[material]]
//   name = "carpet"
//   color = "#888888"          or [r, g, b] in 0..1, both sRGB-encoded; multiplies the texture;
//                              default: white under a texture, middle gray without
//   texture = "carpet.png"     default: none
//   tile_m = [1.0, 1.0]        width and height of one repeat of the picture. Default: the picture
//                              covers each face once (primitives), lies as the model says (models)
//   emission = [r, g, b]       linear radiance, multiplied by the texture; default none. It is seen,
//                              and lights what is near; but baked light finds it by chance alone,
//                              with noise where it is small: what lights a room is a [[light]]
//   cutout = false             holes where the texture's alpha is below ½; default false
//   two_sided = true           false: black from behind; default true
//   specular = 0.04            reflectance of a coat at normal incidence, 0..1; default 0: matt.
//                              This and the next three show with --specular or --light path
//   metallic = 0               1: a metal, whose colour is that of its reflections; default 0
//   roughness = 0.5            of the coat or metal, 0..1 (GGX, α = roughness²); default 0.5
//   mirror = false             a perfect mirror, tinted by the colour; default false
//
//   [[box]]
//   name = "cabinet"           default: "box 1", "box 2", …; the same for the others below
//   material = "wood"          needed unless `faces` names all six
//   faces = { top = "…", bottom = "…", front = "…", back = "…", left = "…", right = "…" }
//                              default: `material` all round. front is −y, left is −x (yaw 0). On
//                              the sides pictures stand upright; on top, right is +x and up is +y
//   size = [x, y, z]
//   at = [x, y, z]             centre of the bottom face; default [0, 0, 0]
//   yaw_deg = 0                turn about z, counter-clockwise from above; default 0
//
//   [[quad]]
//   name, material
//   corner = [x, y, z]         lower left corner of the picture
//   u = [x, y, z]              edge along the picture's width
//   v = [x, y, z]              edge along the picture's height; the front is where u × v points
//
//   [[sphere]]
//   name, material
//   center = [x, y, z]
//   radius = 0.1
//   segments = 48              around; half as many from pole to pole; 3 … 1024; default 48
//
//   [[cylinder]]
//   name, material             with tile_m, pictures repeat a whole number of times around
//   at = [x, y, z]             centre of the base; default [0, 0, 0]
//   radius = 0.1
//   height = 0.3               the axis is +z; both ends are closed
//   segments = 48              default 48
//
//   [[model]]
//   name                       default: "model 1", …
//   file = "models/desk.obj"   or, with `archive`, the path inside it: "scopia/desk/desk.obj"
//   archive = "scopia"         default: none, a plain file
//   size = [x, y, z]           the bounding box is stretched to exactly this; or else
//   scale = 0.01               metres per unit of the model; default (neither): 1
//   at = [x, y, z]             of the centre of the bounding box's bottom; default [0, 0, 0]
//   yaw_deg = 0                default 0: the model's front (its +z for up = "y") looks to −y
//   up = "y"                   the model's axis that points up: "y" (default; model x → x, y → z,
//                              z → −y) or "z"
//   rotation = [9 numbers]     a rotation of the model before all else, in its own axes, row by
//                              row (modelRotation in Sweet Home 3D's catalogues); default: none
//   mirror = false             left and right exchanged; default false
//   materials = { "Old" = "wood" }
//                              materials of the model to replace by materials of the scene; "*"
//                              stands for all that are not named and not transparent. A material
//                              with tile_m is projected along x, y or z, at its true size; one
//                              without keeps the model's texture coordinates. Default: none
//
//   [[light]]                  a rectangle center ± u ± v, seen as well
//   name
//   center = [x, y, z]
//   u = [x, y, z]              half edges; it shines to where u × v points
//   v = [x, y, z]
//   radiance = [r, g, b]       linear
//
// Transparent materials of models (opacity below ½) are left out.
// clang-format on
namespace silt::sim {

struct ArchiveEntry {
  std::filesystem::path file;
  std::string place;  // "file:line" for messages; the same below
};

struct MaterialEntry {
  Material material;              // its texture index is not set here
  std::filesystem::path texture;  // empty: none
  std::optional<Vec2f> tile_m;
  std::string place;
};

// Materials are given as indices into SceneFile::materials.
struct BoxEntry {
  std::string name;
  std::array<int, 6> faces{};  // top, bottom, front, back, left, right
  Vec3d size, at;
  double yaw_deg = 0;
};

struct QuadEntry {
  std::string name;
  int material = 0;
  Vec3d corner, u, v;
};

struct SphereEntry {
  std::string name;
  int material = 0;
  Vec3d center;
  double radius = 0;
  int segments = 0;
};

struct CylinderEntry {
  std::string name;
  int material = 0;
  Vec3d at;
  double radius = 0, height = 0;
  int segments = 0;
};

struct ModelEntry {
  std::string name;
  std::string archive;  // empty: a plain file
  std::string file;
  std::optional<Vec3d> size;
  double scale = 1;
  Vec3d at;
  double yaw_deg = 0;
  bool z_up = false;
  bool mirror = false;
  Mat3d rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::map<std::string, int> materials;  // by the model's own name
  std::string place;
};

struct EnvironmentEntry {
  std::filesystem::path file;  // empty: the sky
  Sky sky;
  double strength = 1, yaw_deg = 0;
};

struct LightEntry {
  std::string name;
  Vec3d center, u, v, radiance;
};

// What a scene file says, before anything that it names has been opened.
struct SceneFile {
  std::filesystem::path path;
  std::string name;
  Vec3d ambient;
  std::optional<EnvironmentEntry> environment;
  double exposure = 1;
  std::map<std::string, ArchiveEntry> archives;  // by id
  std::vector<MaterialEntry> materials;
  std::vector<BoxEntry> boxes;
  std::vector<QuadEntry> quads;
  std::vector<SphereEntry> spheres;
  std::vector<CylinderEntry> cylinders;
  std::vector<ModelEntry> models;
  std::vector<LightEntry> lights;
};

// Throws silt::Error "file:line: …" for whatever does not follow the format above.
SceneFile ReadSceneFile(const std::filesystem::path& file);

}  // namespace silt::sim
