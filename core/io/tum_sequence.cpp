// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/tum_sequence.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/io/icl_camera.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

const char* const kLists[] = {"camera.txt", "rgb.txt", "depth.txt", "associations.txt",
                              "groundtruth.txt"};

[[noreturn]] void FailAt(const fs::path& file, int line, const std::string& what) {
  throw Error(file.string() + ":" + std::to_string(line) + ": " + what);
}

struct ListLine {
  int number;
  std::vector<std::string> words;
};

std::vector<ListLine> ReadList(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(file.string() + ": no such list; a TUM sequence needs it");
  std::vector<ListLine> lines;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    std::istringstream words(text);
    ListLine line{number, {}};
    for (std::string word; words >> word;) line.words.push_back(word);
    if (!line.words.empty() && line.words[0][0] != '#') lines.push_back(std::move(line));
  }
  return lines;
}

double ParseNumber(const std::string& word, const fs::path& file, int line) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) FailAt(file, line, Quoted(word) + " is not a number");
  return value;
}

// The time of a list's line, which must be later than the one before.
double ParseTime(const ListLine& line, const fs::path& list, double before_s) {
  const double time_s = ParseNumber(line.words[0], list, line.number);
  if (time_s <= before_s) FailAt(list, line.number, "time does not increase");
  return time_s;
}

std::vector<TumEntry> ReadAssociations(const fs::path& folder, const fs::path& file) {
  std::vector<TumEntry> entries;
  double time_s = -std::numeric_limits<double>::infinity();
  for (const ListLine& line : ReadList(file)) {
    if (line.words.size() != 4) FailAt(file, line.number, "expected: time rgb time depth");
    time_s = ParseTime(line, file, time_s);
    ParseNumber(line.words[2], file, line.number);
    entries.push_back({time_s, folder / line.words[1], folder / line.words[3]});
  }
  return entries;
}

struct StampedFile {
  double time_s;
  fs::path file;
};

std::vector<StampedFile> ReadStampedFiles(const fs::path& folder, const fs::path& list) {
  std::vector<StampedFile> files;
  double time_s = -std::numeric_limits<double>::infinity();
  for (const ListLine& line : ReadList(list)) {
    if (line.words.size() != 2) FailAt(list, line.number, "expected: time file");
    time_s = ParseTime(line, list, time_s);
    files.push_back({time_s, folder / line.words[1]});
  }
  return files;
}

// The nearest depth image in time for each colour image; none beyond the tolerance.
std::vector<TumEntry> Associate(const std::vector<StampedFile>& colors,
                                const std::vector<StampedFile>& depths, double tolerance_s) {
  std::vector<TumEntry> entries;
  for (const StampedFile& color : colors) {
    TumEntry entry{color.time_s, color.file, {}};
    double nearest_s = tolerance_s;
    for (const StampedFile& depth : depths) {
      if (std::abs(depth.time_s - color.time_s) > nearest_s) continue;
      nearest_s = std::abs(depth.time_s - color.time_s);
      entry.depth = depth.file;
    }
    entries.push_back(entry);
  }
  return entries;
}

std::vector<TumEntry> ReadEntries(const fs::path& folder, const TumSequenceOptions& options) {
  const fs::path associations = folder / "associations.txt";
  if (fs::exists(associations)) return ReadAssociations(folder, associations);
  return Associate(ReadStampedFiles(folder, folder / "rgb.txt"),
                   ReadStampedFiles(folder, folder / "depth.txt"), options.association_tolerance_s);
}

PinholeCamera ReadCamera(const fs::path& file) {
  std::vector<ListLine> lines;
  if (fs::exists(file)) lines = ReadList(file);
  if (lines.size() == 1 && lines[0].words.size() == 11) {
    FailAt(file, lines[0].number, "the lens has distortion; undistort the images first");
  }
  if (lines.size() != 1 || lines[0].words.size() != 6) {
    throw Error(file.string() + ": expected one line 'fx fy cx cy width height'");
  }
  double v[6];
  for (int i = 0; i < 6; ++i) v[i] = ParseNumber(lines[0].words[i], file, lines[0].number);
  if (v[0] <= 0 || v[1] <= 0) FailAt(file, lines[0].number, "fx and fy must be positive");
  for (double size : {v[4], v[5]}) {
    if (size < 1 || size > 65535 || size != std::floor(size)) {
      FailAt(file, lines[0].number, "width and height must be whole, from 1 to 65535");
    }
  }
  return {v[0], v[1], v[2], v[3], int(v[4]), int(v[5])};
}

void RemoveLists(const fs::path& folder) {
  for (const char* list : kLists) {
    std::error_code error;
    fs::remove(folder / list, error);
    if (error) throw Error((folder / list).string() + ": cannot be removed: " + error.message());
  }
}

}  // namespace

