// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/isolated_import.h"

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <new>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/child_process.h"
#include "silt/sim/model_transfer.h"

namespace silt::sim {
namespace {

// The number of the next task, seen by this process and its children alike.
class SharedCounter {
 public:
  SharedCounter() {
    void* const page = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw Error("no shared memory for the import of models");
    value_ = new (page) std::atomic<int>(0);
  }
  ~SharedCounter() { munmap(value_, sizeof *value_); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  int Next() const { return value_->fetch_add(1); }
  int value() const { return value_->load(); }

 private:
  std::atomic<int>* value_;
};

// A message: its kind, the task, and what belongs to it.
enum class Kind : char { kStarted, kImported, kRefused };
constexpr std::size_t kHead = 1 + sizeof(int);

std::string Message(Kind kind, int task, const std::string& body = {}) {
  std::string message(kHead, char(kind));
  std::memcpy(message.data() + 1, &task, sizeof task);
  return message + body;
}

class IsolatedImport {
 public:
  IsolatedImport(const std::vector<ImportTask>& tasks, const ImportLimits& limits,
                 const Importer& importer)
      : tasks_(tasks), limits_(limits), importer_(importer), outcomes_(tasks.size()) {}

  std::vector<ImportOutcome> Run() && {
    const int children = std::min(ThreadCount(), int(tasks_.size()));
    ParallelFor(children, [this](int) {
      while (next_.value() < int(tasks_.size())) RunOneChild();
    });
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      ImportOutcome& outcome = outcomes_[i];
      if (!outcome.model && outcome.problem.empty()) {
        outcome.problem = Place(int(i)) + ": its import was lost";
      }
    }
    return std::move(outcomes_);
  }

 private:
  std::string Place(int task) const {
    const ImportTask& t = tasks_[std::size_t(task)];
    return t.source->Describe(t.source->Find(t.path).value_or(NormalizedAssetPath(t.path)));
  }

  // In the child: imports task after task until none is left.
  void Work(const ChildProcess::Send& send) const {
    for (int task = next_.Next(); task < int(tasks_.size()); task = next_.Next()) {
      send(Message(Kind::kStarted, task));
      const ImportTask& t = tasks_[std::size_t(task)];
      std::string result;
      try {
        result = Message(Kind::kImported, task, ModelToBytes(importer_(*t.source, t.path)));
      } catch (const std::bad_alloc&) {
        result = Message(Kind::kRefused, task, Place(task) + ": " + TooMuchMemory());
      } catch (const Error& e) {
        result = Message(Kind::kRefused, task, e.what());
      } catch (const std::exception& e) {
        result = Message(Kind::kRefused, task, Place(task) + ": the import failed: " + e.what());
      }
      send(result);
    }
  }

  // Follows a child until it has no more tasks or fails at one.
  void RunOneChild() {
    ChildProcess child([this](const ChildProcess::Send& send) { Work(send); },
                       limits_.memory_bytes);
    int task = -1;  // the one that it is busy with
    std::string message;
    while (true) {
      const auto event = child.Receive(limits_.time_s, limits_.memory_bytes, message);
      if (event == ChildProcess::Event::kTimeout) return Refuse(task, TooMuchTime());
      if (event == ChildProcess::Event::kEnd) break;
      if (!Take(message, task)) return Refuse(task, "the import library went astray");
    }
    if (task < 0) return;
    const std::string end = child.Wait();
    Refuse(task, "the import library " + (end.empty() ? "went astray" : end));
  }

  // Takes note of a message. False where it makes no sense.
  bool Take(const std::string& message, int& task) {
    int number = -1;
    if (message.size() < kHead) return false;
    std::memcpy(&number, message.data() + 1, sizeof number);
    const auto kind = Kind(message[0]);
    const std::string_view body = std::string_view(message).substr(kHead);
    if (kind == Kind::kStarted) {
      const bool sensible = task < 0 && number >= 0 && number < int(tasks_.size());
      if (sensible) task = number;
      return sensible;
    }
    if (task < 0 || number != task) return false;
    ImportOutcome& outcome = outcomes_[std::size_t(task)];
    if (kind == Kind::kImported) {
      try {
        outcome.model = ModelFromBytes(body);
      } catch (const Error& e) {
        outcome.problem = Place(task) + ": " + e.what();
      }
    } else {
      outcome.problem = std::string(body);
    }
    task = -1;
    return true;
  }

  void Refuse(int task, const std::string& why) {
    if (task >= 0) outcomes_[std::size_t(task)].problem = Place(task) + ": " + why;
  }

  std::string TooMuchTime() const {
    char text[96];
    std::snprintf(text, sizeof text, "its import takes longer than %.3g s", limits_.time_s);
    return text;
  }
  std::string TooMuchMemory() const {
    return "its import takes more memory than " + std::to_string(limits_.memory_bytes >> 20) +
           " MiB";
  }

  const std::vector<ImportTask>& tasks_;
  const ImportLimits& limits_;
  const Importer& importer_;
  SharedCounter next_;
  std::vector<ImportOutcome> outcomes_;
};

}  // namespace

std::vector<ImportOutcome> ImportIsolated(const std::vector<ImportTask>& tasks,
                                          const ImportLimits& limits, const Importer& importer) {
  if (tasks.empty()) return {};
  return IsolatedImport(tasks, limits, importer).Run();
}

}  // namespace silt::sim
