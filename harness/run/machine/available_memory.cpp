#include "harness/run/machine/available_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

using Bytes = std::optional<std::uint64_t>;

Bytes least(const Bytes& one, const Bytes& other) {
  if (!one || !other) return one ? one : other;
  return std::min(*one, *other);
}

Bytes difference(const Bytes& limit, const Bytes& used) {
  if (!limit) return {};
  return *limit - std::min(*limit, used.value_or(0));
}

// What a limit leaves beyond what the line `used` of /proc/self/status has.
Bytes left_by_limit(__rlimit_resource_t resource, const char* used) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  const Bytes kilobytes = kilobytes_in("/proc/self/status", used);
  return difference(limit.rlim_cur, kilobytes ? Bytes(*kilobytes * 1024) : Bytes());
}

Bytes number_in(const std::string& path) {
  const std::string text = first_line_of(path);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? Bytes(number) : Bytes();
}

}  // namespace

Bytes available_memory_bytes() {
  Bytes result;
  if (const Bytes machine = kilobytes_in("/proc/meminfo", "MemAvailable:")) result = *machine * 1024;
  result = least(result, left_by_limit(RLIMIT_DATA, "VmData:"));
  result = least(result, left_by_limit(RLIMIT_AS, "VmSize:"));
  const std::string group = "/sys/fs/cgroup/";
  return least(result, difference(number_in(group + "memory.max"), number_in(group + "memory.current")));
}

}  // namespace mwt
