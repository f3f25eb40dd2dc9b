// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/emva_noise.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/poisson.h"

namespace silt::sim {

namespace {

// One pixel's way from light to digital numbers.
class Pixel {
 public:
  Pixel(const EmvaNoise& model, const NoiseKey& key)
      : model_(model),
        electrons_at_white_(model.quantum_efficiency * model.PhotonsAtWhite()),
        gain_(model.Gain()),
        shot_(NoiseStream(key, NoiseUse::kShot)),
        read_(NoiseStream(key, NoiseUse::kRead)),
        response_(NoiseStream({key.seed, 0}, NoiseUse::kPhotoResponse)),
        dark_(NoiseStream({key.seed, 0}, NoiseUse::kDark)) {}

  float Measure(float signal, std::uint64_t index) const {
    const double mean = MeanElectrons(signal > 0 ? double(signal) : 0, index);
    // Ten wells of electrons fill one for certain.
    const double electrons = std::min(
        Poisson(shot_, index, std::min(mean, 10 * model_.full_well_e)), model_.full_well_e);
    const double read = model_.read_noise_e * read_.Normal(index) + DarkOffset(index);
    const double dn = std::round(gain_ * (electrons + read) + model_.black_dn);
    const double zero = model_.black_dn + gain_ * model_.DarkElectrons();
    return float((std::clamp(dn, 0.0, model_.MaxDn()) - zero) / (model_.MaxDn() - model_.black_dn));
  }

 private:
  double MeanElectrons(double light, std::uint64_t index) const {
    const double sensitivity =
        model_.prnu > 0 ? std::max(0.0, 1 + model_.prnu * response_.Normal(index)) : 1;
    return electrons_at_white_ * light * sensitivity + model_.DarkElectrons();
  }
  double DarkOffset(std::uint64_t index) const {
    return model_.dsnu_e > 0 ? model_.dsnu_e * dark_.Normal(index) : 0;
  }

  const EmvaNoise& model_;
  double electrons_at_white_, gain_;
  CounterRandom shot_, read_, response_, dark_;
};

}  // namespace

void EmvaNoise::Validate() const {
  const auto require = [](double value, double low, double high, const char* what) {
    if (value >= low && value <= high) return;
    throw Error(std::string("emva noise: ") + what);
  };
  require(quantum_efficiency, 1e-6, 1, "the quantum efficiency must be above 0 and at most 1");
  require(full_well_e, 1, 1e9, "the full well must hold 1 to 1e9 electrons");
  require(read_noise_e, 0, 1e6, "the read noise must be from 0 to 1e6 electrons");
  require(dark_current_e_per_s, 0, 1e9, "the dark current must be from 0 to 1e9 electrons/s");
  require(exposure_s, 0, 1e6, "the exposure must be from 0 to 1e6 s");
  require(photons_at_white, 0, 1e12, "photons at white must be from 0 (fill the well) to 1e12");
  require(gain_dn_per_e, 0, 1e9, "the gain must be from 0 (fitting) to 1e9 DN per electron");
  require(bits, 1, 16, "the converter must have 1 to 16 bits");
  require(black_dn, 0, MaxDn() - 1, "the black level must be from 0 to below the largest number");
  require(prnu, 0, 1, "PRNU must be from 0 to 1");
  require(dsnu_e, 0, 1e6, "DSNU must be from 0 to 1e6 electrons");
}

double EmvaNoise::PhotonsAtWhite() const {
  return photons_at_white > 0 ? photons_at_white : full_well_e / quantum_efficiency;
}

double EmvaNoise::Gain() const {
  if (gain_dn_per_e > 0) return gain_dn_per_e;
  const double white_e = std::min(full_well_e, quantum_efficiency * PhotonsAtWhite());
  return (MaxDn() - black_dn) / white_e;
}

double EmvaNoise::Variance(double signal) const {
  const double gain = Gain(), range_dn = MaxDn() - black_dn;
  const double electrons = quantum_efficiency * PhotonsAtWhite() * signal + DarkElectrons();
  return (gain * gain * (read_noise_e * read_noise_e + electrons) + 1.0 / 12) /
         (range_dn * range_dn);
}

void AddNoise(const EmvaNoise& model, const NoiseKey& key, Image<Vec3f>& signal) {
  const Pixel pixel(model, key);
  ParallelFor(signal.height(), [&](int y) {
    std::uint64_t index = 3 * std::uint64_t(y) * std::uint64_t(signal.width());
    for (int x = 0; x < signal.width(); ++x, index += 3) {
      Vec3f& value = signal(x, y);
      value = {pixel.Measure(value.x, index), pixel.Measure(value.y, index + 1),
               pixel.Measure(value.z, index + 2)};
    }
  });
}

}  // namespace silt::sim
