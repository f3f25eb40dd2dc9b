// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/euroc_sequence.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailAt(const fs::path& file, int line, const std::string& what) {
  throw Error(file.string() + ":" + std::to_string(line) + ": " + what);
}

std::ifstream Open(const fs::path& file) {
  std::ifstream in(file);
  if (!in || !fs::is_regular_file(file)) throw Error(file.string() + ": cannot be read");
  return in;
}

std::string Trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

struct Row {
  int line;
  double time_s;
  std::vector<std::string> cells;
};

// Nanoseconds since 1970 do not fit into a double: whole seconds and the rest apart.
double Seconds(const std::string& word, const fs::path& file, int line) {
  long long ns = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), ns);
  if (error != std::errc() || end != word.data() + word.size() || ns < 0) {
    FailAt(file, line, Quoted(word) + " is no time in nanoseconds");
  }
  return double(ns / 1'000'000'000) + double(ns % 1'000'000'000) * 1e-9;
}

std::vector<Row> ReadCsv(const fs::path& file, std::size_t columns) {
  std::ifstream in = Open(file);
  std::vector<Row> rows;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (Trimmed(text).empty() || text[0] == '#') continue;
    Row row{line, 0, {}};
    std::istringstream cells(text);
    for (std::string cell; std::getline(cells, cell, ',');) row.cells.push_back(Trimmed(cell));
    if (row.cells.size() < columns) {
      FailAt(file, line, "expected " + std::to_string(columns) + " columns");
    }
    row.time_s = Seconds(row.cells[0], file, line);
    if (!rows.empty() && row.time_s <= rows.back().time_s) {
      FailAt(file, line, "time does not increase");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

double Number(const std::string& word, const fs::path& file, int line) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) {
    FailAt(file, line, Quoted(word) + " is not a number");
  }
  return value;
}

// The numbers of "key: [1, 2, …]" in a sensor.yaml, which may take several lines.
std::vector<double> YamlNumbers(const fs::path& file, const std::string& key, std::size_t count) {
  std::ostringstream whole;
  whole << Open(file).rdbuf();
  const std::string text = "\n" + whole.str();
  const std::size_t at = text.find(key + ":");
  const std::size_t first = text.find('[', at), last = text.find(']', at);
  std::vector<double> numbers;
  if (at != text.npos && first != text.npos && last != text.npos && first < last) {
    std::istringstream list(text.substr(first + 1, last - first - 1));
    for (std::string word; std::getline(list, word, ',');) {
      std::replace(word.begin(), word.end(), '\n', ' ');
      numbers.push_back(Number(Trimmed(word), file, 1));
    }
  }
  if (numbers.size() != count) {
    throw Error(file.string() + ": needs " + key + ": [" + std::to_string(count) + " numbers]");
  }
  return numbers;
}

PinholeCamera ReadCamera(const fs::path& file) {
  const std::vector<double> f = YamlNumbers(file, "intrinsics", 4);
  const std::vector<double> size = YamlNumbers(file, "resolution", 2);
  if (f[0] <= 0 || f[1] <= 0) throw Error(file.string() + ": focal lengths must be positive");
  for (const double side : size) {
    if (side < 1 || side > 65535 || side != std::floor(side)) {
      throw Error(file.string() + ": resolution must be whole, from 1 to 65535");
    }
  }
  for (const double k : YamlNumbers(file, "distortion_coefficients", 4)) {
    if (k != 0) {
      throw Error(file.string() + ": the lens has distortion; undistort the images first");
    }
  }
  return {f[0], f[1], f[2], f[3], int(size[0]), int(size[1])};
}

SE3d ReadBodyFromCamera(const fs::path& file) {
  const std::vector<double> m = YamlNumbers(file, "data", 16);
  const Mat3d rotation{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
  const Mat3d square = Transposed(rotation) * rotation;
  for (int i = 0; i < 3; ++i) {
    const double length[] = {square.row[i].x, square.row[i].y, square.row[i].z};
    for (int j = 0; j < 3; ++j) {
      if (std::abs(length[j] - (i == j)) > 1e-3) {
        throw Error(file.string() + ": T_BS is no rigid motion");
      }
    }
  }
  return {QuaternionFromMatrix(rotation), {m[3], m[7], m[11]}};
}

Trajectory ReadStates(const fs::path& file, const SE3d& body_from_camera) {
  Trajectory truth;
  for (const Row& row : ReadCsv(file, 8)) {
    double v[8];
    for (std::size_t i = 1; i < 8; ++i) v[i] = Number(row.cells[i], file, row.line);
    const Quaterniond q{v[4], v[5], v[6], v[7]};
    if (std::abs(std::sqrt(q.w * q.w + Dot(q.vec(), q.vec())) - 1) > 1e-2) {
      FailAt(file, row.line, "the quaternion is not of norm 1");
    }
    const SE3d world_from_body{q.Normalized(), {v[1], v[2], v[3]}};
    truth.push_back({row.time_s, world_from_body * body_from_camera});
  }
  return truth;
}

}  // namespace

EurocSequence::EurocSequence(const fs::path& folder) : mav_(folder / "mav0") {
  const fs::path sensor = mav_ / "cam0/sensor.yaml", list = mav_ / "cam0/data.csv";
  camera_ = ReadCamera(sensor);
  for (const Row& row : ReadCsv(list, 2)) images_.push_back({row.time_s, row.cells[1]});
  if (images_.empty()) throw Error(list.string() + ": lists no image");
  const fs::path states = mav_ / "state_groundtruth_estimate0/data.csv";
  if (fs::exists(states)) truth_ = ReadStates(states, ReadBodyFromCamera(sensor));
}

std::optional<Frame> EurocSequence::Next() {
  if (next_ == images_.size()) return std::nullopt;
  const StampedImage& image = images_[next_++];
  const fs::path file = mav_ / "cam0/data" / image.name, depth = mav_ / "depth0/data" / image.name;
  Frame frame{image.time_s, ReadRgb(file), {}};
  if (frame.rgb.width() != camera_.width || frame.rgb.height() != camera_.height) {
    throw Error(file.string() + ": its size differs from the camera's");
  }
  if (!fs::exists(depth)) return frame;
  frame.depth_m = ReadDepth(depth);
  if (frame.depth_m.width() != camera_.width || frame.depth_m.height() != camera_.height) {
    throw Error(depth.string() + ": its size differs from the camera's");
  }
  return frame;
}

std::vector<double> EurocSequence::times_s() const {
  std::vector<double> times;
  for (const StampedImage& image : images_) times.push_back(image.time_s);
  return times;
}

}  // namespace silt
