// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/color.h"
#include "silt/core/image.h"
#include "silt/core/memory_pool.h"
#include "silt/core/se3.h"
#include "silt/tracker/levenberg_marquardt.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/options.h"
#include "silt/tracker/residual_norm.h"

namespace silt::tracker {

struct PyramidLevel {
  PinholeCamera camera;
  int measured_pixels = 0;  // with a depth; a level may have none, or be empty
};

using PyramidLevels = PooledVector<PyramidLevel>;

// What a backend keeps of a keyframe: its intensity and depth at every level, level 0 the finest.
// Immutable. Each backend derives its own and takes no other's.
class ReferencePyramid {
 public:
  virtual ~ReferencePyramid() = default;
  // Where images lie elsewhere, whoever looks first may have to wait for what was counted there.
  virtual const PyramidLevels& levels() const = 0;
};

// The same of the current image, whose depth may be missing.
class CurrentPyramid {
 public:
  virtual ~CurrentPyramid() = default;
  bool has_depth() const { return has_depth_; }

 protected:
  bool has_depth_ = false;
};

// The two images of one alignment.
struct ImagePair {
  const ReferencePyramid& reference;
  const CurrentPyramid& current;
};

// Images that are made for one purpose.
struct OwnedPair {
  std::unique_ptr<const ReferencePyramid> reference;
  std::unique_ptr<const CurrentPyramid> current;
  ImagePair images() const { return {*reference, *current}; }
};

// A keyframe and where it stands: the pose that is sought is current_from_anchor, and the camera of
// the reference sees a point of the anchor's frame through anchor_from_reference⁻¹.
struct ReferenceView {
  const ReferencePyramid& pyramid;
  SE3d anchor_from_reference;
  double edge_contrast = 0;  // see ImageContent; 0: not known
};

using ReferenceViews = PooledVector<ReferenceView>;

// An alignment that comes before another one, to start it, or after it, to refine it.
struct AlignmentStage {
  AlignmentPlan plan;
  ImagePair images;
  bool exclude_hidden = false;
};

// A whole alignment, for backends that can run it by themselves.
struct AlignmentJob {
  AlignmentPlan plan;
  ReferenceViews references;
  const CurrentPyramid& current;
  bool exclude_hidden = false;
  SE3d initial;
  // At the end, the residuals of the first reference's pixels, hidden ones too, at a level of which
  // 0 is the finest, with this norm; −1: they are not asked for.
  int judged_level = -1;
  ResidualNorm judged_norm;
  // Come first, each from where the one before it has ended, the first from `initial`. The job
  // starts from their end, if none fails and IsMoreAlike says so of that and `initial`, by the
  // finest level of `compared`, which is there where they are; else from `initial`.
  PooledVector<AlignmentStage> first;
  std::optional<ImagePair> compared;
  // Comes last, from where the job has ended, unless that has failed.
  std::optional<AlignmentStage> last;
};

using AlignmentJobs = PooledVector<AlignmentJob>;

struct FinishedAlignment {
  LevenbergMarquardt optimizer;    // wants nothing any more
  NormalEquations::Spread judged;  // of the intensity; zeros where it has failed
  std::optional<SE3d> coarse;      // the end of the stages that came first, if it started there
  std::optional<LevenbergMarquardt> last;  // of the stage that came last, if one did
  // That all the jobs it was run with took together, by the clock of the device that ran them.
  double batch_ms = 0;
};

// Runs since it was made.
class DeviceClock {
 public:
  virtual ~DeviceClock() = default;
  // What the device has taken for all that it was asked for since, for whose end this waits.
  virtual double Milliseconds() = 0;
};

// Reductions over pixels; knows no vision beyond tracker/kernel. Every sum has the same bits in
// every run and for any number of threads, and both reductions give the same cost.
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string name() const = 0;

