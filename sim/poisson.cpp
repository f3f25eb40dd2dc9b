// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/poisson.h"

#include <cmath>

namespace silt::sim {

namespace {

constexpr double kSmallMean = 10;
constexpr int kDraws = 64;
constexpr double kFactorials[] = {1, 1, 2, 6, 24, 120, 720, 5040, 40320, 362880};

// By inversion: the first k whose cumulative probability passes a uniform number.
double SmallPoisson(double uniform, double mean) {
  double probability = std::exp(-mean), cumulative = probability;
  int k = 0;
  while (uniform >= cumulative && k < 200) {
    probability *= mean / ++k;
    cumulative += probability;
  }
  return k;
}

// log k!, by Stirling's series to 1e-10 from 10 on.
double LogFactorial(double k) {
  if (k < 10) return std::log(kFactorials[int(k)]);
  const double r = 1 / k, r2 = r * r;
  return k * std::log(k) - k + 0.5 * std::log(2 * M_PI * k) +
         r * (1.0 / 12 - r2 * (1.0 / 360 - r2 / 1260));
}

// Transformed rejection, algorithm PTRS of W. Hörmann, "The transformed rejection method for
// generating Poisson random variables", 1993; for means of 10 and more it accepts at least 87 %
// of its proposals.
class TransformedRejection {
 public:
  explicit TransformedRejection(double mean)
      : mean_(mean),
        b_(0.931 + 2.53 * std::sqrt(mean)),
        a_(-0.059 + 0.02483 * b_),
        inverse_alpha_(1.1239 + 1.1328 / (b_ - 3.4)),
        v_r_(0.9277 - 3.6224 / (b_ - 2)) {}

  // Whether the proposal made of two uniform numbers is accepted; it is then `k`.
  bool Propose(double uniform_u, double v, double& k) const {
    const double u = uniform_u - 0.5, us = 0.5 - std::abs(u);
    k = std::floor((2 * a_ / us + b_) * u + mean_ + 0.43);
    if (us >= 0.07 && v <= v_r_) return true;
    if (k < 0 || (us < 0.013 && v > us)) return false;
    return std::log(v * inverse_alpha_ / (a_ / (us * us) + b_)) <=
           k * std::log(mean_) - mean_ - LogFactorial(k);
  }

 private:
  double mean_, b_, a_, inverse_alpha_, v_r_;
};

}  // namespace

double Poisson(const CounterRandom& random, std::uint64_t index, double mean) {
  if (!(mean > 0)) return 0;
  const std::uint64_t first = kDraws * index;
  if (mean < kSmallMean) return SmallPoisson(random.Uniform(first), mean);
  const TransformedRejection proposals(mean);
  double k = 0;
  for (int i = 0; i < kDraws; i += 2) {
    if (proposals.Propose(random.Uniform(first + i), random.Uniform(first + i + 1), k)) return k;
  }
  return std::round(mean);  // once in 10^28
}

}  // namespace silt::sim
