// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/tracker/alignment.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/image_content.h"
#include "silt/tracker/options.h"

namespace silt::tracker {

// The best first. A doubtful pose is taken, though nothing is built on it; a lost frame has none.
enum class TrackingStatus { kTracked, kDoubtful, kLost };

// "tracked", "doubtful", "lost".
const char* Name(TrackingStatus status);

// What an alignment tells of its own worth.
struct PoseEvidence {
  double overlap = 0;               // of the reference's measured pixels, at the finest level
  double unexplained_variance = 0;  // mean square of the residuals per variance of the intensity
  double depth_disagreement = 0;    // scale of the depths' residuals per mean; 0: not compared
  double inlier_ratio = 0;          // of the residuals: those that noise and sampling can explain
  double uncertainty_rad = 0;       // largest deviation of the pose, seen from the mean distance
};

// Of an alignment that is ok, with the first of its references.
PoseEvidence EvidenceOf(const Backend& backend, const ReferenceViews& references,
                        const CurrentPyramid& current, const AlignmentResult& alignment,
                        const ImageContent& content);

struct Judgement {
  TrackingStatus status = TrackingStatus::kLost;
  std::string message;  // one line unless tracked: "lost: …", "doubtful: …"
};

Judgement Judge(const PoseEvidence& evidence, const TrustOptions& options);

// How far the evidence reaches to what makes it doubtful, as the largest of the ratios: above 1
// where it does. Of two doubtful poses, the one with less is to be preferred.
double Doubt(const PoseEvidence& evidence, const TrustOptions& options);
// The same of how well the aligned images agree alone, which tells of a pose that is wrong; overlap
// and uncertainty tell of images that determine little, wherever an alignment starts.
double Disagreement(const PoseEvidence& evidence, const TrustOptions& options);

}  // namespace silt::tracker
