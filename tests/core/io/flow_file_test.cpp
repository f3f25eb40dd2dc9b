// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/flow_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "numpy.h"
#include "posed_image.h"

namespace silt {
namespace {

Image<Vec2f> SomeFlow() {
  Image<Vec2f> flow(3, 2);
  flow(2, 0) = {1.25f, -7};
  flow(0, 1) = {1e10f, 1e10f};
  return flow;
}

TEST(FlowFile, BeginsAsMiddleburysDoes) {
  const SequenceFolder folder;
  WriteFlow(folder / "a.flo", SomeFlow());
  const std::string bytes = ReadText(folder / "a.flo");
  ASSERT_EQ(bytes.size(), 12u + 3 * 2 * 8);
  float tag = 0;
  std::memcpy(&tag, bytes.data(), sizeof tag);
  EXPECT_EQ(tag, 202021.25f);
}

TEST(FlowFile, NumpyReadsWhatWasWritten) {
  if (!HasNumpy()) GTEST_SKIP() << "python3 has no numpy";
  const SequenceFolder folder;
  WriteFlow(folder / "a.flo", SomeFlow());
  EXPECT_TRUE(Numpy(R"(
width, height = np.fromfile('a.flo', '<i4', 2, offset=4)
flow = np.fromfile('a.flo', '<f4', offset=12).reshape(height, width, 2)
assert flow.shape == (2, 3, 2) and (flow[0, 2] == [1.25, -7]).all()
assert (flow[1, 0] > 1e9).all() and (flow[1, 1:] == 0).all()
)",
                    folder.path().string()));
}

}  // namespace
}  // namespace silt
