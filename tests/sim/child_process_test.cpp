// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/child_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

namespace silt::sim {
namespace {

using Event = ChildProcess::Event;
using testing::HasSubstr;

constexpr std::size_t kLongest = 1 << 24;

TEST(ChildProcess, HandsMessagesOverWhole) {
  const std::string large(3'000'000, 'x');
  ChildProcess child([&](const ChildProcess::Send& send) {
    send("first");
    send("");
    send(large);
  });
  std::string message;
  ASSERT_EQ(child.Receive(20, kLongest, message), Event::kMessage);
  EXPECT_EQ(message, "first");
  ASSERT_EQ(child.Receive(20, kLongest, message), Event::kMessage);
  EXPECT_EQ(message, "");
  ASSERT_EQ(child.Receive(20, kLongest, message), Event::kMessage);
  EXPECT_EQ(message, large);
  EXPECT_EQ(child.Receive(20, kLongest, message), Event::kEnd);
  EXPECT_EQ(child.Wait(), "");
}

TEST(ChildProcess, TellsHowItEnded) {
  const auto end_of = [](void (*job)()) {
    ChildProcess child([job](const ChildProcess::Send&) { job(); });
    std::string message;
    EXPECT_EQ(child.Receive(20, kLongest, message), Event::kEnd);
    return child.Wait();
  };
  EXPECT_EQ(end_of([] {}), "");
  EXPECT_THAT(end_of([] { raise(SIGSEGV); }), HasSubstr("crashed (Segmentation fault)"));
  EXPECT_THAT(end_of([] { std::abort(); }), HasSubstr("crashed (Aborted)"));
  EXPECT_EQ(end_of([] { throw 3; }), "failed");
}

TEST(ChildProcess, ItsMemoryIsItsOwn) {
  int value = 1;
  ChildProcess child([&](const ChildProcess::Send& send) {
    value = 2;
    send(std::to_string(value));
  });
  std::string message;
  ASSERT_EQ(child.Receive(20, kLongest, message), Event::kMessage);
  EXPECT_EQ(message, "2");
  EXPECT_EQ(value, 1);
}

TEST(ChildProcess, MayBeWaitedForInVainAndIsKilledThen) {
  std::string message;
  const auto start = std::chrono::steady_clock::now();
  {
    ChildProcess child([](const ChildProcess::Send&) { pause(); });
    EXPECT_EQ(child.Receive(0.05, kLongest, message), Event::kTimeout);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // nothing is left to wait for
}

// A child that was started meanwhile must not keep the end of another's messages from being seen.
TEST(ChildProcess, HoldsNoPipeButItsOwn) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  {
    ChildProcess child([](const ChildProcess::Send& send) {
      send("started");
      pause();
    });
    std::string message;
    ASSERT_EQ(child.Receive(20, kLongest, message), Event::kMessage);
    close(pipe_ends[1]);
    char byte;
    fcntl(pipe_ends[0], F_SETFL, O_NONBLOCK);
    EXPECT_EQ(read(pipe_ends[0], &byte, 1), 0);  // the end, not "nothing yet"
  }
  close(pipe_ends[0]);
}

TEST(ChildProcess, EndsWhereAMessageIsTooLongOrBroken) {
  ChildProcess chatty([](const ChildProcess::Send& send) { send(std::string(100, 'x')); });
  std::string message;
  EXPECT_EQ(chatty.Receive(20, 99, message), Event::kEnd);
  ChildProcess dying([](const ChildProcess::Send& send) {
    send("whole");
    // The message is longer than the pipe; the child is gone before anybody has read it.
    alarm(1);
    send(std::string(8'000'000, 'x'));
  });
  EXPECT_EQ(dying.Receive(20, kLongest, message), Event::kMessage);
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_EQ(dying.Receive(20, kLongest, message), Event::kEnd);
  EXPECT_THAT(dying.Wait(), HasSubstr("Alarm"));
}

TEST(ChildProcess, TakesNoMoreMemoryThanItMay) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers want their address space";
#endif
  ChildProcess hungry(
      [](const ChildProcess::Send& send) {
        try {
          std::vector<char> much(std::size_t(1) << 30, 'x');
          send(std::to_string(much[much.size() / 2]));
        } catch (const std::bad_alloc&) {
          send("refused");
        }
      },
      std::size_t(200) << 20);
  std::string message;
  ASSERT_EQ(hungry.Receive(20, kLongest, message), Event::kMessage);
  EXPECT_EQ(message, "refused");
}

}  // namespace
}  // namespace silt::sim
