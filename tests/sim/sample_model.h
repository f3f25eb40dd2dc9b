// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

// Small models as files' contents, for tests that write them to folders and archives.
namespace silt::sim {

// A PNG of 2×2: red, green over blue, white; with `alpha` the white texel is invisible.
std::string SamplePng(bool alpha = false);

// A sheet 2 wide (x), 1 high (y) at z = 0 that looks to +z, textured by SamplePng.
std::string SampleObj();
// Its material "paper", which names `picture`.
std::string SampleMtl(const std::string& picture = "picture.png");

// A .zip of these files, by name.
std::string ZipOf(const std::map<std::string, std::string>& files);

std::string Base64(const std::string& bytes);

// A triangle (0,0,0) (1,0,0) (0,1,0) with SamplePng embedded as data URI; `node` is put into its
// node, such as `"scale":[-1,1,1],`.
std::string SampleGltf(const std::string& node = "");

}  // namespace silt::sim
