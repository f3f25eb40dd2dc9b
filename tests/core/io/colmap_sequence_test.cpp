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
  LensDistortion lens;
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
  if (name == "FULL_OPENCV") {
    LensDistortion& l = model.lens;
    double k4 = 1, k5 = 1, k6 = 1;
    camera >> l.k1 >> l.k2 >> l.p1 >> l.p2 >> l.k3 >> k4 >> k5 >> k6;
    EXPECT_TRUE(k4 == 0 && k5 == 0 && k6 == 0);
  } else {
    EXPECT_EQ(name, "PINHOLE");
  }
  EXPECT_TRUE(bool(camera) && (camera >> std::ws).eof());
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
  image.rgb = ReadRgb(folder / "images" / picture.name);
  image.gray = GrayFromRgb(image.rgb);
  image.depth_m = ReadDepth(folder / "depth" / picture.name);
  image.fx = model.camera.fx;
  image.fy = model.camera.fy;
  image.cx = model.camera.cx - 0.5;
  image.cy = model.camera.cy - 0.5;
  image.rotation = picture.rotation.Conjugate().Matrix();
  image.position = -(image.rotation * picture.translation);
  image.lens = model.lens;
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

TEST_F(ColmapSequence, HoldsEveryPoseColourAndDepthThatWasWritten) {
  for (const LensDistortion& lens : {LensDistortion{}, kBoxLens}) {
    const SequenceFolder folder;
    SequenceDescription description = BoxDescription(5);
    description.lens = lens;
    const std::vector<Frame> frames = ColoredFrames(description);
    ColmapSequenceWriter writer(folder.path(), description);
    for (std::size_t i = 0; i < frames.size(); ++i) writer.Write(int(i), frames[i]);
    writer.Finish();
    const Model model = ReadModel(folder / "sparse/0");
    EXPECT_EQ(model.camera.width, kBoxCamera.width);
    EXPECT_EQ(model.camera.height, kBoxCamera.height);
    ASSERT_EQ(model.pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const PosedImage found = ReadFrame(folder.path(), model, int(i) + 1);
      ExpectSame(found, description, i, frames[i], 1.0 / 5000);
    }
  }
}

TEST_F(ColmapSequence, PicturesAndPointsThroughALensAreConsistentWithFullOpencv) {
  const SequenceFolder folder;
  SequenceDescription description = BoxDescription(4);
  description.lens = kBoxLens;
  ColmapSequenceWriter writer(folder.path(), description);
  WriteBox(writer, description);
  const Model model = ReadModel(folder / "sparse/0");
  const PosedImage from = ReadFrame(folder.path(), model, 1),
                   to = ReadFrame(folder.path(), model, 4);
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithoutLens(from), WithoutLens(to)), 3 * right);
  const Model::Picture& picture = model.pictures.at(1);
  ASSERT_FALSE(picture.places.empty());
  for (std::size_t i = 0; i < picture.places.size(); ++i) {
    const Vec2d at = from.ToImage(model.points.at(picture.points[i]).position);
    EXPECT_NEAR(at.x + 0.5, picture.places[i].x, 1e-4);
    EXPECT_NEAR(at.y + 0.5, picture.places[i].y, 1e-4);
  }
}

TEST_F(ColmapSequence, TheCameraCountsFromThePixelsCorner) {
  EXPECT_EQ(model_.camera.cx, 80);
  EXPECT_EQ(model_.camera.cy, 60);
  EXPECT_EQ(model_.camera.width, 160);
}

}  // namespace
}  // namespace silt
