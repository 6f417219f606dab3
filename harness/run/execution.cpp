#include "harness/run/execution.h"

#include <utility>

#include "algorithms/interrupted.h"
#include "algorithms/proof_trace.h"
#include "algorithms/step_trace.h"
#include "base/cpu_clock.h"
#include "geometry/convex_hull.h"
#include "harness/run/callgrind/marks.h"
#include "harness/run/machine/available_memory.h"
#include "harness/run/machine/peak_memory.h"
#include "harness/run/repeated_timing.h"

namespace mwt {

namespace {

// Nine tenths of what there is for tables, the rest for what no algorithm counts. Heuristics on few points make small
// ones, and take less time than it takes to read how much memory there is.
std::optional<std::uint64_t> memory_for_tables(const AlgorithmInfo& algorithm, std::size_t n) {
  constexpr std::size_t kFewPoints = 1000;
  if (algorithm.exactness == Exactness::heuristic && n < kFewPoints) return std::nullopt;
  const std::optional<std::uint64_t> available = available_memory_bytes();
  return available ? std::optional(*available / 10 * 9) : std::nullopt;
}

Context make_context(const Request& request, std::size_t n) {
  Context context;
  context.seed = request.seed;
  context.threads = request.threads;
  context.parameters = request.parameters;
  context.start = request.start;
  context.proof = request.proof;
  context.steps = request.steps;
  context.progress = request.progress;
  context.deadline.interrupt = request.interrupt;
  context.memory_bytes = memory_for_tables(*request.algorithm, n);
  return context;
}

// One execution in a context that may have served before: only its deadline and its phases are of one execution.
Solution execute(const Request& request, Points points, Context& context) {
  context.phases.clear();
  if (context.proof != nullptr) *context.proof = {};
  if (context.steps != nullptr) *context.steps = {};
  if (request.time_limit_s) {
    const std::chrono::duration<double> limit(*request.time_limit_s);
    context.deadline =
        context.deadline.moved_to(Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(limit));
  }
  Solution solution = request.algorithm->function(points, context);
  throw_if_interrupted(context.deadline);
  return solution;
}

// The first execution alone: how many follow depends on the machine, and what a later one finds in the allocator, too.
Solution execute_counted(const Request& request, Points points, Context& context, EventCounts& counts) {
  std::optional<EventCounter> counter;
  if (request.threads == 1) counter.emplace();
  Solution solution;
  {
    const CallgrindMark mark;
    solution = execute(request, points, context);
  }
  if (counter) counts = counter->stop();
  return solution;
}

// Another process is started once: it pays for its start each time.
Execution execute_outside(const Request& request, Points points) {
  Context context = make_context(request, points.size());
  Execution execution;
  execution.solution = execute(request, points, context);
  execution.phases = std::move(context.phases);
  const OutsideCost cost = context.outside.value();
  execution.wall_time_s = cost.wall_time_s;
  execution.cpu_time_s = cost.cpu_time_s;
  execution.peak_rss_bytes = cost.peak_rss_bytes;
  return execution;
}

}  // namespace

Instance make_instance(const std::vector<Point>& input, const std::string& source) {
  Instance instance;
  instance.set = make_point_set(input, source);
  instance.id = instance_id(instance.set.points);
  instance.hull_size = static_cast<Index>(convex_hull(instance.set.points).size());
  return instance;
}

Execution execute_repeatedly(const Request& request, Points points, double min_time_s) {
  if (request.algorithm->runs_outside) return execute_outside(request, points);
  Execution execution;
  Context context = make_context(request, points.size());
  reset_peak_memory();
  bool is_first = true;
  const RepeatedTiming timing = time_repeatedly(
      [&] {
        execution.solution = {};  // so that the peak of memory is that of one execution
        const bool counts = std::exchange(is_first, false);
        execution.solution =
            counts ? execute_counted(request, points, context, execution.counts) : execute(request, points, context);
      },
      min_time_s);
  execution.wall_time_s = timing.wall_time_s;
  execution.cpu_time_s = timing.cpu_time_s;
  execution.iterations = timing.executions;
  execution.peak_rss_bytes = peak_memory_bytes();
  execution.phases = std::move(context.phases);
  return execution;
}

Execution solve_unmeasured(const Request& request, Points points) {
  Context context = make_context(request, points.size());
  Execution execution;
  execution.solution = execute(request, points, context);
  return execution;
}

Execution execute_once(const Request& request, Points points) { return execute_repeatedly(request, points, 0); }

}  // namespace mwt
