// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/traced_pictures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/io/npy_file.h"
#include "silt/experiments/resources.h"
#include "silt/sim/scene_file.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry);
  return files;
}

class TracedPicturesTest : public testing::Test {
 protected:
  static sim::LitScene TracedStudio(float more_roughness = 0) {
    sim::LightingOptions lighting;
    lighting.mode = sim::LightMode::kPath;
    sim::Scene scene = sim::LoadScene(SceneFile("studio"));
    for (sim::Material& material : scene.materials) material.roughness += more_roughness;
    return sim::LitScene(std::move(scene), lighting);
  }

  const TestFolder folder_;
  const sim::LitScene scene_ = TracedStudio();
  const LightView view_ = ViewsAlong("studio", {"orbit"}, 1).front();
  const PathReference reference_{.width = 16, .samples_per_pixel = 4};
};

TEST_F(TracedPicturesTest, AreTracedOnceAndThenRead) {
  const ReferencePicture traced = TraceReference(scene_, view_, 0, reference_);
  const TracedPictures pictures(reference_, folder_.path() / "deep" / "paths");
  EXPECT_EQ(Norm(pictures.Of(scene_, view_, 0).half[1](3, 4) - traced.half[1](3, 4)), 0);
  const std::vector<fs::path> files = FilesIn(folder_.path() / "deep" / "paths");
  ASSERT_EQ(files.size(), 2u);
  for (const fs::path& file : files) WriteNpy(file, Image<Vec3f>(16, 12, Vec3f{1, 2, 3}));
  EXPECT_EQ(pictures.Of(scene_, view_, 0).half[0](3, 4).z, 3);  // not traced again
}

TEST_F(TracedPicturesTest, AreNeverThoseOfOtherViewsOrSettings) {
  const auto keep_of = [&](const sim::LitScene& scene, const LightView& view,
                           const PathReference& reference) {
    TracedPictures(reference, folder_.path()).Of(scene, view, 0);
    return FilesIn(folder_.path()).size();
  };
  const auto keep = [&](const LightView& view, const PathReference& reference) {
    return keep_of(scene_, view, reference);
  };
  EXPECT_EQ(keep(view_, reference_), 2u);
  LightView moved = view_;
  moved.world_from_camera.translation.x += 1e-9;
  EXPECT_EQ(keep(moved, reference_), 4u);
  PathReference other = reference_;
  other.samples_per_pixel = 6;
  EXPECT_EQ(keep(view_, other), 6u);
  other.seed = 1;
  EXPECT_EQ(keep(view_, other), 8u);
  other.reflection = true;
  EXPECT_EQ(keep(view_, other), 10u);
  EXPECT_EQ(keep(view_, reference_), 10u);
  // Gloss changes the picture only where it is traced.
  const sim::LitScene rough = TracedStudio(0.1f);
  EXPECT_EQ(keep_of(rough, view_, reference_), 10u);
  EXPECT_EQ(keep_of(rough, view_, other), 12u);
}

TEST_F(TracedPicturesTest, AFileThatIsNoneIsNamed) {
  const TracedPictures pictures(reference_, folder_.path());
  pictures.Of(scene_, view_, 0);
  const fs::path file = FilesIn(folder_.path()).front();
  std::ofstream(file, std::ios::app) << "x";
  try {
    pictures.Of(scene_, view_, 0);
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
  }
  EXPECT_THROW(TracedPictures(reference_, file / "below"), Error);
}

}  // namespace
}  // namespace silt::experiments
