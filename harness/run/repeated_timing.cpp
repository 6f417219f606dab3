#include "harness/run/repeated_timing.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/cpu_clock.h"
#include "harness/run/branch_history.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kMinExecutions = 5;
constexpr double kMaxCpuTime = 4;    // with what lies between executions, in units of the time to be filled
constexpr double kMaxWallTime = 10;  // likewise, of the executions

struct Times {
  double wall_s = 0;
  double cpu_s = 0;
};

Times time_once(const std::function<void()>& work) {
  const Clock::time_point wall_start = Clock::now();
  const double cpu_start = process_cpu_time_s();
  work();
  const double cpu_s = process_cpu_time_s() - cpu_start;
  const std::chrono::duration<double> wall = Clock::now() - wall_start;
  return {wall.count(), cpu_s};
}

double median_of(const std::vector<Times>& executions, double Times::*time) {
  std::vector<double> times;
  times.reserve(executions.size());
  for (const Times& execution : executions) times.push_back(execution.*time);
  return median(times);
}

}  // namespace

RepeatedTiming time_repeatedly(const std::function<void()>& work, double min_time_s) {
  const Times first = time_once(work);
  const double max_wall_s = kMaxWallTime * min_time_s;
  if (first.cpu_s >= min_time_s || first.wall_s >= max_wall_s) return {first.wall_s, first.cpu_s, 1};
  std::vector<Times> executions;
  BranchHistory history;
  Times sum;
  const double cpu_start = process_cpu_time_s();
  const auto is_enough = [&] {
    return sum.cpu_s >= min_time_s || sum.wall_s >= max_wall_s ||
           process_cpu_time_s() - cpu_start >= kMaxCpuTime * min_time_s;
  };
  while (executions.size() < kMinExecutions || !is_enough()) {
    history.overwrite();
    executions.push_back(time_once(work));
    sum.wall_s += executions.back().wall_s;
    sum.cpu_s += executions.back().cpu_s;
  }
  return {median_of(executions, &Times::wall_s), median_of(executions, &Times::cpu_s), executions.size()};
}

}  // namespace mwt
