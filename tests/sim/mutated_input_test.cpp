// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
// Whatever stands in a file, reading it gives a result or one line of what is wrong: seeded
// mutations of good files. SILT_MUTATIONS in the environment multiplies their number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "mutations.h"
#include "sample_model.h"
#include "silt/core/error.h"
#include "silt/sim/archive_io.h"
#include "silt/sim/environment.h"
#include "silt/sim/isolated_import.h"
#include "silt/sim/path_file.h"
#include "silt/sim/picture.h"
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

// A picture with some detail in each way that models bring: by extension, with what else its
// encoder is told, and the share of mutations that are to be read, or nothing behind the head was
// reached.
struct PictureFile {
  const char* name;
  int type;
  const char* extension;
  double least_share = 0;
  std::vector<int> parameters = {};
};
const std::vector<PictureFile> kPictureFiles{
    {"png", CV_8UC4, ".png"},
    {"png16", CV_16UC3, ".png"},
    {"gray", CV_8UC1, ".png"},
    {"jpeg", CV_8UC3, ".jpg", 0.1},
    {"progressive", CV_8UC3, ".jpg", 0.1, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
    {"restarts", CV_8UC3, ".jpg", 0.1, {cv::IMWRITE_JPEG_RST_INTERVAL, 2}},
    {"bmp", CV_8UC3, ".bmp", 0.1},
    {"tiff", CV_8UC3, ".tiff", 0.05},
    {"tiff16", CV_16UC3, ".tiff", 0.05, {cv::IMWRITE_TIFF_COMPRESSION, 1}},
    {"deflated", CV_8UC4, ".tiff", 0.05, {cv::IMWRITE_TIFF_COMPRESSION, 8}},
    {"float", CV_32FC3, ".tiff"},
    {"hdr", CV_32FC3, ".hdr"}};

std::string Encoded(const PictureFile& file) {
  cv::Mat image(37, 41, CV_MAKETYPE(CV_MAT_DEPTH(file.type), CV_MAT_CN(file.type)));
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(file.type) == CV_16U ? 65536 : 256);
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(file.extension, image, bytes, file.parameters)) << file.name;
  return {bytes.begin(), bytes.end()};
}

// Truevision's, which OpenCV does not read: 2 × 2 texels of 24 bits.
const std::string kTga("\0\0\x02\0\0\0\0\0\0\0\0\0\x02\0\x02\0\x18\0abcdefghijkl", 30);

void DecodeAsPicture(const std::string& bytes) {
  EncodedPicture picture;
  picture.place = "mutant";
  picture.colour = std::make_shared<const std::string>(bytes);
  const Image<Rgba8> decoded = DecodePicture(picture);
  EXPECT_FALSE(decoded.empty());
  EXPECT_LE(decoded.size(), 1u << 26);
}

// A PNG whose chunks (length, name, data, checksum) bear the checksums of what they hold now, so
// that the decoder looks behind them.
std::string WithChecksums(std::string png) {
  const auto number = [&png](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(png[at + i]);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = number(at);
    if (length > png.size() - at - 12) break;
    std::uint32_t crc = ~0u;
    for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
      crc ^= std::uint8_t(png[i]);
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = char(~crc >> (24 - 8 * i));
    at += 12 + length;
  }
  return png;
}

TEST(MutatedInput, Pictures) {
  for (const PictureFile& file : kPictureFiles) {
    SCOPED_TRACE(file.name);
    const std::string good = Encoded(file);
    const bool is_png = file.extension == std::string(".png");
    const double share = ShareRead(good, Mutations(150), [is_png](const std::string& bytes) {
      DecodeAsPicture(is_png ? WithChecksums(bytes) : bytes);
    });
    if (CV_MAT_DEPTH(file.type) == CV_32F) {
      EXPECT_EQ(share, 0);
    } else {
      DecodeAsPicture(is_png ? WithChecksums(good) : good);
      EXPECT_GE(share, file.least_share);
    }
  }
  EXPECT_EQ(ShareRead(kTga, Mutations(50), DecodeAsPicture), 0);
}

// Half of a mutation's bytes are often in a head; here each byte of it takes extreme values in
// turn.
TEST(MutatedInput, HeadsOfPictures) {
  for (const PictureFile& file : kPictureFiles) {
    SCOPED_TRACE(file.name);
    const std::string good = Encoded(file);
    for (std::size_t at = 0; at < 60; ++at) {
      for (const char value : {'\0', '\x01', '\x7f', '\x80', '\xff'}) {
        std::string bytes = good;
        bytes[at] = value;
        SCOPED_TRACE(at);
        try {
          DecodeAsPicture(bytes);
        } catch (const Error& e) {
          ExpectOneLine(e.what());
        }
      }
    }
  }
}

TEST(MutatedInput, Environments) {
  const TempFolder folder;
  for (const char* const name : {"hdr", "float", "png16", "jpeg"}) {
    const auto file =
        std::find_if(kPictureFiles.begin(), kPictureFiles.end(),
                     [&](const PictureFile& f) { return f.name == std::string(name); });
    SCOPED_TRACE(name);
    ShareRead(Encoded(*file), Mutations(100), [&](const std::string& bytes) {
      const Environment environment =
          LoadEnvironment(folder.Write(std::string("e") + file->extension, bytes), 1, 0);
      EXPECT_TRUE(std::isfinite(environment.mean().x));
    });
  }
}

}  // namespace
}  // namespace silt::sim
