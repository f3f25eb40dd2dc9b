// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/group_rounds.h"

#include <gtest/gtest.h>

#include <vector>

#include "silt/cuda/block/block_backend.h"
#include "silt/tracker/alignment.h"
#include "threaded_machine.h"
#include "wavy_wall.h"

namespace silt::cuda {
namespace {

// Every block writes what it has read of its neighbour in the round before; the first one adds up
// what all have written and tells the round. Plain memory, which only the meetings protect.
struct PassOn {
  struct Shared {};
  static constexpr int kRounds = 300;
  struct Group {
    int round = 0;
    std::vector<int> value, sums;
  };
  std::vector<Group>* groups;

  Group& Of(const GroupPlace& place) const { return (*groups)[std::size_t(place.group)]; }
  bool Finished(const GroupPlace& place) const { return Of(place).round > kRounds; }
  int WorkPhases(const GroupPlace&) const { return 1; }
  int DecidePhases(const GroupPlace&) const { return 1; }
  void Work(int, const GroupPlace& place, Shared&) const {
    if (place.thread != 0) return;
    Group& group = Of(place);
    const int even = group.round % 2 * place.blocks, odd = place.blocks - even;
    const int neighbour = (place.block + 1) % place.blocks;
    group.value[std::size_t(even + place.block)] = group.value[std::size_t(odd + neighbour)] + 1;
  }
  void Decide(int, int, const GroupPlace& place, Shared&) const {
    if (place.thread != 0) return;
    Group& group = Of(place);
    int sum = 0;
    for (int i = 0; i < place.blocks; ++i) {
      sum += group.value[std::size_t(group.round % 2 * place.blocks + i)];
    }
    group.sums.push_back(sum);
    ++group.round;
  }
};

template <int kGroups, int kBlocks>
void ExpectAllMeet() {
  std::vector<PassOn::Group> groups(kGroups);
  for (PassOn::Group& group : groups) group.value.assign(2 * kBlocks, 0);
  ThreadedMachine<kGroups * kBlocks>().RunGroups(kGroups, kBlocks, PassOn{&groups}, nullptr);
  for (const PassOn::Group& group : groups) {
    ASSERT_EQ(group.sums.size(), std::size_t(PassOn::kRounds) + 1);
    for (int round = 0; round <= PassOn::kRounds; ++round) {
      ASSERT_EQ(group.sums[std::size_t(round)], round * kBlocks);
    }
  }
}

TEST(GroupRounds, BlocksMeetInEveryRound) {
  ExpectAllMeet<1, 1>();
  ExpectAllMeet<1, 4>();
  ExpectAllMeet<3, 2>();
}

bool Same(const tracker::AlignmentResult& a, const tracker::AlignmentResult& b) {
  const SE3d &p = a.current_from_reference, &q = b.current_from_reference;
  return a.ok == b.ok && a.covariance == b.covariance && p.rotation.w == q.rotation.w &&
         p.rotation.x == q.rotation.x && p.translation.x == q.translation.x &&
         p.translation.y == q.translation.y && p.translation.z == q.translation.z;
}

// Whole alignments by blocks that run at once, one and several a group, against one block after the
// other.
template <int kBlocks>
void ExpectSameAlignments(const tracker::AlignmentOptions& options, bool with_depth) {
  const BlockBackend<ThreadedMachine<kBlocks>> threaded("threaded", ThreadedMachine<kBlocks>());
  const auto emulated = MakeEmulatedBackend();
  const Pair here = MakePair(threaded, options.Pyramids(), with_depth);
  const Pair there = MakePair(*emulated, options.Pyramids(), with_depth);
  std::vector<tracker::AlignmentStart> ours, wanted;
  for (int i = 0; i < 5; ++i) {
    const SE3d initial = SE3d::Exp(0.3 * i * kPose.Log());
    ours.push_back({*here.reference, *here.current, initial});
    wanted.push_back({*there.reference, *there.current, initial});
  }
  for (const std::size_t count : {std::size_t(1), std::size_t(2), ours.size()}) {
    const std::vector<tracker::AlignmentStart> some(ours.begin(), ours.begin() + long(count));
    const auto results = tracker::AlignBatch(threaded, some, options);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(results[i].ok);
      EXPECT_TRUE(
          Same(results[i], tracker::Align(*emulated, {wanted[i].reference, wanted[i].current},
                                          wanted[i].initial, options)));
    }
  }
}

TEST(GroupRounds, BlocksThatRunAtOnceAlignAsThoseInTurn) {
  for (tracker::AlignmentOptions options :
       {tracker::PaperPreset().alignment, tracker::FastPreset().alignment}) {
    options.max_iterations = {1, 2, 2, 4};
    ExpectSameAlignments<2>(options, true);
    ExpectSameAlignments<4>(options, options.use_current_depth);
  }
}

}  // namespace
}  // namespace silt::cuda
