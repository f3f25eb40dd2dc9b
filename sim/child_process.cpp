// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr int kPipeBytes = 1 << 20;

double Now_s() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// Address space in use, in bytes.
std::size_t AddressSpace() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * std::size_t(sysconf(_SC_PAGESIZE));
}

// Sanitizers reserve terabytes of address space, and shall not be starved of it.
constexpr bool MayLimitMemory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#else
  return true;
#endif
}

void SetLimit(__rlimit_resource_t resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::min(value, limit.rlim_max);
  limit.rlim_max = limit.rlim_cur;
  setrlimit(resource, &limit);
}

// Other children's pipes too, which would otherwise stay open as long as this child lives.
void CloseAllBut(int kept) {
  const auto close_range = [](unsigned first, unsigned last) {
    if (first <= last && syscall(SYS_close_range, first, last, 0) != 0) {
      for (unsigned file = first; file <= std::min(last, 65535u); ++file) close(int(file));
    }
  };
  close_range(3, unsigned(kept) - 1);
  close_range(unsigned(kept) + 1, ~0u);
}

void ConfineChild(std::size_t memory_bytes, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before it could be watched
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) {
    ::signal(signal, SIG_DFL);
  }
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
  SetLimit(RLIMIT_CORE, 0);
  if (memory_bytes > 0 && MayLimitMemory()) SetLimit(RLIMIT_AS, AddressSpace() + memory_bytes);
}

void WriteAll(int file, const char* from, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(file, from, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);  // nobody listens any more
    from += written;
    size -= std::size_t(written);
  }
}

[[noreturn]] void RunChild(const std::function<void(const ChildProcess::Send&)>& job, int pipe) {
  try {
    job([pipe](std::string_view message) {
      const auto size = std::uint64_t(message.size());
      WriteAll(pipe, reinterpret_cast<const char*>(&size), sizeof size);
      WriteAll(pipe, message.data(), message.size());
    });
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(const Send&)>& job, std::size_t memory_bytes) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw Error(std::string("no pipe to a child process: ") + std::strerror(errno));
  }
  fcntl(ends[1], F_SETPIPE_SZ, kPipeBytes);  // a wish
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    ConfineChild(memory_bytes, parent);
    CloseAllBut(ends[1]);
    RunChild(job, ends[1]);
  }
  const int problem = errno;
  close(ends[1]);
  pipe_ = ends[0];
  if (pid_ < 0) {
    close(pipe_);
    throw Error(std::string("no child process can be started: ") + std::strerror(problem));
  }
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(pipe_);
}

ChildProcess::ReadStatus ChildProcess::Read(char* to, std::size_t size, double deadline_s) {
  while (size > 0) {
    const double left_s = deadline_s - Now_s();
    pollfd waiting{pipe_, POLLIN, 0};
    const int ready = left_s <= 0 ? 0 : poll(&waiting, 1, int(std::min(left_s, 1e6) * 1000) + 1);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) return ReadStatus::kTimeout;
    const ssize_t got = read(pipe_, to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return ReadStatus::kEnd;
    to += got;
    size -= std::size_t(got);
  }
  return ReadStatus::kDone;
}

ChildProcess::Event ChildProcess::Receive(double timeout_s, std::size_t longest,
                                          std::string& message) {
  const double deadline_s = Now_s() + timeout_s;
  const auto event = [](ReadStatus status) {
    return status == ReadStatus::kTimeout ? Event::kTimeout : Event::kEnd;
  };
  std::uint64_t size = 0;
  ReadStatus status = Read(reinterpret_cast<char*>(&size), sizeof size, deadline_s);
  if (status != ReadStatus::kDone) return event(status);
  if (size > longest) return Event::kEnd;
  message.resize(size);
  status = Read(message.data(), message.size(), deadline_s);
  return status == ReadStatus::kDone ? Event::kMessage : event(status);
}

std::string ChildProcess::Wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status)) {
    return std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
  }
  return WEXITSTATUS(status) == 0 ? "" : "failed";
}

}  // namespace silt::sim
