// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/sim/content_hash.h"
#include "silt/sim/scene_digest.h"

namespace silt::sim {

namespace {

namespace fs = std::filesystem;

// Rises with every change of what SolveLight or SurfaceGrid compute.
constexpr std::uint32_t kVersion = 7;
constexpr std::size_t kDigestSize = 32;
constexpr std::string_view kPrefix = "light-";
constexpr std::size_t kEntries = 16;  // of some 100 MB for a furnished room

std::optional<fs::path> CacheFolder() {
  const auto variable = [](const char* name) -> fs::path {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "silt";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "silt";
  return std::nullopt;
}

std::string Checksum(const BakedLight& light) {
  return ContentHash()
      .AddArray(light.samples.front)
      .AddArray(light.samples.back)
      .AddArray(light.fine.patches())
      .AddArray(light.fine.irradiance())
      .Digest();
}

// Another process may do the same: what is gone already is no failure. Parts that have not grown
// for an hour belong to no writer any more.
void RemoveOldEntries(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::error_code ignored;
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const fs::file_time_type written = entry.last_write_time(ignored);
    if (name.starts_with(kPrefix)) entries.push_back({written, entry.path()});
    const bool is_part = IsPartOfFile(entry.path()) && name.substr(1).starts_with(kPrefix);
    if (is_part && written < long_ago) fs::remove(entry.path(), ignored);
  }
  std::sort(entries.rbegin(), entries.rend());
  for (std::size_t i = kEntries; i < entries.size(); ++i) fs::remove(entries[i].second, ignored);
}

template <typename T>
std::string_view Bytes(const std::vector<T>& values) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Vec3f>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <typename T>
void Read(std::istream& in, std::vector<T>& values) {
  in.read(reinterpret_cast<char*>(values.data()), std::streamsize(Bytes(values).size()));
}

// How many patches lie in what is left of a file of so many bytes, if it is a whole number.
std::optional<std::size_t> PatchesIn(std::uintmax_t bytes) {
  constexpr std::uintmax_t each = sizeof(FineLight::Patch) + FineLight::kPlaces * sizeof(Vec3f);
  if (bytes % each != 0) return std::nullopt;
  return std::size_t(bytes / each);
}

}  // namespace

std::optional<fs::path> LightCacheFile(const Scene& scene, const LightingOptions& options) {
  const std::optional<fs::path> folder = CacheFolder();
  if (!folder) return std::nullopt;
  ContentHash hash;
  hash.Add(kVersion).Add(options.direct_spacing_m).Add(options.indirect_spacing_m);
  hash.Add(options.bounce_spacing_m).Add(options.light_points);
  hash.Add(options.environment_directions)
      .Add(options.gather_directions)
      .Add(options.gather_rounds)
      .Add(options.gather_tolerance)
      .Add(options.bounce_directions)
      .Add(options.bounces)
      .Add(options.refine_tolerance);
  hash.Add(options.seed);
  const std::string digest = SceneDigest(scene, SurfacesAre::kMatt);
  hash.AddBytes(digest.data(), digest.size());
  return *folder / (std::string(kPrefix) + hash.Digest());
}

// A checksum, both sides of the samples, and what is left of the file are patches.
std::optional<BakedLight> ReadLight(const fs::path& file, std::size_t samples) {
  std::error_code none;
  const std::uintmax_t size = fs::file_size(file, none),
                       least = kDigestSize + 2 * samples * sizeof(Vec3f);
  if (none || size < least) return std::nullopt;
  const std::optional<std::size_t> count = PatchesIn(size - least);
  if (!count) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::string checksum(kDigestSize, '\0');
  in.read(checksum.data(), kDigestSize);
  StoredLight stored(samples);
  std::vector<FineLight::Patch> patches(*count);
  std::vector<Vec3f> irradiance(*count * FineLight::kPlaces);
  Read(in, stored.front);
  Read(in, stored.back);
  Read(in, patches);
  Read(in, irradiance);
  if (!in || !std::is_sorted(patches.begin(), patches.end())) return std::nullopt;
  BakedLight light{std::move(stored), {std::move(patches), std::move(irradiance)}};
  if (checksum != Checksum(light)) return std::nullopt;
  return light;
}

void WriteLight(const fs::path& file, const BakedLight& light) {
  std::string contents = Checksum(light);
  contents += Bytes(light.samples.front);
  contents += Bytes(light.samples.back);
  contents += Bytes(light.fine.patches());
  contents += Bytes(light.fine.irradiance());
  WriteFileAtomically(file, contents);
  RemoveOldEntries(file.parent_path());
}

}  // namespace silt::sim
