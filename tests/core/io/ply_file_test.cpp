// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/ply_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "posed_image.h"
#include "silt/core/error.h"

namespace silt {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Written {
  std::string header, body;
};

Written Write(const PlyModel& model) {
  const SequenceFolder folder;
  WritePly(folder / "model.ply", model);
  const std::string text = ReadText(folder / "model.ply"), end = "end_header\n";
  const std::size_t at = text.find(end) + end.size();
  return {text.substr(0, at), text.substr(at)};
}

TEST(PlyFile, PointsAreFloatsAndBytes) {
  const Written file = Write({{{1, 2, 3}, {-4, 5.5f, 6}}, {{7, 8, 9}, {10, 11, 255}}, {}, {}});
  EXPECT_THAT(file.header, HasSubstr("ply\nformat binary_little_endian 1.0\nelement vertex 2\n"));
  EXPECT_THAT(file.header, Not(HasSubstr("face")));
  EXPECT_THAT(file.header, Not(HasSubstr("edge")));
  ASSERT_EQ(file.body.size(), 2 * 15u);
  float y = 0;
  std::memcpy(&y, file.body.data() + 15 + 4, sizeof y);
  EXPECT_EQ(y, 5.5f);
  EXPECT_EQ(std::uint8_t(file.body[15 + 14]), 255);
}

TEST(PlyFile, TrianglesAndEdgesFollow) {
  PlyModel model;
  model.points.resize(4);
  model.colors.resize(4);
  model.triangles = {{0, 1, 2}, {1, 2, 3}};
  model.edges = {{2, 3}};
  const Written file = Write(model);
  EXPECT_THAT(file.header, HasSubstr("element face 2\nproperty list uchar int vertex_indices\n"));
  EXPECT_THAT(file.header, HasSubstr("element edge 1\nproperty int vertex1\n"));
  ASSERT_EQ(file.body.size(), 4 * 15u + 2 * 13u + 8u);
  EXPECT_EQ(file.body[60], 3);
  std::int32_t index = 0;
  std::memcpy(&index, file.body.data() + file.body.size() - 4, sizeof index);
  EXPECT_EQ(index, 3);
}

TEST(PlyFile, WhereItCannotBeWrittenIsNamed) {
  try {
    WritePly("/dev/null/all.ply", {});
    FAIL() << "written";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/null: cannot make the folder"));
  }
}

}  // namespace
}  // namespace silt
