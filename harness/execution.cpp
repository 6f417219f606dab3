#include "harness/execution.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <exception>
#include <stdexcept>
#include <utility>

#include "geometry/checker.h"
#include "geometry/convex_hull.h"
#include "geometry/weight.h"
#include "harness/peak_memory.h"

namespace mwt {

namespace {

double process_cpu_time_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Context make_context(const Request& request) {
  Context context;
  context.seed = request.seed;
  context.threads = request.threads;
  context.parameters = request.parameters;
  context.start = request.start;
  context.progress = request.progress;
  return context;
}

// One execution in a context that may have served before: only its deadline and its phases are of one execution.
Solution execute(const Request& request, Points points, Context& context) {
  context.phases.clear();
  if (request.time_limit_s) {
    const std::chrono::duration<double> limit(*request.time_limit_s);
    context.deadline = Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(limit);
  }
  return request.algorithm->function(points, context);
}

// Keeps the measured times and prints nothing: standard output belongs to the records.
class SilentReporter : public benchmark::BenchmarkReporter {
 public:
  explicit SilentReporter(Execution& execution) : execution_(execution) {}

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double iterations = static_cast<double>(run.iterations);
      execution_.iterations = static_cast<std::uint64_t>(run.iterations);
      execution_.wall_time_s = run.real_accumulated_time / iterations;
      execution_.cpu_time_s = run.cpu_accumulated_time / iterations;
    }
  }

 private:
  Execution& execution_;
};

}  // namespace

Instance make_instance(const std::vector<Point>& input, const std::string& source) {
  Instance instance;
  instance.set = make_point_set(input, source);
  instance.id = instance_id(instance.set.points);
  instance.hull_size = static_cast<Index>(convex_hull(instance.set.points).size());
  return instance;
}

Execution execute_once(const Request& request, Points points) {
  Execution execution;
  Context context = make_context(request);
  reset_peak_memory();
  const double cpu_start = process_cpu_time_s();
  const auto wall_start = Context::Clock::now();
  execution.solution = execute(request, points, context);
  const std::chrono::duration<double> elapsed = Context::Clock::now() - wall_start;
  execution.cpu_time_s = process_cpu_time_s() - cpu_start;
  execution.wall_time_s = elapsed.count();
  execution.peak_rss_bytes = peak_memory_bytes();
  execution.phases = std::move(context.phases);
  return execution;
}

Execution execute_repeatedly(const Request& request, Points points, double min_time_s) {
  Execution execution;
  Context context = make_context(request);
  std::exception_ptr failure;
  const auto timed = [&](benchmark::State& state) {
    try {
      for (auto _ : state) {
        execution.solution = {};  // so that the peak of memory is that of one execution
        execution.solution = execute(request, points, context);
      }
    } catch (...) {
      failure = std::current_exception();
      state.SkipWithError("the algorithm threw");
    }
  };
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark("run", timed)->MinTime(min_time_s)->UseRealTime()->MeasureProcessCPUTime();
  SilentReporter reporter(execution);
  reset_peak_memory();
  benchmark::RunSpecifiedBenchmarks(&reporter, "run");
  execution.peak_rss_bytes = peak_memory_bytes();
  execution.phases = std::move(context.phases);
  if (failure) std::rethrow_exception(failure);
  return execution;
}

void prepare_timing() {
  static_cast<void>(benchmark::CPUInfo::Get());
  static_cast<void>(benchmark::SystemInfo::Get());
}

Judgement judge(Points points, const Triangulation& triangulation) {
  Judgement judgement;
  if (const auto violation = find_violation(points, triangulation)) {
    judgement.violation = violation->message;
    return judgement;
  }
  judgement.weight = weight(points, triangulation);
  judgement.perimeter_sum = perimeter_sum(points, triangulation);
  judgement.triangles = triangulation.triangles.size();
  // By Euler's formula, for the checker has seen that 3 sides per triangle pair up except on the hull.
  judgement.edges = (judgement.triangles * 3 + convex_hull(points).size()) / 2;
  return judgement;
}

}  // namespace mwt
