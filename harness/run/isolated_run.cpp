#include "harness/run/isolated_run.h"

#include <utility>

#include "harness/io/text/text.h"

namespace mwt {

namespace {

// Checking and weighing take about a microsecond per point, the Delaunay time as much and at most half a second more;
// ten times that, and a second for a machine under load.
double allowance_s(const Timing& timing, Index n) {
  const double once = 1e-5 * n;
  return 1 + once + (timing.delaunay_time ? 5 + once : 0);
}

ProcessLimits process_limits(const RunLimits& limits, const Timing& timing, Index n, int threads) {
  ProcessLimits result;
  result.wall_s = limits.time_s + limits.grace_s + allowance_s(timing, n);
  result.cpu_s = result.wall_s * threads;
  result.memory_bytes = limits.memory_bytes;
  return result;
}

RunStatus status_after(ProcessEnd end) {
  switch (end) {
    case ProcessEnd::stopped_at_limit: return RunStatus::timeout;
    case ProcessEnd::killed: return RunStatus::out_of_memory;
    case ProcessEnd::finished:
    case ProcessEnd::crashed: break;
  }
  return RunStatus::crashed;
}

// What a failed run wrote to standard error may say more than its status.
RunRecord with_errors(RunRecord record, const std::string& error_tail) {
  if (is_failure(record.status) && !error_tail.empty()) record.message += "; standard error: " + error_tail;
  return record;
}

RunRecord record_after(const ProcessResult& process, RunRecord keys) {
  if (process.end == ProcessEnd::finished) {
    if (std::optional<RunRecord> record = decode(process.output)) {
      return with_errors(*std::move(record), process.error_tail);
    }
  }
  keys.status = status_after(process.end);
  keys.message = process.how.empty() ? "its result was unreadable" : process.how;
  return with_errors(std::move(keys), process.error_tail);
}

}  // namespace

void start_isolated_run(ProcessPool& pool, const Request& request, std::shared_ptr<const Instance> instance,
                        const RunRecord& keys, const RunLimits& limits, const Timing& timing,
                        std::function<void(RunRecord)> when_done) {
  const auto work = [&] {
    return encode(run_in_worker(request, *instance, keys, timing, limits.time_s + limits.grace_s));
  };
  const ProcessLimits process =
      process_limits(limits, timing, static_cast<Index>(instance->set.points.size()), request.threads);
  pool.start(work, process, [keys, when_done = std::move(when_done)](const ProcessResult& result) {
    RunRecord record = record_after(result, keys);
    record.recorded_at = utc_now();
    when_done(std::move(record));
  });
}

}  // namespace mwt
