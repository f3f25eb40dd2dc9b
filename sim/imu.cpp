// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/imu.h"

#include <cmath>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt::sim {
namespace {

enum Stream : std::uint64_t {
  kGyroNoise = 0x494d5500,
  kGyroWalk,
  kAccelerometerNoise,
  kAccelerometerWalk
};

// Three independent standard normal numbers for reading k.
Vec3d Normals(std::uint64_t seed, Stream stream, std::uint64_t k) {
  const CounterRandom random(seed, stream);
  return {random.Normal(3 * k), random.Normal(3 * k + 1), random.Normal(3 * k + 2)};
}

// Biases and noise of reading after reading.
class Disturbance {
 public:
  explicit Disturbance(const ImuOptions& options) : options_(options) {}

  // From reading k to k + 1.
  void Step() {
    const double root = std::sqrt(options_.rate_hz);
    ++k_;
    gyro_bias_ += options_.noise.gyro_walk / root * Normals(options_.seed, kGyroWalk, k_);
    accelerometer_bias_ +=
        options_.noise.accelerometer_walk / root * Normals(options_.seed, kAccelerometerWalk, k_);
  }

  void AddTo(ImuSample& sample) const {
    const double root = std::sqrt(options_.rate_hz);
    sample.truth.gyro_bias = gyro_bias_;
    sample.truth.accelerometer_bias = accelerometer_bias_;
    sample.angular_velocity +=
        gyro_bias_ + options_.noise.gyro_density * root * Normals(options_.seed, kGyroNoise, k_);
    sample.acceleration +=
        accelerometer_bias_ + options_.noise.accelerometer_density * root *
                                  Normals(options_.seed, kAccelerometerNoise, k_);
  }

  std::uint64_t k() const { return k_; }

 private:
  const ImuOptions& options_;
  std::uint64_t k_ = 0;
  Vec3d gyro_bias_, accelerometer_bias_;
};

ImuSample IdealReading(const CameraPath& path, const Vec3d& gravity, double time_s) {
  const CameraMotion motion = path.Motion(time_s);
  const Quaterniond camera_from_world = motion.world_from_camera.rotation.Conjugate();
  ImuSample sample;
  sample.time_s = time_s;
  sample.truth.world_from_imu = motion.world_from_camera;
  sample.truth.velocity = motion.velocity;
  sample.angular_velocity = motion.angular_velocity;
  sample.acceleration = camera_from_world * (motion.acceleration - gravity);
  return sample;
}

}  // namespace

void ImuOptions::Validate() const {
  if (!(rate_hz >= 1 && rate_hz <= 1e5)) throw Error("the IMU's rate must be 1 to 100000 Hz");
  for (const double value : {noise.gyro_density, noise.gyro_walk, noise.accelerometer_density,
                             noise.accelerometer_walk}) {
    if (!(value >= 0 && std::isfinite(value))) throw Error("the IMU's noise must be 0 or more");
  }
  if (!std::isfinite(Norm(gravity))) throw Error("gravity must be finite");
}

ImuRecording RecordImu(const CameraPath& path, const ImuOptions& options, double start_s,
                       double duration_s) {
  options.Validate();
  // One more instant than the frames of the same rate: a reading at the end.
  std::vector<double> times = FrameTimes(options.rate_hz, start_s, duration_s);
  if (start_s + duration_s > path.duration_s() + 1e-6) {
    throw Error("the IMU's recording leaves the camera path, which lasts " +
                std::to_string(path.duration_s()) + " s");
  }
  const auto first = std::uint64_t(std::llround(times.front() * options.rate_hz));
  const double after_s = double(first + times.size()) / options.rate_hz;
  if (after_s < start_s + duration_s + 1e-9) times.push_back(after_s);

  ImuRecording recording{options.rate_hz, options.noise, {}};
  Disturbance disturbance(options);
  while (disturbance.k() < first) disturbance.Step();
  for (const double time_s : times) {
    ImuSample sample = IdealReading(path, options.gravity, time_s);
    disturbance.AddTo(sample);
    recording.samples.push_back(sample);
    disturbance.Step();
  }
  return recording;
}

}  // namespace silt::sim
