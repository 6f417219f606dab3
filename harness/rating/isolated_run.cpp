#include "harness/rating/isolated_run.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "algorithms/proof_trace.h"
#include "harness/io/proof_file.h"
#include "harness/io/text/csv.h"
#include "harness/run/command/command.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/delaunay_time.h"

namespace mwt {

namespace {

// Checking and weighing take about a microsecond per point, writing a proof as much, the Delaunay time as much and at
// most half a second more; ten times that, and a second for a machine under load.
double allowance_s(const Timing& timing, bool writes_proof, Index n) {
  const double once = 1e-5 * n;
  return 1 + once + (writes_proof ? once : 0) + (timing.delaunay_time ? 5 + once : 0);
}

ProcessLimits process_limits(const RunLimits& limits, double allowance_s, int threads) {
  ProcessLimits result;
  result.wall_s = limits.time_s + limits.grace_s + allowance_s;
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

// The run as it goes through the pipe.
std::string encode(const RatedRun& run) { return csv_line(to_row(rated_run_columns<RatedRun>(), run)); }

std::optional<RatedRun> decode(const std::string& text) {
  const std::vector<CsvRow> rows = parse_csv(text);
  if (rows.size() != 1) return std::nullopt;
  try {
    return read_row(rated_run_columns<RatedRun>(), rows.front());
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

RatedRun failed(RunStatus status, const std::string& message) {
  RatedRun run;
  fail(run, status, message);
  return run;
}

// The optimum is found, whether or not what proves it can be written.
void write_proof_if_any(const std::string& file, Points points, const ProofTrace& trace, const Solution& solution) {
  if (!trace.is_complete || !solution.optimum) return;
  try {
    static_cast<void>(write_proof(file, points, trace, solution.triangulation, *solution.optimum));
  } catch (const std::exception&) {  // the file is missing, which is seen
  }
}

// What happens inside the process.
RatedRun run_here(Request request, Points points, const Timing& timing, double kill_after_s,
                  const std::string& proof_file) {
  try {
    ProofTrace trace;
    if (!proof_file.empty()) request.proof = &trace;
    const Execution execution = execute_repeatedly(request, points, timing.min_time_s);
    if (execution.wall_time_s > kill_after_s) return failed(RunStatus::timeout, "ended after its limit and grace");
    RatedRun run = judged(*request.algorithm, points, execution);
    if (run.status == RunStatus::invalid_output) {  // a failed run has no measures
      RatedRun bare = failed(run.status, run.message);
      bare.checker = run.checker;
      return bare;
    }
    if (!proof_file.empty() && run.status == RunStatus::ok)
      write_proof_if_any(proof_file, points, trace, execution.solution);
    if (timing.delaunay_time && run.status == RunStatus::ok) run.delaunay_time_s = delaunay_time_s(points);
    return run;
  } catch (const CommandFailure& failure) {
    return failed(failure.status(), failure.what());
  } catch (const NotApplicable& reason) {
    return failed(RunStatus::not_applicable, reason.what());
  } catch (const std::bad_alloc&) {
    return failed(RunStatus::out_of_memory, "an allocation failed under the memory limit");
  } catch (const std::exception& failure) {
    return failed(RunStatus::error, failure.what());
  }
}

RatedRun run_after(const ProcessResult& process) {
  std::optional<RatedRun> sent = process.end == ProcessEnd::finished ? decode(process.output) : std::nullopt;
  RatedRun run =
      sent ? *std::move(sent)
           : failed(status_after(process.end), process.how.empty() ? "its result was unreadable" : process.how);
  // What a failed run wrote to standard error may explain its status.
  if (is_failure(run.status) && !process.error_tail.empty()) {
    run.message += "; standard error: " + process.error_tail;
  }
  return run;
}

}  // namespace

void start_isolated_run(ProcessPool& pool, const Request& request, const Instance& instance, const RunLimits& limits,
                        const Timing& timing, std::function<void(RatedRun)> when_done, const std::string& proof_file) {
  const Points points = instance.set.points;
  const auto n = static_cast<Index>(points.size());
  const auto work = [&] {
    return encode(run_here(request, points, timing, limits.time_s + limits.grace_s, proof_file));
  };
  const ProcessLimits process = process_limits(limits, allowance_s(timing, !proof_file.empty(), n), request.threads);
  const bool may_leave_folder = request.algorithm->runs_outside;
  pool.start(work, process, [when_done = std::move(when_done), may_leave_folder](const ProcessResult& result) {
    if (may_leave_folder && result.end != ProcessEnd::finished) remove_abandoned_command_folders();
    when_done(run_after(result));
  });
}

}  // namespace mwt
