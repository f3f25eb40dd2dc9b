// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/depth_sensor.h"

#include <cmath>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/khoshelham_depth.h"
#include "silt/sim/kinect_depth.h"
#include "silt/sim/nguyen_depth.h"

namespace silt::sim {

namespace {

class PerfectDepth : public DepthSensor {
 public:
  Image<float> Measure(const DepthView& view, const NoiseKey&) const override {
    return view.truth.depth_m;
  }
};

// Perfect depth as TUM's 16-bit PNG files hold it: nothing beyond 13.1 m.
class StoredDepth : public DepthSensor {
 public:
  Image<float> Measure(const DepthView& view, const NoiseKey&) const override {
    constexpr double steps_per_metre = 5000, most_steps = 65535;
    Image<float> stored_m = view.truth.depth_m;
    for (float& z : stored_m) {
      const double steps = std::round(double(z) * steps_per_metre);
      z = steps <= most_steps ? float(steps / steps_per_metre) : 0;
    }
    return stored_m;
  }
};

class WithDropouts : public DepthSensor {
 public:
  WithDropouts(std::shared_ptr<const DepthSensor> sensor, const DepthDropouts& dropouts)
      : sensor_(std::move(sensor)), dropouts_(dropouts) {}
  Image<float> Measure(const DepthView& view, const NoiseKey& key) const override {
    Image<float> measured_m = sensor_->Measure(view, key);
    DropOut(dropouts_, view, measured_m);
    return measured_m;
  }

 private:
  std::shared_ptr<const DepthSensor> sensor_;
  DepthDropouts dropouts_;
};

std::shared_ptr<const DepthSensor> MakeModel(const std::string& model) {
  if (model == "perfect") return std::make_shared<PerfectDepth>();
  if (model == "png16") return std::make_shared<StoredDepth>();
  if (model == "kinect") return std::make_shared<KinectDepth>(KinectDepth::Rounding::kFloor);
  if (model == "kinect-legacy")
    return std::make_shared<KinectDepth>(KinectDepth::Rounding::kNearest);
  if (model == "khoshelham") return std::make_shared<KhoshelhamDepth>();
  if (model == "nguyen") return std::make_shared<NguyenDepth>();
  std::string known;
  for (const std::string& one : DepthSensorModels()) known += (known.empty() ? "" : ", ") + one;
  throw Error("depth sensor: " + Quoted(model) + " is none of: " + known);
}

}  // namespace

const std::vector<std::string>& DepthSensorModels() {
  static const std::vector<std::string> models{"perfect",       "png16",      "kinect",
                                               "kinect-legacy", "khoshelham", "nguyen"};
  return models;
}

void DepthSensorOptions::Validate() const {
  MakeModel(model);
  dropouts.Validate();
}

std::shared_ptr<const DepthSensor> MakeDepthSensor(const DepthSensorOptions& options) {
  options.Validate();
  std::shared_ptr<const DepthSensor> sensor = MakeModel(options.model);
  if (options.dropouts.AreNone()) return sensor;
  return std::make_shared<WithDropouts>(std::move(sensor), options.dropouts);
}

}  // namespace silt::sim
