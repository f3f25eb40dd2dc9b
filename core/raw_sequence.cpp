// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/raw_sequence.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

constexpr char kMagic[] = "SILTRAW1";
constexpr std::uint32_t kLargestSide = 65535;

struct Header {
  char magic[8] = {};
  std::uint32_t width = 0, height = 0, colors = 3, depths = 0;
  double time_s = 0;
  double camera[4] = {};  // fx fy cx cy
  double pose[7] = {};    // tx ty tz qx qy qz qw
  double reserved = 0;
};
static_assert(sizeof(Header) == 128);

Header HeaderOf(const RawFrame& raw) {
  Header header;
  std::memcpy(header.magic, kMagic, sizeof header.magic);
  header.width = std::uint32_t(raw.frame.rgb.width());
  header.height = std::uint32_t(raw.frame.rgb.height());
  header.depths = raw.frame.depth_m.empty() ? 0 : 1;
  header.time_s = raw.frame.time_s;
  const double camera[] = {raw.camera.fx, raw.camera.fy, raw.camera.cx, raw.camera.cy};
  const auto& [q, t] = raw.world_from_camera;
  const double pose[] = {t.x, t.y, t.z, q.x, q.y, q.z, q.w};
  std::memcpy(header.camera, camera, sizeof camera);
  std::memcpy(header.pose, pose, sizeof pose);
  return header;
}

bool AllFinite(const Header& header) {
  bool finite = std::isfinite(header.time_s);
  for (const double v : header.camera) finite = finite && std::isfinite(v);
  for (const double v : header.pose) finite = finite && std::isfinite(v);
  return finite;
}

std::size_t BodySize(const Header& header) {
  return std::size_t(header.width) * header.height * (3 + 4 * header.depths);
}

Header ReadHeader(std::istream& in, const fs::path& file) {
  Header header;
  in.read(reinterpret_cast<char*>(&header), sizeof header);
  if (!in || std::memcmp(header.magic, kMagic, sizeof header.magic) != 0) {
    throw Error(file.string() + ": is not a frame of silt's raw layout");
  }
  const bool sized = header.width >= 1 && header.height >= 1 && header.width <= kLargestSide &&
                     header.height <= kLargestSide && header.colors == 3 && header.depths <= 1;
  const bool sound = sized && AllFinite(header) && header.camera[0] > 0 && header.camera[1] > 0;
  const double* p = header.pose;
  const double norm = std::sqrt(p[3] * p[3] + p[4] * p[4] + p[5] * p[5] + p[6] * p[6]);
  if (!sound || std::abs(norm - 1) > 1e-6) throw Error(file.string() + ": its header is damaged");
  if (fs::file_size(file) != sizeof header + BodySize(header)) {
    throw Error(file.string() + ": its size is not that which its header tells");
  }
  return header;
}

std::ifstream Open(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !fs::is_regular_file(file)) throw Error(file.string() + ": cannot be read");
  return in;
}

RawFrame WithoutImages(const Header& h) {
  RawFrame raw;
  raw.camera = {h.camera[0], h.camera[1], h.camera[2], h.camera[3], int(h.width), int(h.height)};
  raw.world_from_camera = {{h.pose[6], h.pose[3], h.pose[4], h.pose[5]},
                           {h.pose[0], h.pose[1], h.pose[2]}};
  raw.frame.time_s = h.time_s;
  return raw;
}

bool SameCamera(const PinholeCamera& a, const PinholeCamera& b) {
  return a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

void WriteRawFrame(const fs::path& file, const RawFrame& raw) {
  const Image<Rgb8>& rgb = raw.frame.rgb;
  const Image<float>& depth_m = raw.frame.depth_m;
  SILT_CHECK(!rgb.empty());
  SILT_CHECK(depth_m.empty() ||
             (depth_m.width() == rgb.width() && depth_m.height() == rgb.height()));
  const Header header = HeaderOf(raw);
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.append(reinterpret_cast<const char*>(rgb.data()), rgb.size() * sizeof(Rgb8));
  bytes.append(reinterpret_cast<const char*>(depth_m.data()), depth_m.size() * sizeof(float));
  WriteFileAtomically(file, bytes);
}

RawFrame ReadRawFrame(const fs::path& file) {
  std::ifstream in = Open(file);
  const Header header = ReadHeader(in, file);
  RawFrame raw = WithoutImages(header);
  Image<Rgb8>& rgb = raw.frame.rgb = Image<Rgb8>(raw.camera.width, raw.camera.height);
  in.read(reinterpret_cast<char*>(rgb.data()), std::streamsize(rgb.size() * sizeof(Rgb8)));
  if (header.depths == 1) {
    Image<float>& depth_m = raw.frame.depth_m = Image<float>(raw.camera.width, raw.camera.height);
    in.read(reinterpret_cast<char*>(depth_m.data()),
            std::streamsize(depth_m.size() * sizeof(float)));
  }
  if (!in) throw Error(file.string() + ": ends early");
  return raw;
}

RawSequence::RawSequence(const fs::path& folder) {
  const fs::path list = folder / "frames.txt";
  std::ifstream in = Open(list);
  for (std::string name; std::getline(in, name);) {
    if (name.empty() || name[0] == '#') continue;
    const fs::path file = folder / name;
    std::ifstream frame = Open(file);
    const RawFrame raw = WithoutImages(ReadHeader(frame, file));
    if (files_.empty()) camera_ = raw.camera;
    if (!SameCamera(raw.camera, camera_)) {
      throw Error(file.string() + ": its camera differs from that of the frames before");
    }
    if (!truth_.empty() && raw.frame.time_s <= truth_.back().time_s) {
      throw Error(file.string() + ": its time is not later than that of the frame before");
    }
    files_.push_back(file);
    truth_.push_back({raw.frame.time_s, raw.world_from_camera});
  }
  if (files_.empty()) throw Error(list.string() + ": lists no frame");
}

std::optional<Frame> RawSequence::Next() {
  if (next_ == files_.size()) return std::nullopt;
  return ReadRawFrame(files_[next_++]).frame;
}

std::vector<double> RawSequence::times_s() const {
  std::vector<double> times;
  for (const StampedPose& pose : truth_) times.push_back(pose.time_s);
  return times;
}

}  // namespace silt
