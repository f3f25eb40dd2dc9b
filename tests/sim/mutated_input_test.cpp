// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
// Whatever stands in a file, reading it gives a result or one line of what is wrong: seeded
// mutations of good files. SILT_MUTATIONS in the environment multiplies their number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>

#include "mutations.h"
#include "sample_model.h"
#include "silt/core/error.h"
#include "silt/sim/archive_io.h"
#include "silt/sim/isolated_import.h"
#include "silt/sim/path_file.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/scene.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

std::uint64_t Mutations(std::uint64_t count) {
  const char* const factor = std::getenv("SILT_MUTATIONS");
  return count * std::uint64_t(factor == nullptr ? 1 : std::max(1, std::atoi(factor)));
}

void ExpectOneLine(const std::string& message) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_FALSE(message.empty());
  EXPECT_LT(message.size(), 1000u) << message;
}

// The share of mutations that read(text) takes; the others must be refused in one line.
double ShareRead(const std::string& good, std::uint64_t count,
                 const std::function<void(const std::string&)>& read) {
  std::uint64_t taken = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string text = Mutated(good, i);
    SCOPED_TRACE("mutation " + std::to_string(i));
    try {
      read(text);
      ++taken;
    } catch (const Error& e) {
      ExpectOneLine(e.what());
    }
  }
  return double(taken) / double(count);
}

TEST(MutatedInput, PathFiles) {
  const TempFolder folder;
  folder.Write("r.txt", "0 0 0 1 0 0 0 1\n0.5 1 0 1 0 0 0 1\n1 1 1 1 0 0 0 1\n");
  const std::vector<std::string> good{
      "[[key]]\ntime_s = 0\nposition = [1, 2, 1.5]\nlook_at = [1, 4, 1.5]\nroll_deg = 3\n"
      "[[key]]\ntime_s = 2.5\nposition = [1.5, 2, 1.5]\nquaternion = [0, 0, 0, 1]\n"
      "[hand_shake]\nposition_mm = 2\nrotation_deg = 0.5\nband_hz = [1, 4]\nseed = 9\n",
      "[replay]\nfile = \"r.txt\"\nstart_s = 0\nduration_s = 1\nspeed = 2\nscale = 1\n"
      "position = [1, 2, 3]\nyaw_deg = 20\nknot_spacing_s = 0.1\nsmoothing_s = 0.02\n",
      "[orbit]\ncenter = [0, 0, 1]\nradius = 1\nfrom_deg = 0\nsweep_deg = 90\nduration_s = 5\n"
      "ease_s = 1\nlook_at = [0, 0, 0.5]\n",
      "[lissajous]\ncenter = [0, 0, 1]\namplitude = [1, 1, 1]\nfrequency_hz = [1, 2, 3]\n"
      "phase_deg = [1, 2, 3]\nduration_s = 5\ndirection = [1, 0, 0]\n"};
  for (const std::string& text : good) {
    const double share = ShareRead(text, Mutations(300), [&](const std::string& mutated) {
      const CameraPath path = ParseCameraPath(mutated, (folder.path() / "p.toml").string());
      const SE3d pose = path.WorldFromCamera(path.duration_s() / 2);
      EXPECT_TRUE(std::isfinite(pose.translation.x + pose.rotation.w)) << mutated;
    });
    EXPECT_GT(share, 0.005);  // or nothing behind the parser was reached
    EXPECT_LT(share, 0.7);
  }
}

TEST(MutatedInput, RecordedTrajectories) {
  const TempFolder folder;
  const std::string good =
      "# a comment\n0 0 0 1 0 0 0 1\n0.5 1 0 1 0 0 0 1\n1 1 1 1 0 0.6 0 0.8\n1.5 2 2 2 0 0 0 1\n";
  ShareRead(good, Mutations(150), [&](const std::string& mutated) {
    folder.Write("r.txt", mutated);
    const CameraPath path =
        ParseCameraPath("[replay]\nfile = \"r.txt\"\n", (folder.path() / "p.toml").string());
    EXPECT_TRUE(std::isfinite(path.WorldFromCamera(0).translation.x)) << mutated;
  });
}

const std::string kScene = R"(name = "Mutant"
ambient = [0.1, 0.1, 0.1]
exposure = 1.5
[[archive]]
id = "a"
file = "a.zip"
[[material]]
name = "paint"
color = "#336699"
texture = "picture.png"
tile_m = [0.5, 0.5]
cutout = true
[[box]]
material = "paint"
faces = { top = "paint" }
size = [1, 2, 0.5]
at = [0, 1, 0]
yaw_deg = 30
[[quad]]
material = "paint"
corner = [-2, -2, 0]
u = [4, 0, 0]
v = [0, 4, 0]
[[sphere]]
material = "paint"
center = [1, 1, 1]
radius = 0.3
segments = 12
[[cylinder]]
material = "paint"
radius = 0.1
height = 0.4
segments = 8
[[light]]
name = "lamp"
center = [0, 0, 2]
u = [0.3, 0, 0]
v = [0, -0.3, 0]
radiance = [5, 5, 5]
)";

