#include "harness/benchmark/prepared_cell.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "geometry/delaunay.h"
#include "geometry/error.h"
#include "harness/quality.h"
#include "harness/statistics/quantile.h"
#include "harness/study/optimum_search.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

constexpr Index kLargestN = 1000000;
constexpr double kOptimumTime = 2;

double median_yardstick_s(Points points) {
  std::vector<double> times;
  for (int i = 0; i < 7; ++i) times.push_back(measure_yardstick_s(points));
  return median(times);
}

std::optional<Interval> cheap_optimum(const Catalogue& catalogue, const Instance& instance) {
  const auto n = static_cast<Index>(instance.set.points.size());
  if (n > kLargestRatedN) return std::nullopt;
  FoundOptimum result;
  ProcessPool pool(1);
  RunLimits limits;
  limits.time_s = kOptimumTime;
  seek_optimum(pool, std::make_shared<const Instance>(instance), optimum_sources_for(catalogue, {}, n), limits, nullptr,
               [&](const FoundOptimum& found) { result = found; });
  while (!pool.is_empty()) pool.wait(std::chrono::seconds(1));
  return result.interval;
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

std::string BenchmarkCell::name() const { return algorithm->name + '/' + family->name + '/' + std::to_string(n); }

std::vector<BenchmarkCell> benchmark_cells(const Catalogue& catalogue) {
  std::vector<BenchmarkCell> cells;
  for (const AlgorithmInfo& algorithm : catalogue.algorithms()) {
    for (const GeneratorInfo& family : catalogue.generators()) {
      const Index of_family = family.largest_n == 0 ? kLargestN : family.largest_n;
      const Index largest = std::min({kLargestN, largest_n_for(algorithm, {}), of_family});
      if (family.fixed_n != 0) {
        if (family.fixed_n <= largest_n_for(algorithm, {})) cells.push_back({&algorithm, &family, family.fixed_n});
        continue;
      }
      for (Index n = 10; n <= largest; n *= 10) cells.push_back({&algorithm, &family, n});
    }
  }
  return cells;
}

PreparedCell prepare(const Catalogue& catalogue, const BenchmarkCell& cell) {
  PreparedCell prepared;
  try {
    const Parameters of_family(cell.family->name, cell.family->parameters, {});
    prepared.instance = make_instance(generate_points(*cell.family, cell.n, 1, of_family), cell.family->name);
    prepared.request.algorithm = cell.algorithm;
    prepared.request.parameters = Parameters(cell.algorithm->name, cell.algorithm->parameters, {});
    verify(catalogue, prepared);
    prepared.yardstick_s = median_yardstick_s(prepared.instance.set.points);
  } catch (const NotApplicable& reason) {
    prepared.reason_to_skip = reason.what();
  } catch (const InputError& error) {
    prepared.reason_to_skip = error.what();
  }
  return prepared;
}

}  // namespace mwt
