#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "geometry/point_file.h"
#include "geometry/svg.h"
#include "geometry/triangulation_file.h"
#include "harness/catalogue.h"
#include "harness/commands/commands.h"
#include "harness/execution.h"
#include "harness/json_output.h"
#include "harness/optimum_cache.h"
#include "harness/quality.h"
#include "harness/solve_report.h"
#include "harness/start_triangulation.h"
#include "harness/study/optimum_search.h"

namespace mwt {

namespace {

struct Options {
  std::string points;
  std::string algorithm;
  std::vector<std::string> parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<double> time_limit_s;
  bool with_optimum = false;
  bool no_cache = false;
  bool json = false;
  std::optional<std::string> triangles;
  std::optional<std::string> edges;
  std::optional<std::string> svg;
};

Request make_request(const Options& options, const Catalogue& catalogue, const Instance& instance,
                     const std::vector<Point>& input) {
  Request request;
  request.algorithm = &catalogue.algorithm(options.algorithm);
  const AlgorithmInfo& info = *request.algorithm;
  request.parameters = Parameters(info.name, info.parameters, parse_parameters(options.parameters));
  request.seed = options.seed;
  request.threads = options.threads;
  request.time_limit_s = options.time_limit_s;
  if (const auto file = start_file_of(info, request.parameters)) request.start = read_start(*file, instance.set, input);
  return request;
}

// The optimum from the cache or the exact algorithms, each in a process of its own.
FoundOptimum search_optimum(const Instance& instance, std::vector<const AlgorithmInfo*> sources,
                            const RunLimits& limits, OptimumCache* cache) {
  const auto shared = std::make_shared<const Instance>(instance);
  FoundOptimum result;
  ProcessPool pool(1);
  seek_optimum(pool, shared, std::move(sources), limits, cache, [&](const FoundOptimum& found) { result = found; });
  while (!pool.is_empty()) pool.wait(std::chrono::milliseconds(200));
  return result;
}

std::optional<OptimumCache> open_cache(const Options& options) {
  if (options.no_cache) return std::nullopt;
  const auto warn = [](const std::string& warning) { std::cerr << "mwt: warning: " << warning << '\n'; };
  return OptimumCache(optimum_cache_folder(), warn);
}

FoundOptimum cached(const CachedOptimum& earlier, const AlgorithmInfo& solver) {
  FoundOptimum found;
  found.interval = earlier.interval;
  found.source = solver.name;
  found.is_cached = true;
  return found;
}

// What is known besides what the solution itself certifies. If that is the optimum, nothing more is sought, and it goes
// into the cache; and an exact algorithm that did not prove it is not asked again.
FoundOptimum optimum_beyond(const Catalogue& catalogue, const Instance& instance, const Request& request,
                            const Execution& execution, const Interval& weight, const Options& options) {
  std::optional<OptimumCache> cache = open_cache(options);
  const AlgorithmInfo& solver = *request.algorithm;
  const OptimumKey key = optimum_key(instance.id, solver, request.parameters);
  const std::optional<Interval> own = witnessed_optimum(execution.solution.optimum, weight).interval;
  if (optimality_of(own) == Optimality::proved) {
    if (cache && solver.exactness == Exactness::exact) cache->store(key, {*own, execution.wall_time_s});
    return {};
  }
  if (const auto earlier = cache ? cache->find(key) : std::nullopt) return cached(*earlier, solver);
  RunLimits limits;
  limits.time_s = options.time_limit_s.value_or(limits.time_s);
  const auto n = static_cast<Index>(instance.set.points.size());
  auto sources = optimum_sources_for(catalogue, {}, n, instance.hull_size == n);
  std::erase(sources, &solver);
  return search_optimum(instance, std::move(sources), limits, cache ? &*cache : nullptr);
}

SolveReport describe(const Request& request, const Instance& instance, const Execution& execution,
                     const Judgement& judgement) {
  SolveReport report;
  report.algorithm = request.algorithm->name;
  report.parameters = request.parameters.all();
  report.seed = request.seed;
  report.threads = request.threads;
  report.n = instance.set.input_count;
  report.distinct = static_cast<Index>(instance.set.points.size());
  report.duplicates = instance.set.duplicates();
  report.hull_size = instance.hull_size;
  report.triangles = execution.solution.triangulation.triangles.size();
  report.count = execution.solution.count;
  report.stop_reason = execution.solution.stop_reason;
  report.valid = !judgement.violation;
  report.wall_time_s = execution.wall_time_s;
  report.cpu_time_s = execution.cpu_time_s;
  report.peak_rss_bytes = execution.peak_rss_bytes;
  report.phases = execution.phases;
  report.counters = execution.solution.counters;
  if (report.valid) {
    report.edges = judgement.edges;
    report.weight = judgement.weight;
    report.perimeter_sum = judgement.perimeter_sum.middle();
  }
  return report;
}

// What two searches say together. A contradiction is a failure of this program.
std::optional<Interval> combine(const std::optional<Interval>& known, const std::optional<Interval>& bounds) {
  if (!known || !bounds) return known ? known : bounds;
  const std::optional<Interval> common = intersection(*known, *bounds);
  if (!common) throw std::logic_error("the certified optima of two algorithms contradict each other");
  return common;
}

void rate(SolveReport& report, const std::optional<Interval>& claimed, const FoundOptimum& found) {
  const WitnessedOptimum own = witnessed_optimum(claimed, *report.weight);
  if (own.contradiction) throw std::logic_error(report.algorithm + " certifies more than its own triangulation weighs");
  if (found.contradiction) throw std::logic_error(found.note);
  report.optimum = combine(found.interval, own.interval);
  if (report.optimum) {
    report.optimum = combine(report.optimum, Interval{report.optimum->lower, report.weight->upper});
    report.alpha = alpha_of(*report.weight, *report.optimum);
  }
  report.optimality = name_of(optimality_of(report.optimum));
  report.optimum_cached = found.is_cached;
}

void write_files(const Options& options, const Instance& instance, const std::vector<Point>& input,
                 const Triangulation& triangulation) {
  const Triangulation in_input{instance.set.input_count, to_input_indices(instance.set, triangulation.triangles)};
  if (options.triangles) write_triangles(*options.triangles, in_input.triangles);
  if (options.edges) write_edges(*options.edges, edges_of(in_input));
  if (options.svg) write_svg(*options.svg, input, in_input);
}

void print(const Options& options, const SolveReport& report) {
  std::cout << (options.json ? to_json(report) : readable_text(report));
}

int solve(const Options& options) {
  const Catalogue catalogue = Catalogue::built_in();
  static_cast<void>(catalogue.algorithm(options.algorithm));  // a wrong name is said before a large file is read
  const std::vector<Point> input = read_points(options.points);
  const Instance instance = make_instance(input, options.points);
  const Request request = make_request(options, catalogue, instance, input);
  const Execution execution = execute_once(request, instance.set.points);
  const Judgement judgement = judge(instance.set.points, execution.solution.triangulation);
  SolveReport report = describe(request, instance, execution, judgement);
  if (judgement.violation) {
    print(options, report);
    throw std::logic_error(report.algorithm + " returned no triangulation: " + *judgement.violation);
  }
  FoundOptimum found;
  if (options.with_optimum) found = optimum_beyond(catalogue, instance, request, execution, judgement.weight, options);
  rate(report, execution.solution.optimum, found);
  write_files(options, instance, input, execution.solution.triangulation);
  print(options, report);
  return kExitOk;
}

void declare(CommandOptions& declared, Options& options) {
  declared.argument("points", options.points, "point file; - for stdin");
  declared.required("--algorithm", options.algorithm, "name of an algorithm (mwt list algorithms)");
  declared.repeated("--param", options.parameters, "a parameter of the algorithm, k=v; may be repeated");
  declared.option("--seed", options.seed, "seed of the pseudo-random numbers");
  declared.positive("--threads", options.threads, "threads that the algorithm may use");
  declared.positive("--time-limit", options.time_limit_s, "seconds after which the best so far is wanted");
  declared.flag("--with-optimum", options.with_optimum, "also look for the proved optimum, to tell alpha");
  declared.flag("--no-cache", options.no_cache, "seek that optimum anew; leave the optimum cache alone");
  declared.flag("--json", options.json, "print one JSON object");
  declared.option("--triangles", options.triangles,
                  "write the triangles (a,b,c per line; positions in the point file)");
  declared.option("--edges", options.edges, "write the edges (a,b per line)");
  declared.option("--svg", options.svg, "write a picture");
}

}  // namespace

Command solve_command() {
  const auto options = std::make_shared<Options>();
  return {"solve", "Triangulate your own points with one algorithm and say how good the result is",
          [options](CommandOptions& declared) { declare(declared, *options); }, [options] { return solve(*options); }};
}

}  // namespace mwt
