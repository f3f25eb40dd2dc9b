// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/colmap_sequence.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "posed_image.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

// A model as COLMAP's documentation tells to read it.
struct Model {
  struct Picture {
    Quaterniond rotation;  // camera from world
    Vec3d translation;
    std::string name;
    std::vector<Vec2d> places;
    std::vector<int> points;
  };
  struct Point {
    Vec3d position;
    int r = 0, g = 0, b = 0, image = 0, index = 0;
  };
  PinholeCamera camera;
  std::map<int, Picture> pictures;
  std::map<int, Point> points;
};

std::vector<std::string> LinesOf(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] != '#') lines.push_back(line);
  }
  return lines;
}

void ReadPictures(const fs::path& file, Model& model) {
  const std::vector<std::string> lines = LinesOf(file);
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    std::istringstream head(lines[i]), body(lines[i + 1]);
    int id = 0, camera = 0;
    Model::Picture p;
    head >> id >> p.rotation.w >> p.rotation.x >> p.rotation.y >> p.rotation.z >> p.translation.x >>
        p.translation.y >> p.translation.z >> camera >> p.name;
    EXPECT_EQ(camera, 1);
    double x = 0, y = 0;
    for (int point = 0; body >> x >> y >> point;) {
      p.places.push_back({x, y});
      p.points.push_back(point);
    }
    model.pictures[id] = p;
  }
}

Model ReadModel(const fs::path& folder) {
  Model model;
  int id = 0;
  std::string name;
  std::istringstream camera(LinesOf(folder / "cameras.txt").at(0));
  PinholeCamera& c = model.camera;
  camera >> id >> name >> c.width >> c.height >> c.fx >> c.fy >> c.cx >> c.cy;
  EXPECT_EQ(name, "PINHOLE");
  ReadPictures(folder / "images.txt", model);
  for (const std::string& line : LinesOf(folder / "points3D.txt")) {
    std::istringstream in(line);
    Model::Point p;
    double error = -1;
    in >> id >> p.position.x >> p.position.y >> p.position.z >> p.r >> p.g >> p.b >> error >>
        p.image >> p.index;
    EXPECT_TRUE(bool(in)) << line;
    model.points[id] = p;
  }
  return model;
}

PosedImage ReadFrame(const fs::path& folder, const Model& model, int id) {
  const Model::Picture& picture = model.pictures.at(id);
  PosedImage image;
  image.gray = GrayFromRgb(ReadRgb(folder / "images" / picture.name));
  image.depth_m = ReadDepth(folder / "depth" / picture.name);
  image.fx = model.camera.fx;
  image.fy = model.camera.fy;
  image.cx = model.camera.cx - 0.5;
  image.cy = model.camera.cy - 0.5;
  image.rotation = picture.rotation.Conjugate().Matrix();
  image.position = -(image.rotation * picture.translation);
  return image;
}

class ColmapSequence : public testing::Test {
 protected:
  void SetUp() override {
    const SequenceDescription description = BoxDescription(12);
    ColmapSequenceWriter writer(folder_.path(), description);
    WriteBox(writer, description);
    model_ = ReadModel(folder_ / "sparse/0");
  }
  SequenceFolder folder_;
  Model model_;
};

TEST_F(ColmapSequence, PicturesAreConsistentWithThePosesOfTheWorld) {
  ASSERT_EQ(model_.pictures.size(), 12u);
  const PosedImage from = ReadFrame(folder_.path(), model_, 1),
                   to = ReadFrame(folder_.path(), model_, 4);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
  EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
  EXPECT_GT(WarpError(WithDepthMistaken(from, -1), WithDepthMistaken(to, -1)), 3 * right);
}

// Bundle adjustment would find nothing to do: reprojection errors are those of 0.1 mm of depth.
TEST_F(ColmapSequence, PointsProjectWhereTheyAreObserved) {
  // Frames 0 and 10, a grid of 10 × 7 (every 16th pixel from the 8th).
  EXPECT_EQ(model_.points.size(), 2u * 10 * 7);
  std::size_t observed = 0;
  for (const auto& [id, picture] : model_.pictures) {
    for (std::size_t i = 0; i < picture.places.size(); ++i, ++observed) {
      const Model::Point& point = model_.points.at(picture.points[i]);
      EXPECT_EQ(point.image, id);
      EXPECT_EQ(point.index, int(i));
      const Vec3d p = picture.rotation * point.position + picture.translation;
      const Vec2d at = model_.camera.Project(p);
      EXPECT_NEAR(at.x, picture.places[i].x, 1e-4);
      EXPECT_NEAR(at.y, picture.places[i].y, 1e-4);
      EXPECT_NEAR(point.r, 255 * BoxPattern(point.position), 1.5);
    }
  }
  EXPECT_EQ(observed, model_.points.size());
}

TEST_F(ColmapSequence, TheCameraCountsFromThePixelsCorner) {
  EXPECT_EQ(model_.camera.cx, 80);
  EXPECT_EQ(model_.camera.cy, 60);
  EXPECT_EQ(model_.camera.width, 160);
}

}  // namespace
}  // namespace silt
