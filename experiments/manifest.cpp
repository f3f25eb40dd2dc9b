// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/manifest.h"

#include <Eigen/Core>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/build_info.h"
#include "silt/sim/embree_adapter.h"
#include "silt/tracker/simd_level.h"

#ifdef SILT_HAVE_CUDA
#include "silt/cuda/devices.h"
#endif

namespace silt::experiments {
namespace {

std::string ProcessorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t colon = line.find(": ");
    if (colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string CudaFacts() {
  if (!kHasCuda) return "not compiled in";
#ifdef SILT_HAVE_CUDA
  try {
    std::string devices;
    for (const cuda::Device& device : cuda::DeviceList()) devices += ", " + device.name;
    const std::string why_not = cuda::WhyNoUsableDevice();
    return "compiled in" + (devices.empty() ? ", no device" : devices) +
           (why_not.empty() ? "" : " (" + why_not + ")");
  } catch (const Error& error) {
    return std::string("compiled in, ") + error.what();
  }
#endif
  return "compiled in";
}

std::string DateUtc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string EigenVersion() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

}  // namespace

Json BuildFacts() {
  return {{"version", kVersion},
          {"commit", Commit()},
          {"compiler", kCompiler},
          {"flags", kCompilerFlags},
          {"processor", ProcessorName()},
          {"threads", ThreadCount()},
          {"simd", tracker::Name(tracker::BestSimdLevel())},
          {"cuda", CudaFacts()},
          {"libraries",
           {{"Embree", sim::EmbreeAdapter::Version()},
            {"OpenCV", cv::getVersionString()},
            {"Eigen", EigenVersion()}}}};
}

Json MakeManifest(const std::string& command_line, const Json& config, std::uint64_t seed) {
  Json manifest{{"program", "silt"}, {"command", command_line}, {"date_utc", DateUtc()}};
  manifest["seed"] = seed;
  manifest["config"] = config;
  manifest.update(BuildFacts());
  return manifest;
}

}  // namespace silt::experiments
