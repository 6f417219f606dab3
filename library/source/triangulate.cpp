#include "mwt/triangulate.h"

#include <chrono>
#include <utility>

#include "algorithms/proof_trace.h"
#include "geometry/checker.h"
#include "geometry/point_set.h"
#include "geometry/weight.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/proof_file.h"
#include "harness/rating/quality.h"
#include "harness/run/catalogue.h"
#include "harness/run/machine/available_memory.h"
#include "library/source/conversion.h"
#include "mwt/mwt.h"

namespace mwt::v1 {

namespace {

// Reading how much memory there is costs more than a small triangulation.
constexpr std::size_t kMinForMemory = 5000;

Context context_for(const Options& options, const AlgorithmInfo& algorithm, std::size_t n) {
  Context context;
  context.parameters = Parameters(algorithm.name, algorithm.parameters, options.parameters);
  context.seed = options.seed;
  context.threads = options.threads;
  const std::optional<std::uint64_t> available = n >= kMinForMemory ? available_memory_bytes() : std::nullopt;
  if (available) context.memory_bytes = *available / 10 * 9;
  if (options.time_limit_s) {
    const std::chrono::duration<double> limit(*options.time_limit_s);
    context.deadline = Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(limit);
  }
  return context;
}

void require_usable(const Options& options) {
  if (options.threads < 1) throw InputError("threads must be at least 1");
  if (options.time_limit_s && !(*options.time_limit_s > 0)) throw InputError("time_limit_s must be more than 0");
}

// The triangulation is checked, and bounds above its weight are a bug: as the program does.
Result result_of(const AlgorithmInfo& algorithm, const PointSet& set, Solution solution, double time_s) {
  if (const auto violation = find_violation(set.points, solution.triangulation))
    throw InternalError(algorithm.name + " returned no triangulation: " + violation->message);
  const mwt::Interval own_weight = mwt::weight(set.points, solution.triangulation);
  const WitnessedOptimum optimum = witnessed_optimum(solution.optimum, own_weight);
  if (optimum.contradiction) throw InternalError(algorithm.name + " certified more than its own triangulation weighs");
  Result result;
  result.weight = outer_interval(own_weight);
  if (optimum.interval) result.optimum = outer_interval(*optimum.interval);
  result.is_proved = optimality_of(optimum.interval) == Optimality::proved;
  if (solution.stop_reason) result.stop_reason = name_of(*solution.stop_reason);
  result.counters = std::move(solution.counters);
  result.time_s = time_s;
  result.triangles = set.duplicates() == 0 ? std::move(solution.triangulation.triangles)
                                           : to_input_indices(set, solution.triangulation.triangles);
  return result;
}

Result run(std::span<const Point> points, const Options& options, const std::string& proof_file) {
  require_usable(options);
  const Catalogue catalogue = Catalogue::built_in();
  const AlgorithmInfo& algorithm = catalogue.algorithm(options.algorithm);
  const PointSet set = make_point_set(inner_points(points), "the points");
  Context context = context_for(options, algorithm, set.points.size());
  ProofTrace trace;
  if (!proof_file.empty()) context.proof = &trace;
  const auto begin = Context::Clock::now();
  Solution solution = algorithm.function(set.points, context);
  const std::chrono::duration<double> elapsed = Context::Clock::now() - begin;
  if (!proof_file.empty()) {
    if (!trace.is_complete || !solution.optimum) throw InternalError(algorithm.name + " has no proof");
    static_cast<void>(write_proof(proof_file, set.points, trace, solution.triangulation, *solution.optimum));
  }
  return result_of(algorithm, set, std::move(solution), elapsed.count());
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
