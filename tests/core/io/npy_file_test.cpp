// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/npy_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "numpy.h"
#include "posed_image.h"
#include "silt/core/error.h"

namespace silt {
namespace {

TEST(NpyFile, NumpyReadsWhatWasWritten) {
  if (!HasNumpy()) GTEST_SKIP() << "python3 has no numpy";
  const SequenceFolder folder;
  Image<float> depth(3, 2);
  depth(2, 1) = 1.5f;
  depth(1, 0) = 1e-7f;
  Image<Vec3f> normals(3, 2);
  normals(0, 1) = {1, -2, 3};
  WriteNpy(folder / "depth.npy", depth);
  WriteNpy(folder / "normals.npy", normals);
  EXPECT_TRUE(Numpy(R"(
d = np.load('depth.npy')
assert d.shape == (2, 3) and d.dtype == np.float32, d
assert d[1, 2] == 1.5 and d[0, 1] == np.float32(1e-7) and d.sum() == np.float32(1.5) + np.float32(1e-7)
n = np.load('normals.npy')
assert n.shape == (2, 3, 3) and (n[1, 0] == [1, -2, 3]).all() and np.abs(n).sum() == 6
)",
                    folder.path().string()));
  EXPECT_FALSE(Numpy("assert np.load('depth.npy')[0, 0] == 1", folder.path().string()));
}

TEST(NpyFile, IsReadAsItWasWrittenAndNotOtherwise) {
  const SequenceFolder folder;
  Image<Vec3f> colors(3, 2);
  colors(0, 1) = {1, -2, 1e-30f};
  WriteNpy(folder / "a.npy", colors);
  EXPECT_EQ(Norm(ReadNpy(folder / "a.npy", 3, 2)(0, 1) - colors(0, 1)), 0);
  EXPECT_THROW(ReadNpy(folder / "a.npy", 2, 3), Error);
  EXPECT_THROW(ReadNpy(folder / "none.npy", 3, 2), Error);
  const std::string good = ReadText(folder / "a.npy");
  for (const std::string& bad : {good + "x", good.substr(0, good.size() - 1), std::string()}) {
    std::ofstream(folder / "a.npy", std::ios::binary) << bad;
    EXPECT_THROW(ReadNpy(folder / "a.npy", 3, 2), Error) << bad.size();
  }
  WriteNpy(folder / "a.npy", Image<float>(3, 2));
  EXPECT_THROW(ReadNpy(folder / "a.npy", 3, 2), Error);
}

// As the format asks: readers may map the data.
TEST(NpyFile, DataBeginAtAMultipleOf64Bytes) {
  const SequenceFolder folder;
  for (const int width : {1, 10, 100, 1000, 10000}) {
    WriteNpy(folder / "a.npy", Image<float>(width, 1));
    EXPECT_EQ((ReadText(folder / "a.npy").size() - 4 * std::size_t(width)) % 64, 0u) << width;
  }
}

}  // namespace
}  // namespace silt
