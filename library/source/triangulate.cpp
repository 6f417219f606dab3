#include "mwt/triangulate.h"

#include <chrono>
#include <utility>

#include "algorithms/proof_trace.h"
#include "geometry/point_set.h"
#include "geometry/weight.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/proof_file.h"
#include "harness/rating/quality.h"
#include "harness/rating/rated_run.h"
#include "harness/run/catalogue.h"
#include "harness/run/execution.h"
#include "library/source/conversion.h"
#include "mwt/mwt.h"

namespace mwt::v1 {

namespace {

void require_usable(const Options& options) {
  if (options.threads < 1) throw InputError("threads must be at least 1");
  if (options.time_limit_s && !(*options.time_limit_s > 0)) throw InputError("time_limit_s must be more than 0");
}

Request request_for(const Options& options, const AlgorithmInfo& algorithm) {
  Request request;
  request.algorithm = &algorithm;
  request.parameters = Parameters(algorithm.name, algorithm.parameters, options.parameters);
  request.seed = options.seed;
  request.threads = options.threads;
  request.time_limit_s = options.time_limit_s;
  request.interrupt = options.interrupt;
  return request;
}

// A run that is not ok is a bug, as in the program.
Result result_of(const RatedRun& run, const PointSet& set, std::vector<mwt::Triangle> triangles) {
  if (run.status != RunStatus::ok) throw InternalError(run.message);
  Result result;
  result.weight = {run.weight_lower.value(), run.weight_upper.value()};
  if (run.certified_lower) result.optimum = Interval{*run.certified_lower, result.weight.upper};
  result.is_proved = run.optimality == name_of(Optimality::proved);
  if (run.stop_reason) result.stop_reason = name_of(*run.stop_reason);
  result.counters = {run.counters.begin(), run.counters.end()};
  result.time_s = run.wall_time_s.value();
  result.triangles = set.duplicates() == 0 ? std::move(triangles) : to_input_indices(set, triangles);
  return result;
}

Result run(std::span<const Point> points, const Options& options, const std::string& proof_file) {
  require_usable(options);
  const Catalogue catalogue = Catalogue::built_in();
  const AlgorithmInfo& algorithm = catalogue.algorithm(options.algorithm);
  const PointSet set = make_point_set(inner_points(points), "the points");
  Request request = request_for(options, algorithm);
  ProofTrace trace;
  if (!proof_file.empty()) request.proof = &trace;
  const auto begin = Context::Clock::now();
  Execution execution = solve_unmeasured(request, set.points);
  execution.wall_time_s = std::chrono::duration<double>(Context::Clock::now() - begin).count();
  Solution& solution = execution.solution;
  if (!proof_file.empty()) {
    if (!trace.is_complete || !solution.optimum) throw InternalError(algorithm.name + " has no proof");
    static_cast<void>(write_proof(proof_file, set.points, trace, solution.triangulation, *solution.optimum));
  }
  RatedRun run = judged(algorithm, set.points, execution);
  rate(run, run.certified_lower ? std::optional(mwt::Interval{*run.certified_lower, run.weight_upper.value()})
                                : std::nullopt);
  return result_of(run, set, std::move(solution.triangulation.triangles));
}

GivenSolution given(std::span<const Triangle> triangles) {
  GivenSolution solution;
  solution.triangles.assign(triangles.begin(), triangles.end());
  return solution;
}

template <class Infos>
std::vector<Entry> entries_of(const Infos& infos) {
  std::vector<Entry> entries;
  for (const auto& info : infos) {
    Entry entry{info.name, info.summary, {}};
    for (const ParameterInfo& parameter : info.parameters)
      entry.parameters.push_back({parameter.name, parameter.default_value, parameter.summary});
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

Result triangulate(std::span<const Point> points, const Options& options) {
  return with_errors_of_the_library([&] { return run(points, options, ""); });
}

Result minimum_weight_triangulation(std::span<const Point> points, const SolveOptions& options) {
  return with_errors_of_the_library([&] {
    Options own;
    own.algorithm = "exact";
    own.threads = options.threads;
    own.time_limit_s = options.time_limit_s;
    own.interrupt = options.interrupt;
    return run(points, own, options.proof_file);
  });
}

Interval alpha(const Interval& weight, const Interval& optimum) {
  return outer_interval(alpha_of({weight.lower, weight.upper}, {optimum.lower, optimum.upper}));
}

Interval weight(std::span<const Point> points, std::span<const Triangle> triangles) {
  return with_errors_of_the_library([&] {
    if (const auto rule = broken_rule(points, triangles))
      throw InputError("no triangulation of these points: " + *rule);
    const std::vector<mwt::Point> input = inner_points(points);
    const PointSet set = make_point_set(input, "the points");
    return outer_interval(mwt::weight(set.points, from_input_indices(set, input, given(triangles).triangles)));
  });
}

std::optional<std::string> broken_rule(std::span<const Point> points, std::span<const Triangle> triangles) {
  return with_errors_of_the_library([&] {
    const std::vector<mwt::Point> input = inner_points(points);
    return mwt::broken_rule(make_point_set(input, "the points"), input, given(triangles));
  });
}

std::vector<Entry> algorithms() { return entries_of(Catalogue::built_in().algorithms()); }

std::vector<Entry> families() { return entries_of(Catalogue::built_in().generators()); }

std::vector<Point> generate(const std::string& family, std::uint32_t n, std::uint64_t seed,
                            const std::map<std::string, std::string>& parameters) {
  return with_errors_of_the_library([&] {
    const Catalogue catalogue = Catalogue::built_in();
    const GeneratorInfo& info = catalogue.generator(family);
    return outer_points(generate_points(info, n, seed, Parameters(info.name, info.parameters, parameters)));
  });
}

}  // namespace mwt::v1