const std::string kModel = R"([[model]]
file = "sheet.obj"
archive = "a"
size = [1, 1, 0.1]
yaw_deg = 45
up = "z"
mirror = true
materials = { "paper" = "paint" }
)";

void ExpectFinite(const Scene& scene) {
  double sum = 0;
  for (const Vec3f& p : scene.mesh.positions) sum += std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(MutatedInput, SceneFiles) {
  const TempFolder folder;
  folder.Write("picture.png", SamplePng());
  folder.Write("a.zip", ZipOf({{"sheet.obj", SampleObj()}, {"sheet.mtl", SampleMtl()}}));
  const auto load = [&](const std::string& text) {
    const Scene scene = LoadScene(folder.Write("scene.toml", text));
    ExpectFinite(scene);
    const RayTracer tracer(scene);
  };
  load(kScene + kModel);
  EXPECT_LT(ShareRead(kScene, Mutations(250), load), 0.7);
  // Each of these starts processes.
  ShareRead(kModel, Mutations(30), [&](const std::string& text) { load(kScene + text); });
}

TEST(MutatedInput, Archives) {
  const TempFolder folder;
  const std::string good = ZipOf({{"d/sheet.obj", SampleObj()}, {"d/sheet.mtl", SampleMtl()}});
  ShareRead(good, Mutations(150), [&](const std::string& bytes) {
    const Archive archive(folder.Write("a.zip", bytes));
    const auto name = archive.Find("d/sheet.obj");
    EXPECT_LT(name ? archive.Read(*name)->size() : 0, 1u << 20);
  });
}

// Files in memory.
class MemorySource : public AssetSource {
 public:
  explicit MemorySource(std::map<std::string, std::string> files) : files_(std::move(files)) {}
  std::optional<std::string> Find(std::string_view path) const override {
    const std::string name = NormalizedAssetPath(path);
    return files_.contains(name) ? std::optional(name) : std::nullopt;
  }
  Bytes Read(const std::string& name) const override {
    return std::make_shared<const std::string>(files_.at(name));
  }
  std::string Describe(const std::string& name) const override { return name; }

 private:
  std::map<std::string, std::string> files_;
};

// Imports mutations of one of a model's files. assimp's PLY importer does loop for ever over some.
void ImportMutations(const std::string& model, const std::string& mutated, std::uint64_t count,
                     const std::map<std::string, std::string>& files) {
  std::vector<MemorySource> sources;
  for (std::uint64_t i = 0; i < count; ++i) {
    auto changed = files;
    changed[mutated] = Mutated(files.at(mutated), i);
    sources.emplace_back(std::move(changed));
  }
  std::vector<ImportTask> tasks;
  for (const MemorySource& source : sources) tasks.push_back({&source, model});
  const auto outcomes = ImportIsolated(tasks, {.time_s = 0.5});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    SCOPED_TRACE(mutated + ", mutation " + std::to_string(i));
    if (!outcomes[i].model) ExpectOneLine(outcomes[i].problem);
  }
}

TEST(MutatedInput, Models) {
  const std::map<std::string, std::string> sheet{
      {"sheet.obj", SampleObj()}, {"sheet.mtl", SampleMtl()}, {"picture.png", SamplePng()}};
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string stl =
      "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid t\n";
  ImportMutations("sheet.obj", "sheet.obj", Mutations(150), sheet);
  ImportMutations("sheet.obj", "sheet.mtl", Mutations(150), sheet);
  ImportMutations("t.gltf", "t.gltf", Mutations(150), {{"t.gltf", SampleGltf()}});
  ImportMutations("t.ply", "t.ply", Mutations(30), {{"t.ply", ply}});
  ImportMutations("t.stl", "t.stl", Mutations(150), {{"t.stl", stl}});
}

TEST(MutatedInput, Pictures) {
  ShareRead(SamplePng(true), Mutations(500), [](const std::string& bytes) {
    EncodedPicture picture;
    picture.place = "mutant.png";
    picture.colour = std::make_shared<const std::string>(bytes);
    EXPECT_FALSE(DecodePicture(picture).empty());
  });
}

}  // namespace
}  // namespace silt::sim
