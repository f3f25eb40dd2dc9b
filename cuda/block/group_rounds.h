// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/block.h"

// How the blocks of a group go through the rounds of a body such as AlignBody, meeting between
// them. `Block` is what runs one of them: a block of a GPU's threads, or a thread of the host that
// takes the part of them all. It offers
//
//   using Counter;                             // what blocks meet by, 0 at first
//   void Each(function);                       // of the number of every thread
//   void Meet();                               // the threads of the block
//   void Raise(Counter&);                      // by one; all that the block wrote before is seen
//   void WaitUntil(const Counter&, unsigned);  // by who has waited and then meets its threads
namespace silt::cuda {

// Both numbers only grow.
template <typename Counter>
struct GroupBarrier {
  Counter arrived{};   // blocks other than the first, over all rounds
  Counter released{};  // decisions that the first has made
};

// The first block's: waits until the work of `round` rounds is done by all others, decides, and
// lets them go on.
template <typename Body, typename Block>
SILT_HOST_DEVICE void DecideRound(const Body& body, GroupPlace place, unsigned round,
                                  GroupBarrier<typename Block::Counter>& barrier,
                                  typename Body::Shared& shared, Block& block) {
  if (place.blocks > 1) block.WaitUntil(barrier.arrived, round * unsigned(place.blocks - 1));
  block.Meet();
  const int phases = body.DecidePhases(place);
  for (int phase = 0; phase < phases; ++phase) {
    block.Meet();
    block.Each([&](int thread) {
      place.thread = thread;
      body.Decide(phase, phases, place, shared);
    });
  }
  block.Meet();
  if (place.blocks > 1) block.Raise(barrier.released);
}

// From the first round to the last; `place` is of the block's first thread. All blocks of a group
// must run at once.
template <typename Body, typename Block>
SILT_HOST_DEVICE void RunRounds(const Body& body, GroupPlace place,
                                GroupBarrier<typename Block::Counter>& barrier,
                                typename Body::Shared& shared, Block& block) {
  for (unsigned round = 0;; ++round) {
    if (place.block == 0) {
      DecideRound(body, place, round, barrier, shared, block);
    } else {
      block.Meet();
      if (round > 0) block.Raise(barrier.arrived);
      block.WaitUntil(barrier.released, round + 1);
      block.Meet();
    }
    if (body.Finished(place)) return;
    const int phases = body.WorkPhases(place);
    for (int phase = 0; phase < phases; ++phase) {
      if (phase > 0) block.Meet();
      block.Each([&](int thread) {
        place.thread = thread;
        body.Work(phase, place, shared);
      });
    }
  }
}

}  // namespace silt::cuda
