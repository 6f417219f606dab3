#include "harness/run/machine/event_counts.h"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>

namespace mwt {

namespace {

constexpr std::array<std::uint64_t, 4> kHardwareEvents = {PERF_COUNT_HW_INSTRUCTIONS, PERF_COUNT_HW_CPU_CYCLES,
                                                          PERF_COUNT_HW_CACHE_MISSES, PERF_COUNT_HW_BRANCH_MISSES};

int open_event(std::uint64_t event, int leader) {
  perf_event_attr attributes{};
  attributes.size = sizeof attributes;
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = event;
  if (leader < 0) attributes.disabled = 1;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  constexpr int kThisThread = 0, kAnyCpu = -1;
  return static_cast<int>(
      syscall(SYS_perf_event_open, &attributes, kThisThread, kAnyCpu, leader, PERF_FLAG_FD_CLOEXEC));
}

/// Nothing if the event had its counter for only a part of the time.
std::optional<std::uint64_t> count_of(int descriptor) {
  struct {
    std::uint64_t value, enabled, running;
  } content{};
  if (descriptor < 0 || read(descriptor, &content, sizeof content) != sizeof content) return std::nullopt;
  return content.running > 0 && content.running == content.enabled ? std::optional(content.value) : std::nullopt;
}

}  // namespace

EventCounter::EventCounter() {
  for (std::size_t i = 0; i < kHardwareEvents.size(); ++i) {
    descriptors_[i] = open_event(kHardwareEvents[i], leader_);
    if (leader_ < 0) leader_ = descriptors_[i];
  }
  if (leader_ >= 0) ioctl(leader_, PERF_EVENT_IOC_ENABLE, PERF_IOC_FLAG_GROUP);
}

EventCounts EventCounter::stop() {
  if (leader_ >= 0) ioctl(leader_, PERF_EVENT_IOC_DISABLE, PERF_IOC_FLAG_GROUP);
  return {count_of(descriptors_[0]), count_of(descriptors_[1]), count_of(descriptors_[2]), count_of(descriptors_[3])};
}

EventCounter::~EventCounter() {
  for (const int descriptor : descriptors_) {
    if (descriptor >= 0) close(descriptor);
  }
}

}  // namespace mwt
