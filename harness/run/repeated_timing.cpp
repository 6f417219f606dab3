#include "harness/run/repeated_timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/cpu_clock.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kBatches = 5;
constexpr double kMaxWallTime = 10;     // in units of the time to be filled
constexpr double kShortestTime = 1e-9;  // s, for work that seems to take none

/// Consecutive executions and what they took together.
struct Batch {
  std::uint64_t executions = 0;
  double wall_s = 0;
  double cpu_s = 0;
};

Batch run_batch(const std::function<void()>& work, std::uint64_t executions) {
  const Clock::time_point wall_start = Clock::now();
  const double cpu_start = process_cpu_time_s();
  for (std::uint64_t i = 0; i < executions; ++i) work();
  const double cpu_s = process_cpu_time_s() - cpu_start;
  const std::chrono::duration<double> wall = Clock::now() - wall_start;
  return {executions, wall.count(), cpu_s};
}

double median_of(const std::vector<Batch>& batches, double Batch::*time) {
  std::vector<double> means;
  for (const Batch& batch : batches) means.push_back(batch.*time / static_cast<double>(batch.executions));
  return median(means);
}

/// How many executions like those of `batch` fill the CPU time, within the wall time.
std::uint64_t executions_to_fill(double cpu_s, double max_wall_s, const Batch& batch) {
  const auto executions = static_cast<double>(batch.executions);
  const double needed = std::ceil(cpu_s * executions / std::max(batch.cpu_s, kShortestTime));
  const double most = std::floor(max_wall_s * executions / std::max(batch.wall_s, kShortestTime));
  return static_cast<std::uint64_t>(std::max(1.0, std::min(needed, most)));
}

}  // namespace

RepeatedTiming time_repeatedly(const std::function<void()>& work, double min_time_s) {
  const Batch first = run_batch(work, 1);
  const double max_wall_s = kMaxWallTime * min_time_s;
  if (first.cpu_s >= min_time_s || first.wall_s >= max_wall_s) return {first.wall_s, first.cpu_s, 1};
  const double batch_cpu_s = min_time_s / static_cast<double>(kBatches);
  const double batch_wall_s = max_wall_s / static_cast<double>(kBatches);
  RepeatedTiming timing{0, 0, 0};
  std::vector<Batch> batches;
  double wall_s = 0;
  bool is_warm = false;
  Batch last = first;
  while (batches.size() < kBatches) {
    last = run_batch(work, executions_to_fill(batch_cpu_s, batch_wall_s, last));
    wall_s += last.wall_s;
    // While caches and the allocator warm up, executions take longer, and tell too little of how many fill a batch.
    const bool counts = is_warm && last.cpu_s >= batch_cpu_s / 2;
    is_warm = true;
    if (!counts && wall_s < max_wall_s) continue;
    batches.push_back(last);
    timing.executions += last.executions;
  }
  timing.wall_time_s = median_of(batches, &Batch::wall_s);
  timing.cpu_time_s = median_of(batches, &Batch::cpu_s);
  return timing;
}

}  // namespace mwt
