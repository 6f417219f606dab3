// Isolated processes: pieces of work in forked children, each in a process group of its own, under limits.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <string>

namespace mwt {

struct ProcessLimits {
  double wall_s = 0;               ///< killed (the whole group) when it has run this long
  double cpu_s = 0;                ///< killed likewise when all its threads together have used so much CPU time
  std::uint64_t memory_bytes = 0;  ///< data it may allocate beyond what it has when it begins
};

enum class ProcessEnd {
  finished,          ///< sent its result
  stopped_at_limit,  ///< killed by the parent at wall_s or cpu_s
  killed,            ///< by SIGKILL that the parent did not send: usually the system, out of memory
  crashed,           ///< any other signal, or it exited without a result
};

struct ProcessResult {
  ProcessEnd end = ProcessEnd::crashed;
  std::string output;      ///< what the work returned
  std::string error_tail;  ///< the end of what it wrote to standard error
  std::string how;         ///< for a failure, one phrase: "signal 11 (Segmentation fault)"
};

/// Runs up to `capacity` pieces of work side by side. The children see the parent's memory as it was at start();
/// nothing they do changes it. Their standard input and output are /dev/null. They die with the parent. When one ends,
/// whatever it started ends, too.
///
/// Precondition: the calling process is single-threaded (fork). Linux.
class ProcessPool {
 public:
  using Work = std::function<std::string()>;                   ///< runs in the child; what it throws counts as a crash
  using WhenDone = std::function<void(const ProcessResult&)>;  ///< runs in the parent, inside wait()

  explicit ProcessPool(int capacity);
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  [[nodiscard]] bool is_full() const { return static_cast<int>(children_.size()) >= capacity_; }
  [[nodiscard]] bool is_empty() const { return children_.empty(); }

  /// Precondition: not full. Throws std::system_error if the system gives no process.
  void start(const Work& work, const ProcessLimits& limits, WhenDone when_done);

  /// Returns when at least one child has ended and its WhenDone was called, or after `patience` (for progress), or when
  /// a signal arrived. Kills what is over its limit. A WhenDone may start() another.
  void wait(std::chrono::milliseconds patience);

 private:
  struct Child;

  int capacity_;
  std::list<Child> children_;
};

}  // namespace mwt
