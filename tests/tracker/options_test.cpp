// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/options.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(TrackerOptions, PaperPresetIsThePapers) {
  const TrackerOptions paper = PaperPreset();
  EXPECT_EQ(paper.alignment.max_iterations, (std::vector<int>{2, 5, 20, 20}));
  EXPECT_EQ(paper.alignment.initial_damping, 1e-3);
  EXPECT_EQ(paper.alignment.damping_factor, 10);
  EXPECT_EQ(paper.keyframes.max_distance_m, 0.13);
  EXPECT_EQ(paper.keyframes.max_rotation_deg, 30);
  EXPECT_NO_THROW(paper.Validate());
}

TEST(TrackerOptions, OnlyAllPixelsTakesHiddenOnes) {
  EXPECT_TRUE(PaperPreset().alignment.exclude_hidden);
  EXPECT_FALSE(PaperAllPixelsPreset().alignment.exclude_hidden);
}

struct BadOption {
  const char* name;
  std::function<void(TrackerOptions*)> spoil;
  const char* message;
};

void PrintTo(const BadOption& bad, std::ostream* out) { *out << bad.name; }

class BadOptions : public testing::TestWithParam<BadOption> {};

TEST_P(BadOptions, AreNamedWithTheirRange) {
  TrackerOptions options;
  GetParam().spoil(&options);
  try {
    options.Validate();
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(GetParam().message), Not(HasSubstr("\n"))));
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    TrackerOptions, BadOptions,
    testing::Values(
        BadOption{"no_level", [](TrackerOptions* o) { o->alignment.max_iterations.clear(); },
                  "alignment.max_iterations (number of pyramid levels) is 0; give a number from 1"},
        BadOption{"negative_iterations",
                  [](TrackerOptions* o) { o->alignment.max_iterations[1] = -3; },
                  "alignment.max_iterations is -3; give a number from 0 to 100000"},
        BadOption{"damping", [](TrackerOptions* o) { o->alignment.initial_damping = -1; },
                  "alignment.initial_damping is -1"},
        BadOption{"damping_factor", [](TrackerOptions* o) { o->alignment.damping_factor = 0.5; },
                  "alignment.damping_factor is 0.5; give a number from 1 to 1000000"},
        BadOption{"coarser", [](TrackerOptions* o) { o->alignment.coarser_update_norm = 0.5; },
                  "alignment.coarser_update_norm is 0.5"},
        BadOption{"rounds", [](TrackerOptions* o) { o->alignment.scale_rounds = -1; },
                  "alignment.scale_rounds is -1"},
        BadOption{"update_norm", [](TrackerOptions* o) { o->alignment.min_update_norm = kNan; },
                  "alignment.min_update_norm is nan"},
        BadOption{"overlap", [](TrackerOptions* o) { o->alignment.min_overlap = 1.5; },
                  "alignment.min_overlap is 1.5; give a number from 0 to 1"},
        BadOption{"distance", [](TrackerOptions* o) { o->keyframes.max_distance_m = -0.13; },
                  "keyframes.max_distance_m is -0.13"},
        BadOption{"rotation", [](TrackerOptions* o) { o->keyframes.max_rotation_deg = 1e9; },
                  "keyframes.max_rotation_deg is 1000000000; give a number from 0 to 540"},
        BadOption{"depth", [](TrackerOptions* o) { o->keyframes.min_measured_depth = 2; },
                  "keyframes.min_measured_depth is 2"},
        BadOption{"depth_disagreement",
                  [](TrackerOptions* o) { o->trust.max_depth_disagreement = -1; },
                  "trust.max_depth_disagreement is -1"},
        BadOption{"margin", [](TrackerOptions* o) { o->alignment.depth_edge_margin_px = -1; },
                  "alignment.depth_edge_margin_px is -1"},
        BadOption{"scale", [](TrackerOptions* o) { o->alignment.robust_scale = kNan; },
                  "alignment.robust_scale (0: squares) is nan"},
        BadOption{"small_scale", [](TrackerOptions* o) { o->alignment.robust_scale = 0.01; },
                  "alignment.robust_scale (0: squares) is 0.01; give a number from 0.1 to 1000000"},
        BadOption{"depth_residual", [](TrackerOptions* o) { o->alignment.depth_residual = true; },
                  "alignment.depth_residual needs use_current_depth"},
        BadOption{"brightness", [](TrackerOptions* o) { o->alignment.affine_brightness = true; },
                  "alignment.affine_brightness needs robust_scale"},
        BadOption{"keyframe_overlap", [](TrackerOptions* o) { o->keyframes.min_overlap = 1.5; },
                  "keyframes.min_overlap is 1.5; give a number from 0 to 1"},
        BadOption{"patch", [](TrackerOptions* o) { o->alignment.depth_patch_px = 0; },
                  "alignment.depth_patch_px is 0; give a number from 1 to 100"},
        BadOption{"disagreement", [](TrackerOptions* o) { o->alignment.max_disagreement = -1; },
                  "alignment.max_disagreement is -1"},
        BadOption{"stale", [](TrackerOptions* o) { o->keyframes.stale_share = 2; },
                  "keyframes.stale_share is 2; give a number from 0 to 1"},
        BadOption{"polish", [](TrackerOptions* o) { o->keyframes.polish_iterations = -1; },
                  "keyframes.polish_iterations is -1"},
        BadOption{"joint", [](TrackerOptions* o) { o->keyframes.joint = 0; },
                  "keyframes.joint is 0; give a number from 1 to 100"},
        BadOption{"variance", [](TrackerOptions* o) { o->trust.max_unexplained_variance = -1; },
                  "trust.max_unexplained_variance is -1"}),
    [](const auto& p) { return std::string(p.param.name); });

// Of what cannot be told nothing is doubted.
TEST(TrackerOptions, ColoursAreDoubtedWhereEdgesTellThatTheyAreNotRegistered) {
  AlignmentOptions options = FastPreset().alignment;
  EXPECT_TRUE(options.DoubtsColours(1));
  EXPECT_FALSE(options.DoubtsColours(2));
  EXPECT_FALSE(options.DoubtsColours(0));
  options.registered_contrast = 0;
  EXPECT_TRUE(options.DoubtsColours(2));
  EXPECT_TRUE(options.DoubtsColours(0));
  options.max_disagreement = 0;
  EXPECT_FALSE(options.DoubtsColours(1));
}

}  // namespace
}  // namespace silt::tracker