  // Throws silt::Error naming an option that this backend does not have, or how many keyframes it
  // aligns with at once.
  virtual void CheckHas(const AlignmentOptions&, int /*joint*/ = 1) const {}

  // Intensity in [0, 1] and depth in metres, both of the camera's size.
  virtual std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>& intensity,
                                                          const Image<float>& depth_m,
                                                          const PinholeCamera& camera,
                                                          const PyramidOptions& options) const = 0;
  // Without a depth (an empty image) it has no edges to leave out.
  virtual std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>& intensity,
                                                      const Image<float>& depth_m,
                                                      const PyramidOptions& options) const = 0;

  // The same of colour images, as the gray images of GrayFromRgb would give it.
  virtual std::unique_ptr<ReferencePyramid> MakeReferenceOfColour(
      const Image<Rgb8>& rgb, const Image<float>& depth_m, const PinholeCamera& camera,
      const PyramidOptions& options) const {
    return MakeReference(GrayFromRgb(rgb), depth_m, camera, options);
  }
  virtual std::unique_ptr<CurrentPyramid> MakeCurrentOfColour(const Image<Rgb8>& rgb,
                                                              const Image<float>& depth_m,
                                                              const PyramidOptions& options) const {
    return MakeCurrent(GrayFromRgb(rgb), depth_m, options);
  }
  // A keyframe of an image that was current, with its depth, which it may not have had before, for
  // the same options; nothing where that is no less work than making it anew.
  virtual std::unique_ptr<ReferencePyramid> MakeReferenceOfCurrent(const CurrentPyramid&,
                                                                   const Image<float>& /*depth_m*/,
                                                                   const PinholeCamera&,
                                                                   const PyramidOptions&) const {
    return nullptr;
  }

  // Whether it makes smaller pictures of those that it holds; and the pyramids of both images of a
  // pair, halved so many times, with all that was measured of the keyframe's depth and, if asked
  // for, of the current one's where there is one.
  virtual bool halves_what_it_holds() const { return false; }
  virtual OwnedPair MakeHalved(const ImagePair&, int /*halvings*/, bool /*with_depth*/,
                               const PyramidOptions&) const {
    return {};
  }

  // The keyframe as the current camera sees it: its pixels whose points are hidden there have no
  // depth. Where the current image has a depth, that tells what is hidden, and the result serves
  // `level` alone; else the keyframe's own does (see visibility.h), and it serves all finer levels
  // too.
  virtual std::unique_ptr<ReferencePyramid> WithoutHidden(
      const ImagePair& pair, int level, const SE3d& current_from_reference) const = 0;

  // Residuals alone: warp, eq. 2, cost.
  virtual PhotometricCost Cost(const ImagePair& pair, int level,
                               const SE3d& current_from_reference) const = 0;
  // At several poses; a backend whose images lie elsewhere is waited for once.
  virtual std::vector<PhotometricCost> Costs(const ImagePair& pair, int level,
                                             const std::vector<SE3d>& poses) const {
    std::vector<PhotometricCost> costs;
    for (const SE3d& pose : poses) costs.push_back(Cost(pair, level, pose));
    return costs;
  }
  // Residuals and Jacobians: eqs. 13–17.
  virtual NormalEquations Linearize(const ImagePair& pair, int level,
                                    const SE3d& current_from_reference,
                                    const ResidualNorm& norm = {}) const = 0;

  // The jobs' ends, in their order, of a backend that decides what comes next where the images lie
  // and runs any number of alignments at once. Nothing where it cannot, or has not learnt how to
  // run one of them: the caller then goes step by step.
  virtual std::vector<FinishedAlignment> Run(const AlignmentJobs&) const { return {}; }
  // Whether it does so at all.
  virtual bool runs_alignments() const { return false; }

  // Nothing where the work is the host's, by whose clock it is known.
  virtual std::unique_ptr<DeviceClock> StartClock() const { return nullptr; }
};

}  // namespace silt::tracker
