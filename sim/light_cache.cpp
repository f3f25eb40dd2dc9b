// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_cache.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/sim/content_hash.h"
#include "silt/sim/scene_digest.h"

namespace silt::sim {

namespace {

namespace fs = std::filesystem;

// Rises with every change of what SolveLight or SurfaceGrid compute.
constexpr std::uint32_t kVersion = 5;
constexpr std::size_t kDigestSize = 32;
constexpr std::string_view kPrefix = "light-";
constexpr std::size_t kEntries = 8;  // of some 35 MB for a furnished room

std::optional<fs::path> CacheFolder() {
  const auto variable = [](const char* name) -> fs::path {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "silt";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "silt";
  return std::nullopt;
}

std::string Checksum(const StoredLight& light) {
  return ContentHash().AddArray(light.front).AddArray(light.back).Digest();
}

// Another process may do the same: what is gone already is no failure.
void RemoveOldEntries(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const bool is_light = entry.path().filename().string().starts_with(kPrefix);
    if (is_light) entries.push_back({entry.last_write_time(ignored), entry.path()});
  }
  std::sort(entries.rbegin(), entries.rend());
  for (std::size_t i = kEntries; i < entries.size(); ++i) fs::remove(entries[i].second, ignored);
}

std::string_view Bytes(const std::vector<Vec3f>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Vec3f)};
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
      .Add(options.bounces);
  hash.Add(options.seed);
  const std::string digest = SceneDigest(scene, SurfacesAre::kMatt);
  hash.AddBytes(digest.data(), digest.size());
  return *folder / (std::string(kPrefix) + hash.Digest());
}

std::optional<StoredLight> ReadLight(const fs::path& file, std::size_t samples) {
  std::ifstream in(file, std::ios::binary);
  std::string checksum(kDigestSize, '\0');
  StoredLight light(samples);
  in.read(checksum.data(), kDigestSize);
  for (std::vector<Vec3f>* values : {&light.front, &light.back}) {
    in.read(reinterpret_cast<char*>(values->data()),
            std::streamsize(values->size() * sizeof(Vec3f)));
  }
  if (!in || in.peek() != std::ifstream::traits_type::eof()) return std::nullopt;
  if (checksum != Checksum(light)) return std::nullopt;
  return light;
}

void WriteLight(const fs::path& file, const StoredLight& light) {
  std::string contents = Checksum(light);
  contents += Bytes(light.front);
  contents += Bytes(light.back);
  WriteFileAtomically(file, contents);
  RemoveOldEntries(file.parent_path());
}

}  // namespace silt::sim
