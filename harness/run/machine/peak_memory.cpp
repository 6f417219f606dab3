#include "harness/run/machine/peak_memory.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "geometry/mesh/kept_memory.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {

void reset_peak_memory() {
  release_kept_blocks();
  const int file = open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  // "5" resets VmHWM; where that is refused, peak_memory_bytes() documents what remains.
  [[maybe_unused]] const ssize_t written = write(file, "5", 1);
  close(file);
}

std::uint64_t peak_memory_bytes() {
  if (const auto high_water_mark = kilobytes_in("/proc/self/status", "VmHWM:")) return *high_water_mark * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace mwt
