// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>

namespace silt::sim {

// A copy of this process that does one job and cannot harm the original: its crash, its hunger for
// memory and its endless loops end with it. It has the calling thread alone, so the job must not
// use ParallelFor, and no open files; what it prints goes nowhere.
//
// A fork, not another program: libraries of silt have no program of their own to start, and a fork
// sees archives that are open already. Of the locks that other threads may hold at that moment, the
// C library hands over its own in order (malloc, stdio); the job must not need others'.
class ChildProcess {
 public:
  // Sends a message to the parent; both ends keep messages whole.
  using Send = std::function<void(std::string_view message)>;

  // The child may take `memory_bytes` more of address space than this process has (0: no limit).
  // Throws silt::Error where the system has no process to give.
  explicit ChildProcess(const std::function<void(const Send&)>& job, std::size_t memory_bytes = 0);
  // Kills what still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  enum class Event { kMessage, kTimeout, kEnd };
  // The next message, at most `longest` bytes; a longer one, or a broken one, ends the connection.
  Event Receive(double timeout_s, std::size_t longest, std::string& message);

  // After the end of the connection: how it ended, "crashed (Segmentation fault)" or the like;
  // empty where the job was done.
  std::string Wait();

 private:
  enum class ReadStatus { kDone, kTimeout, kEnd };
  ReadStatus Read(char* to, std::size_t size, double deadline_s);

  pid_t pid_ = -1;
  int pipe_ = -1;
};

}  // namespace silt::sim
