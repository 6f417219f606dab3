#include "harness/run/worker.h"

#include <exception>
#include <new>

#include "harness/rating/optimum_claims.h"
#include "harness/rating/quality.h"
#include "harness/run/delaunay_time.h"

namespace mwt {

namespace {

constexpr std::size_t kLongestMessage = 1000;

void fail(RunRecord& record, RunStatus status, const std::string& message) {
  record.status = status;
  record.message = message.size() <= kLongestMessage ? message : message.substr(0, kLongestMessage) + " ...";
}

void fill_in_measures(RunRecord& record, const Execution& execution, const Judgement& judgement) {
  record.wall_time_s = execution.wall_time_s;
  record.cpu_time_s = execution.cpu_time_s;
  record.iterations = execution.iterations;
  record.peak_rss_bytes = execution.peak_rss_bytes;
  record.weight_lower = judgement.weight.lower;
  record.weight_upper = judgement.weight.upper;
  record.perimeter_sum = judgement.perimeter_sum.middle();
  record.triangles = judgement.triangles;
  record.edges = judgement.edges;
  record.stopped_early = execution.solution.stopped_early();
  record.stop_reason = execution.solution.stop_reason;
  record.triangulation_count = execution.solution.count.value_or("");
  record.phases = named_numbers(execution.phases);
  record.counters = named_numbers(execution.solution.counters);
}

void believe(RunRecord& record, const Execution& execution, const Judgement& judgement) {
  record.status = RunStatus::ok;
  fill_in_measures(record, execution, judgement);
  const WitnessedOptimum optimum = witnessed_optimum(execution.solution.optimum, judgement.weight);
  if (optimum.contradiction) {
    const OptimumClaim claim{"", record.algorithm.empty() ? "it" : record.algorithm, *execution.solution.optimum};
    fail(record, RunStatus::error, Disproof{claim, "", judgement.weight.upper}.text());
  } else if (optimum.interval) {
    record.certified_lower = optimum.interval->lower;
  }
}

}  // namespace

RunRecord run_in_worker(const Request& request, const Instance& instance, RunRecord record, const Timing& timing,
                        double kill_after_s) {
  try {
    const Execution execution = execute_repeatedly(request, instance.set.points, timing.min_time_s);
    if (execution.wall_time_s > kill_after_s) {
      fail(record, RunStatus::timeout, "ended after its limit and grace");
      return record;
    }
    const Judgement judgement = judge(instance.set.points, execution.solution.triangulation);
    record.checker = judgement.violation.value_or("ok");
    if (judgement.violation) {
      fail(record, RunStatus::invalid_output, *judgement.violation);
    } else {
      believe(record, execution, judgement);
      if (timing.delaunay_time) record.delaunay_time_s = delaunay_time_s(instance.set.points);
    }
  } catch (const NotApplicable& reason) {
    fail(record, RunStatus::not_applicable, reason.what());
  } catch (const std::bad_alloc&) {
    fail(record, RunStatus::out_of_memory, "an allocation failed under the memory limit");
  } catch (const std::exception& failure) {
    fail(record, RunStatus::error, failure.what());
  }
  return record;
}

std::string encode(const RunRecord& record) { return csv_line(to_row(run_columns(), record)); }

std::optional<RunRecord> decode(const std::string& text) {
  const std::vector<CsvRow> rows = parse_csv(text);
  if (rows.size() != 1) return std::nullopt;
  return from_row(run_columns(), rows.front());
}

}  // namespace mwt
