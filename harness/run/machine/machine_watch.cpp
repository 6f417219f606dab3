#include "harness/run/machine/machine_watch.h"

#include <fmt/core.h>
#include <unistd.h>

#include <sstream>

#include "harness/io/text/text.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

constexpr double kNoteworthyShareStolen = 0.01;

std::uint64_t swapped_pages() {
  std::uint64_t pages = 0;
  for (const char* counter : {"pswpin ", "pswpout "}) pages += kilobytes_in("/proc/vmstat", counter).value_or(0);
  return pages;
}

}  // namespace

std::optional<std::uint64_t> throttle_events() {
  std::optional<std::uint64_t> sum;
  const long cpus = sysconf(_SC_NPROCESSORS_CONF);
  for (long cpu = 0; cpu < cpus; ++cpu) {
    const std::string file = fmt::format("/sys/devices/system/cpu/cpu{}/thermal_throttle/core_throttle_count", cpu);
    if (const auto count = kilobytes_in(file, "")) sum = sum.value_or(0) + *count;
  }
  return sum;
}

MachineWatch::MachineWatch() : begin_(read()) {}

MachineWatch::Counters MachineWatch::read() {
  Counters counters;
  counters.throttled = throttle_events();
  counters.swapped_pages = swapped_pages();
  // user, nice, system, idle, iowait, irq, softirq, steal; what follows is counted in the first two already.
  std::istringstream ticks(value_in("/proc/stat", "cpu "));
  std::uint64_t value = 0;
  for (int field = 0; field < 8 && ticks >> value; ++field) {
    counters.all_ticks += value;
    if (field == 7) counters.stolen_ticks = value;
  }
  return counters;
}

std::vector<std::string> MachineWatch::warnings() const {
  const Counters now = read();
  std::vector<std::string> warnings;
  if (now.throttled && now.throttled > begin_.throttled) {
    warnings.push_back(
        fmt::format("CPUs were slowed down by heat {} times meanwhile", *now.throttled - begin_.throttled.value_or(0)));
  }
  if (now.swapped_pages > begin_.swapped_pages) warnings.push_back("memory was moved to or from swap meanwhile");
  const auto all = static_cast<double>(now.all_ticks - begin_.all_ticks);
  const auto stolen = static_cast<double>(now.stolen_ticks - begin_.stolen_ticks);
  if (stolen > kNoteworthyShareStolen * all) {
    warnings.push_back("other virtual machines took " + fixed(100 * stolen / all, 1) + "% of the CPU time meanwhile");
  }
  return warnings;
}

}  // namespace mwt
