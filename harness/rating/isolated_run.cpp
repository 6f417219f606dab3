#include "harness/rating/isolated_run.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "algorithms/proof_trace.h"
#include "base/number_text.h"
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

// A run and what it encloses.
struct SentRun {
  RatedRun run;
  std::string enclosed;
};

// As they go through the pipe: the length of the run's text, that text, and what is enclosed.
std::string encode(const SentRun& sent) {
  const std::string line = csv_line(to_row(rated_run_columns<RatedRun>(), sent.run));
  return std::to_string(line.size()) + '\n' + line + sent.enclosed;
}

std::optional<SentRun> decode(const std::string& text) {
  const std::size_t line_begin = text.find('\n') + 1;
  const auto size = parse_whole_number<std::uint64_t>(std::string_view(text).substr(0, line_begin - 1));
  if (line_begin == 0 || !size || *size > text.size() - line_begin) return std::nullopt;
  const std::vector<CsvRow> rows = parse_csv(text.substr(line_begin, *size));
  if (rows.size() != 1) return std::nullopt;
  try {
    return SentRun{read_row(rated_run_columns<RatedRun>(), rows.front()), text.substr(line_begin + *size)};
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

// What is done in a run's process besides the run.
struct Extras {
  std::string proof_file;
  RunEnclosure enclose;
};

SentRun execute_and_judge(Request request, Points points, const Timing& timing, double kill_after_s,
                          const Extras& extras) {
  ProofTrace trace;
  if (!extras.proof_file.empty()) request.proof = &trace;
  const Execution execution = execute_repeatedly(request, points, timing.min_time_s);
  if (execution.wall_time_s > kill_after_s) return {failed(RunStatus::timeout, "ended after its limit and grace"), ""};
  SentRun sent{judged(*request.algorithm, points, execution), ""};
  RatedRun& run = sent.run;
  if (run.status == RunStatus::invalid_output) {  // a failed run has no measures
    RatedRun bare = failed(run.status, run.message);
    bare.checker = run.checker;
    return {bare, ""};
  }
  if (run.status != RunStatus::ok) return sent;
  if (!extras.proof_file.empty()) write_proof_if_any(extras.proof_file, points, trace, execution.solution);
  if (timing.delaunay_time) run.delaunay_time_s = delaunay_time_s(points);
  if (extras.enclose) sent.enclosed = extras.enclose(execution);
  return sent;
}

// What happens inside the process.
SentRun run_here(const Request& request, Points points, const Timing& timing, double kill_after_s,
                 const Extras& extras) {
  try {
    return execute_and_judge(request, points, timing, kill_after_s, extras);
  } catch (const CommandFailure& failure) {
    return {failed(failure.status(), failure.what()), ""};
  } catch (const NotApplicable& reason) {
    return {failed(RunStatus::not_applicable, reason.what()), ""};
  } catch (const std::bad_alloc&) {
    return {failed(RunStatus::out_of_memory, "an allocation failed under the memory limit"), ""};
  } catch (const std::exception& failure) {
    return {failed(RunStatus::error, failure.what()), ""};
  }
}

SentRun run_after(const ProcessResult& process) {
  std::optional<SentRun> sent = process.end == ProcessEnd::finished ? decode(process.output) : std::nullopt;
  if (!sent) {
    const std::string how = process.how.empty() ? "its result was unreadable" : process.how;
    sent = {failed(status_after(process.end), how), ""};
  }
  // What a failed run wrote to standard error may explain its status.
  if (is_failure(sent->run.status) && !process.error_tail.empty()) {
    sent->run.message += "; standard error: " + process.error_tail;
  }
  return *std::move(sent);
}

void start_run(ProcessPool& pool, const Request& request, const Instance& instance, const RunLimits& limits,
               const Timing& timing, const Extras& extras, std::function<void(SentRun)> when_done) {
  const Points points = instance.set.points;
  const auto n = static_cast<Index>(points.size());
  const auto work = [&] { return encode(run_here(request, points, timing, limits.time_s + limits.grace_s, extras)); };
  const ProcessLimits process =
      process_limits(limits, allowance_s(timing, !extras.proof_file.empty(), n), request.threads);
  const bool may_leave_folder = request.algorithm->runs_outside;
  pool.start(work, process, [when_done = std::move(when_done), may_leave_folder](const ProcessResult& result) {
    if (may_leave_folder && result.end != ProcessEnd::finished) remove_abandoned_command_folders();
    when_done(run_after(result));
  });
}

}  // namespace

void start_isolated_run(ProcessPool& pool, const Request& request, const Instance& instance, const RunLimits& limits,
                        const Timing& timing, std::function<void(RatedRun)> when_done, const std::string& proof_file) {
  start_run(pool, request, instance, limits, timing, {proof_file, nullptr},
            [when_done = std::move(when_done)](SentRun sent) { when_done(std::move(sent.run)); });
}

void start_isolated_run_with(ProcessPool& pool, const Request& request, const Instance& instance,
                             const RunLimits& limits, const Timing& timing, RunEnclosure enclose,
                             std::function<void(RatedRun, std::string)> when_done) {
  start_run(
      pool, request, instance, limits, timing, {"", std::move(enclose)},
      [when_done = std::move(when_done)](SentRun sent) { when_done(std::move(sent.run), std::move(sent.enclosed)); });
}

}  // namespace mwt
