#include "harness/benchmark/prepared_cell.h"

#include <algorithm>

#include "geometry/delaunay.h"
#include "geometry/error.h"
#include "harness/quality.h"
#include "harness/statistics/quantile.h"
#include "harness/study/optimum_search.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

constexpr double kOptimumTime = 30;

// Rows besides those with default parameters.
struct Variant {
  std::string name;
  GivenParameters parameters;
};
const std::vector<Variant>& algorithm_variants() {
  static const std::vector<Variant> variants = {
      {"flip", {{"order", "best"}}}, {"patch", {{"k", "4"}}}, {"patch", {{"k", "14"}}}};
  return variants;
}
const std::vector<Variant>& family_variants() {
  static const std::vector<Variant> variants = {{"clustered", {{"clusters", "50"}, {"sigma", ".01"}}}};
  return variants;
}

// The empty set of parameters and those of the variants of that name.
std::vector<GivenParameters> variants_of(const std::string& name, const std::vector<Variant>& all) {
  std::vector<GivenParameters> result(1);
  for (const Variant& variant : all) {
    if (variant.name == name) result.push_back(variant.parameters);
  }
  return result;
}

std::string with_parameters(const std::string& name, const GivenParameters& parameters) {
  std::string result = name;
  for (const auto& [key, value] : parameters) result += (result == name ? ':' : ',') + (key + '=' + value);
  return result;
}

// Cells follow one another by algorithm, instances come again and again.
std::map<std::string, std::optional<Interval>>& known_optima() {
  static std::map<std::string, std::optional<Interval>> optima;
  return optima;
}

// In this process: a worker of the harness measures with Google Benchmark, whose output file is open here.
std::optional<Interval> seek_optimum_here(const Catalogue& catalogue, const Instance& instance) {
  const Points points = instance.set.points;
  std::optional<Interval> best;
  for (const AlgorithmInfo* source : optimum_sources_for(catalogue, {}, static_cast<Index>(points.size()))) {
    Request request;
    request.algorithm = source;
    request.parameters = Parameters(source->name, source->parameters, {});
    request.time_limit_s = kOptimumTime;
    try {
      const Solution solution = execute_once(request, points).solution;
      if (!solution.optimum || judge(points, solution.triangulation).violation) continue;
      if (!best || solution.optimum->width() < best->width()) best = solution.optimum;
    } catch (const NotApplicable&) {
      continue;
    }
    if (optimality_of(best) == Optimality::proved) break;
  }
  return best;
}

std::optional<Interval> cheap_optimum(const Catalogue& catalogue, const Instance& instance) {
  if (instance.set.points.size() > kLargestRatedN) return std::nullopt;
  const auto known = known_optima().find(instance.id);
  if (known != known_optima().end()) return known->second;
  return known_optima()[instance.id] = seek_optimum_here(catalogue, instance);
}

void verify(const Catalogue& catalogue, PreparedCell& cell) {
  const Points points = cell.instance.set.points;
  const Execution execution = execute_once(cell.request, points);
  const Judgement judgement = judge(points, execution.solution.triangulation);
  if (judgement.violation) {
    cell.reason_to_skip = "invalid output: " + *judgement.violation;
  } else if (const auto optimum = cheap_optimum(catalogue, cell.instance)) {
    cell.alpha = alpha_of(judgement.weight, *optimum);
  }
}

}  // namespace

std::string BenchmarkCell::name() const {
  return with_parameters(algorithm->name, algorithm_parameters) + '/' +
         with_parameters(family->name, family_parameters) + '/' + std::to_string(n);
}

namespace {

std::vector<Index> sizes(const AlgorithmInfo& algorithm, const GeneratorInfo& family, Index largest_n) {
  const Index of_algorithm = largest_n_for(algorithm, {});
  if (family.fixed_n != 0) {
    return family.fixed_n <= of_algorithm ? std::vector<Index>{family.fixed_n} : std::vector<Index>{};
  }
  const Index of_family = family.largest_n == 0 ? largest_n : family.largest_n;
  std::vector<Index> result;
  for (Index n = 10; n <= std::min({largest_n, of_algorithm, of_family}); n *= 10) result.push_back(n);
  return result;
}

}  // namespace

std::vector<BenchmarkCell> benchmark_cells(const Catalogue& catalogue, Index largest_n) {
  std::vector<BenchmarkCell> cells;
  for (const AlgorithmInfo& algorithm : catalogue.algorithms()) {
    for (const GivenParameters& of_algorithm : variants_of(algorithm.name, algorithm_variants())) {
      for (const GeneratorInfo& family : catalogue.generators()) {
        for (const GivenParameters& of_family : variants_of(family.name, family_variants())) {
          for (const Index n : sizes(algorithm, family, largest_n)) {
            cells.push_back({&algorithm, of_algorithm, &family, of_family, n});
          }
        }
      }
    }
  }
  return cells;
}

PreparedCell prepare(const Catalogue& catalogue, const BenchmarkCell& cell) {
  PreparedCell prepared;
  try {
    const Parameters of_family(cell.family->name, cell.family->parameters, cell.family_parameters);
    prepared.instance = make_instance(generate_points(*cell.family, cell.n, 1, of_family), cell.family->name);
    prepared.request.algorithm = cell.algorithm;
    prepared.request.parameters =
        Parameters(cell.algorithm->name, cell.algorithm->parameters, cell.algorithm_parameters);
    verify(catalogue, prepared);
  } catch (const NotApplicable& reason) {
    prepared.reason_to_skip = reason.what();
  } catch (const InputError& error) {
    prepared.reason_to_skip = error.what();
  }
  return prepared;
}

void TimeOverYardstick::measure_yardstick(Points points) {
  if (yardstick_s_.size() < kYardsticks) yardstick_s_.push_back(measure_yardstick_s(points));
}

double TimeOverYardstick::ratio(Points points) {
  while (yardstick_s_.size() < kYardsticks) measure_yardstick(points);
  return median(algorithm_s_) / median(yardstick_s_);
}

}  // namespace mwt
