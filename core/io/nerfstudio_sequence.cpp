// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/nerfstudio_sequence.h"

#include <cstdio>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

constexpr double kDepthPerMetre = 1000;

// R·diag(1, −1, −1) turns the camera's y down, z forward into OpenGL's y up, z backwards.
std::string TransformMatrix(const SE3d& world_from_camera) {
  const Mat3d r = world_from_camera.rotation.Matrix();
  const Vec3d& t = world_from_camera.translation;
  const double position[3] = {t.x, t.y, t.z};
  std::string text = "[";
  for (int i = 0; i < 3; ++i) {
    char row[160];
    std::snprintf(row, sizeof row, "[%.12g, %.12g, %.12g, %.12g], ", r.row[i].x, -r.row[i].y,
                  -r.row[i].z, position[i]);
    text += row;
  }
  return text + "[0, 0, 0, 1]]";
}

}  // namespace

NerfstudioSequenceWriter::NerfstudioSequenceWriter(fs::path folder, SequenceDescription description)
    : folder_(std::move(folder)), description_(std::move(description)) {}

std::vector<fs::path> NerfstudioSequenceWriter::FrameFiles(int number) const {
  const std::string name = FrameName(number, ".png");
  return {fs::path("images") / name, fs::path("depth") / name};
}

std::vector<fs::path> NerfstudioSequenceWriter::SequenceFiles() const {
  return {"transforms.json"};
}

void NerfstudioSequenceWriter::Write(int number, const Frame& frame) {
  const std::vector<fs::path> files = FrameFiles(number);
  WriteRgb(folder_ / files[0], frame.rgb);
  WriteDepth(folder_ / files[1], frame.depth_m, kDepthPerMetre);
}

void NerfstudioSequenceWriter::Finish() {
  const PinholeCamera& c = description_.camera;
  const LensDistortion& lens = description_.lens;
  char head[640];
  std::snprintf(head, sizeof head,
                "{\n  \"camera_model\": \"OPENCV\",\n  \"fl_x\": %.12g, \"fl_y\": %.12g,\n"
                "  \"cx\": %.12g, \"cy\": %.12g,\n  \"w\": %d, \"h\": %d,\n"
                "  \"k1\": %.12g, \"k2\": %.12g, \"k3\": %.12g, \"p1\": %.12g, \"p2\": %.12g,\n  "
                "\"frames\": [",
                c.fx, c.fy, c.cx + 0.5, c.cy + 0.5, c.width, c.height, lens.k1, lens.k2, lens.k3,
                lens.p1, lens.p2);
  std::string text = head;
  for (std::size_t i = 0; i < description_.truth.size(); ++i) {
    const StampedPose& pose = description_.truth[i];
    const std::vector<fs::path> files = FrameFiles(int(i));
    char time[64];
    std::snprintf(time, sizeof time, "\"time\": %.9f,\n     ", pose.time_s);
    text += std::string(i == 0 ? "\n" : ",\n") + "    {\"file_path\": \"" + files[0].string() +
            "\", \"depth_file_path\": \"" + files[1].string() + "\", " + time +
            "\"transform_matrix\": " + TransformMatrix(pose.world_from_camera) + "}";
  }
  WriteFileAtomically(folder_ / "transforms.json", text + "\n  ]\n}\n");
}

}  // namespace silt