TumSequenceWriter::TumSequenceWriter(fs::path folder, SequenceDescription description)
    : folder_(std::move(folder)), description_(std::move(description)) {}

std::vector<fs::path> TumSequenceWriter::FrameFiles(int number) const {
  const std::string name = FrameName(number, ".png");
  return {fs::path("rgb") / name, fs::path("depth") / name};
}

std::vector<fs::path> TumSequenceWriter::SequenceFiles() const {
  return {std::begin(kLists), std::end(kLists)};
}

void TumSequenceWriter::Write(int number, const Frame& frame) {
  if (!begun_) RemoveLists(folder_);
  begun_ = true;
  const std::vector<fs::path> files = FrameFiles(number);
  WriteRgb(folder_ / files[0], frame.rgb);
  WriteDepth(folder_ / files[1], frame.depth_m);
}

void TumSequenceWriter::Finish() {
  std::string rgb = "# time_s file\n", depth = rgb, both = "# time_s rgb time_s depth\n";
  for (std::size_t i = 0; i < description_.truth.size(); ++i) {
    char time[32];
    std::snprintf(time, sizeof time, "%.9f", description_.truth[i].time_s);
    const std::vector<fs::path> files = FrameFiles(int(i));
    const std::string rgb_line = std::string(time) + " " + files[0].string();
    const std::string depth_line = std::string(time) + " " + files[1].string();
    rgb += rgb_line + "\n";
    depth += depth_line + "\n";
    both += rgb_line + " " + depth_line + "\n";
  }
  const PinholeCamera& c = description_.camera;
  const LensDistortion& lens = description_.lens;
  char camera[256];
  std::snprintf(camera, sizeof camera, "%.9g %.9g %.9g %.9g %d %d", c.fx, c.fy, c.cx, c.cy, c.width,
                c.height);
  char distortion[160] = "";
  if (!lens.IsNone()) {
    std::snprintf(distortion, sizeof distortion, " %.9g %.9g %.9g %.9g %.9g", lens.k1, lens.k2,
                  lens.p1, lens.p2, lens.k3);
  }
  WriteFileAtomically(
      folder_ / "camera.txt",
      std::string("# fx fy cx cy width height [k1 k2 p1 p2 k3]\n") + camera + distortion + "\n");
  WriteFileAtomically(folder_ / "rgb.txt", rgb);
  WriteFileAtomically(folder_ / "depth.txt", depth);
  WriteFileAtomically(folder_ / "associations.txt", both);
  WriteTumTrajectory(folder_ / "groundtruth.txt", description_.truth);
}

TumSequence::TumSequence(const fs::path& folder, const TumSequenceOptions& options,
                         const PinholeCamera& camera)
    : options_(options), camera_(camera) {
  SILT_CHECK(options.take_every >= 1);
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": no such sequence folder");
  if (camera_.fx == 0) camera_ = ReadCamera(folder / "camera.txt");
  const std::vector<TumEntry> all = ReadEntries(folder, options);
  for (std::size_t i = 0; i < all.size(); i += std::size_t(options.take_every)) {
    entries_.push_back(all[i]);
  }
  if (entries_.empty()) throw Error(folder.string() + ": the sequence lists no image");
  if (camera_.width == 0) {
    const Image<Rgb8> first = ReadRgb(entries_.front().rgb);
    camera_.width = first.width();
    camera_.height = first.height();
  }
  if (fs::exists(folder / "groundtruth.txt")) {
    truth_ = ReadTumTrajectory(folder / "groundtruth.txt");
  }
  if (camera_.fy > 0) return;
  camera_.fy = -camera_.fy;
  for (StampedPose& pose : truth_) pose.world_from_camera = SiltFromIcl(pose.world_from_camera);
}

std::vector<double> TumSequence::times_s() const {
  std::vector<double> times;
  for (const TumEntry& entry : entries_) times.push_back(entry.time_s);
  return times;
}

std::optional<Frame> TumSequence::Next() {
  if (next_ == entries_.size()) return std::nullopt;
  const TumEntry& entry = entries_[next_++];
  Frame frame{entry.time_s, ReadRgb(entry.rgb), {}};
  if (!entry.depth.empty()) frame.depth_m = ReadDepth(entry.depth, options_.depth_per_metre);
  const auto fits = [&](const auto& image) {
    return image.width() == camera_.width && image.height() == camera_.height;
  };
  if (!fits(frame.rgb)) throw Error(entry.rgb.string() + ": size differs from the camera's");
  if (!frame.depth_m.empty() && !fits(frame.depth_m)) {
    throw Error(entry.depth.string() + ": size differs from the camera's");
  }
  return frame;
}

}  // namespace silt
