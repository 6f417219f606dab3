#include "harness/records/environment.h"

#include <fmt/core.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <charconv>
#include <cmath>

#include "harness/io/text/text.h"
#include "harness/run/machine/build_info.h"
#include "harness/run/machine/machine_watch.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

std::optional<double> load_1min() {
  const std::string text = first_line_of("/proc/loadavg");
  double load = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), load);
  if (error != std::errc()) return std::nullopt;
  return load;
}

// "on", "off", or nothing where the driver does not report it.
std::string turbo() {
  const std::string disabled = first_line_of("/sys/devices/system/cpu/intel_pstate/no_turbo");
  if (!disabled.empty()) return disabled == "0" ? "on" : "off";
  const std::string boost = first_line_of("/sys/devices/system/cpu/cpufreq/boost");
  if (!boost.empty()) return boost == "1" ? "on" : "off";
  return "";
}

std::string operating_system() {
  std::string name = value_in("/etc/os-release", "PRETTY_NAME=");
  std::erase(name, '"');
  return name;
}

std::string kernel() {
  utsname names{};
  if (uname(&names) != 0) return "";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

std::optional<std::uint64_t> swap_used_bytes() {
  const auto total = kilobytes_in("/proc/meminfo", "SwapTotal:");
  const auto free = kilobytes_in("/proc/meminfo", "SwapFree:");
  if (!total || !free) return std::nullopt;
  return (*total - *free) * 1024;
}

}  // namespace

EnvironmentRecord describe_environment(const std::string& study, int jobs, const std::string& shard) {
  EnvironmentRecord record;
  record.study = study;
  record.recorded_at = utc_now();
  record.git_commit = git_commit();
  record.binary_sha256 = sha256_of_file("/proc/self/exe");
  record.cpu_model = value_in("/proc/cpuinfo", "model name");
  const long cpus = sysconf(_SC_NPROCESSORS_ONLN);
  if (cpus > 0) record.logical_cpus = static_cast<std::uint64_t>(cpus);
  if (const auto memory = kilobytes_in("/proc/meminfo", "MemTotal:")) record.memory_bytes = *memory * 1024;
  record.operating_system = operating_system();
  record.kernel = kernel();
  record.compiler = compiler();
  record.compiler_flags = compiler_flags();
  record.governor = first_line_of("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  record.turbo = turbo();
  record.load_1min = load_1min();
  record.swap_used_bytes = swap_used_bytes();
  record.jobs = jobs;
  record.shard = shard;
  record.throttle_events = throttle_events();
  record.env_id = short_hash(fmt::format("{}{}", csv_line(to_row(environment_columns(), record)), getpid()));
  return record;
}

std::string machine_of(const EnvironmentRecord& environment) {
  std::vector<std::string> parts;
  if (!environment.cpu_model.empty()) parts.push_back(environment.cpu_model);
  if (environment.logical_cpus) parts.push_back(fmt::format("{} CPUs", *environment.logical_cpus));
  if (environment.memory_bytes) {
    parts.push_back(fmt::format("{} GiB", std::lround(static_cast<double>(*environment.memory_bytes) / (1U << 30))));
  }
  std::string machine;
  for (const std::string& part : parts) machine += (machine.empty() ? "" : ", ") + part;
  return machine;
}

std::vector<std::string> timing_warnings(const EnvironmentRecord& environment) {
  std::vector<std::string> warnings;
  if (!environment.governor.empty() && environment.governor != "performance") {
    warnings.push_back("the CPU governor is '" + environment.governor + "'; times are steadier with 'performance'");
  }
  if (environment.turbo == "on") warnings.push_back("turbo is on; times vary with heat and with the other CPUs' work");
  if (environment.jobs > 1) {
    warnings.push_back(fmt::format(
        "{} runs side by side share caches and memory; times are comparable only with --jobs 1", environment.jobs));
  }
  const double cpus = static_cast<double>(environment.logical_cpus.value_or(1));
  if (environment.load_1min && *environment.load_1min + environment.jobs > cpus) {
    warnings.push_back(fmt::format("the machine is busy: load {:.2f} on {:.0f} CPUs; times will be longer",
                                   *environment.load_1min, cpus));
  }
  if (environment.swap_used_bytes.value_or(0) > 0) warnings.push_back("swap is in use; large runs may be slowed by it");
  return warnings;
}

}  // namespace mwt
