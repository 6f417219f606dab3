// Counts of what the processor did: instructions, cycles, misses. Unlike times, they hardly differ from run to run.
#pragma once

#include <cstdint>
#include <optional>

namespace mwt {

/// Of this thread outside the kernel. Missing: the machine does not count it (most virtual machines count nothing), the
/// system does not permit it (/proc/sys/kernel/perf_event_paranoid above 2), or others shared the counters.
struct EventCounts {
  std::optional<std::uint64_t> instructions;
  std::optional<std::uint64_t> cycles;
  std::optional<std::uint64_t> cache_misses;   ///< of the last level
  std::optional<std::uint64_t> branch_misses;  ///< mispredicted
};

/// Counts from construction to stop(), by perf_event_open(2).
class EventCounter {
 public:
  EventCounter();
  ~EventCounter();
  EventCounter(const EventCounter&) = delete;
  EventCounter& operator=(const EventCounter&) = delete;

  [[nodiscard]] EventCounts stop();

  /// Whether the machine and the system let anything be counted.
  [[nodiscard]] bool is_counting() const { return leader_ >= 0; }

 private:
  static constexpr int kEvents = 4;

  int descriptors_[kEvents];  // in the order of EventCounts; -1: not counted
  int leader_ = -1;           // starts and stops all
};

}  // namespace mwt
