// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/raw_sequence_writer.h"

#include <gtest/gtest.h>

#include "numpy.h"
#include "posed_image.h"
#include "silt/core/raw_sequence.h"

namespace silt {
namespace {

PosedImage ReadFrame(const std::filesystem::path& file) {
  const RawFrame raw = ReadRawFrame(file);
  return {GrayFromRgb(raw.frame.rgb),
          raw.frame.depth_m,
          raw.camera.fx,
          raw.camera.fy,
          raw.camera.cx,
          raw.camera.cy,
          1,
          raw.world_from_camera.rotation.Matrix(),
          raw.world_from_camera.translation};
}

class RawSequenceWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    const SequenceDescription description = BoxDescription(4);
    RawSequenceWriter writer(folder_.path(), description);
    WriteBox(writer, description);
  }
  SequenceFolder folder_;
};

TEST_F(RawSequenceWriterTest, PicturesAreConsistent) {
  const PosedImage from = ReadFrame(folder_ / "frames/000000.raw"),
                   to = ReadFrame(folder_ / "frames/000003.raw");
  const double right = WarpError(from, to);
  EXPECT_LT(right, 0.6);
  EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
  EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
  EXPECT_GT(WarpError(WithDepthMistaken(from, -1), WithDepthMistaken(to, -1)), 3 * right);
}

// With numpy alone: the same warp, nearest pixel, from what the header's offsets hold.
TEST_F(RawSequenceWriterTest, NumpyWarpsOneFrameOntoAnother) {
  if (!HasNumpy()) GTEST_SKIP() << "python3 has no numpy";
  EXPECT_TRUE(Numpy(R"(
head = np.dtype([('magic', 'S8'), ('width', '<u4'), ('height', '<u4'), ('colors', '<u4'),
                 ('depths', '<u4'), ('time', '<f8'), ('camera', '<f8', 4), ('t', '<f8', 3),
                 ('q', '<f8', 4), ('zero', '<f8')])
assert head.itemsize == 128
def load(name):
    h = np.fromfile(name, head, 1)[0]
    n = int(h['width']) * int(h['height'])
    rgb = np.fromfile(name, 'u1', 3 * n, offset=128).reshape(h['height'], h['width'], 3)
    z = np.fromfile(name, '<f4', n, offset=128 + 3 * n).reshape(h['height'], h['width'])
    x, y, z_, w = h['q']
    R = np.array([[1 - 2 * (y * y + z_ * z_), 2 * (x * y - w * z_), 2 * (x * z_ + w * y)],
                  [2 * (x * y + w * z_), 1 - 2 * (x * x + z_ * z_), 2 * (y * z_ - w * x)],
                  [2 * (x * z_ - w * y), 2 * (y * z_ + w * x), 1 - 2 * (x * x + y * y)]])
    return h, rgb[:, :, 0].astype(float), z.astype(float), R
names = open('frames.txt').read().split()
assert len(names) == 4
(h, a, z, Ra), (g, b, _, Rb) = load(names[0]), load(names[3])
fx, fy, cx, cy = h['camera']
v, u = np.mgrid[0:h['height'], 0:h['width']]
p = np.stack([(u - cx) / fx * z, (v - cy) / fy * z, z], -1)
q = ((p @ Ra.T + h['t']) - g['t']) @ Rb
x, y = np.rint(fx * q[..., 0] / q[..., 2] + cx).astype(int), np.rint(fy * q[..., 1] / q[..., 2] + cy).astype(int)
inside = (x >= 0) & (y >= 0) & (x < h['width']) & (y < h['height']) & (q[..., 2] > 0)
error = np.abs(a[inside] - b[y[inside], x[inside]]).mean()
identity = np.abs(a - b).mean()
assert inside.mean() > 0.5 and error < 2 and identity > 10 * error, (inside.mean(), error, identity)
assert abs(g['time'] - 0.3) < 1e-12
)",
                    folder_.path().string()));
}

}  // namespace
}  // namespace silt
