// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/sim/scene.h"

namespace silt::sim {

// The surfaces that shine, and the picture of the environment: what a path can aim at. (A constant
// ambient is not among them: it is found best by reflection.) Each rectangular light is an emitter,
// drawn from evenly as it is seen; other surfaces of one material are one, whose area is drawn from
// evenly; the environment is the last.
class Emitters {
 public:
  explicit Emitters(const Scene& scene);

  // A place that light may leave from, and where it arrives.
  struct Receiver {
    Vec3f position, normal;
    bool aims_at_each = false;  // at every emitter, by DrawFrom; else at one of them, by Draw
  };

  struct Sample {
    Vec3f direction;     // towards the light, unit
    float distance = 0;  // 1e30 to the environment
    Vec3f radiance;      // that leaves the light towards the receiver
    float density = 0;   // per steradian; 0: nothing was drawn
  };
  // The first number chooses the emitter, by an estimate of what it sends without obstacles.
  Sample Draw(const Receiver& at, float choice, const Vec2f& random) const;

  std::size_t count() const { return emitters_.size() + 1; }
  Sample DrawFrom(std::size_t emitter, const Receiver& at, float choice, const Vec2f& random) const;

  // The density with which the receiver finds the point of a triangle that a ray has met, at
  // `distance` and with the cosine at the triangle; 0 where it is no emitter.
  struct Met {
    std::uint32_t triangle;
    float distance, cosine;
  };
  float Density(const Receiver& from, const Met& met) const;
  float BackgroundDensity(const Receiver& from, const Vec3f& direction) const;

 private:
  struct Emitter {
    Vec3f center, normal;  // the mean ones
    bool one_sided_plane = false;
    double power = 0;  // mean luminance × area
    double area = 0;
    const RectLight* rectangle = nullptr;  // all that it is
    std::vector<std::uint32_t> triangles;
    std::vector<double> area_up_to;  // cumulative
  };

  void AddTriangle(Emitter& emitter, std::uint32_t triangle) const;
  void Finish(Emitter& emitter) const;
  // In proportion to the chance of being chosen. The environment is the last.
  double Weight(std::size_t emitter, const Receiver& at) const;
  double TotalWeight(const Receiver& at) const;
  // With which it is chosen; 1 where all are.
  double Chance(std::size_t emitter, const Receiver& at) const;
  Sample DrawFromRectangle(const Emitter& emitter, const Receiver& at, const Vec2f& random) const;
  Sample DrawFromTriangles(const Emitter& emitter, const Receiver& at, float choice,
                           const Vec2f& random) const;

  const Scene& scene_;
  std::vector<Emitter> emitters_;
  std::vector<int> of_triangle_;  // index into emitters_, −1: does not shine
  double background_ = 0;         // π × mean luminance
};

}  // namespace silt::sim
