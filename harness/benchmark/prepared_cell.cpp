#include "harness/benchmark/prepared_cell.h"

#include <algorithm>
#include <iostream>

#include "base/error.h"
#include "geometry/delaunay.h"
#include "harness/rating/optimum_claims.h"
#include "harness/rating/optimum_search.h"
#include "harness/rating/quality.h"
#include "harness/statistics/quantile.h"
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
std::map<std::string, OptimumClaims>& known_optima() {
  static std::map<std::string, OptimumClaims> optima;
  return optima;
}

// Claims of solvers that a triangulation disproves: they count no more, and their solver is wrong.
void complain(const std::string& instance, const std::vector<Disproof>& disproofs) {
  for (const Disproof& disproof : disproofs) std::cerr << instance << ": " << disproof.text() << '\n';
}

// What a checked solution certifies.
std::vector<Disproof> add(OptimumClaims& claims, const std::string& solver, const Solution& solution,
                          const Interval& weight) {
  const WitnessedOptimum optimum = witnessed_optimum(solution.optimum, weight);
  if (optimum.contradiction) return {{{solver, solver, *solution.optimum}, "", weight.upper}};
  if (!optimum.interval) return claims.add_weight({solver, weight.upper});
  return claims.add_claim({solver, solver, *optimum.interval});
}

// In this process: a worker of the harness measures with Google Benchmark, whose output file is open here.
OptimumClaims seek_optimum_here(const Catalogue& catalogue, const Instance& instance, const std::string& label) {
  const Points points = instance.set.points;
  OptimumClaims claims;
  for (const AlgorithmInfo* source : optimum_sources_for(catalogue, {}, static_cast<Index>(points.size()))) {
    Request request;
    request.algorithm = source;
    request.parameters = Parameters(source->name, source->parameters, {});
    request.time_limit_s = kOptimumTime;
    try {
      const Solution solution = execute_once(request, points).solution;
      const Judgement judgement = judge(points, solution.triangulation);
      if (!judgement.violation) complain(label, add(claims, source->name, solution, judgement.weight));
    } catch (const NotApplicable&) {
      continue;
    }
    if (optimality_of(claims.bounds()) == Optimality::proved) break;
  }
  return claims;
}

// Of an instance with few enough points; null otherwise.
OptimumClaims* cheap_optimum(const Catalogue& catalogue, const Instance& instance, const std::string& label) {
  if (instance.set.points.size() > kMaxRatedN) return nullptr;
  const auto [entry, is_new] = known_optima().try_emplace(instance.id);
  if (is_new) entry->second = seek_optimum_here(catalogue, instance, label);
  return &entry->second;
}

void rate(PreparedCell& cell, OptimumClaims& claims, const Solution& solution, const Interval& weight,
          const std::string& label) {
  const std::string& name = cell.request.algorithm->name;
  const std::vector<Disproof> disproofs = add(claims, name, solution, weight);
  complain(label, disproofs);
  for (const Disproof& disproof : disproofs) {
    if (disproof.claim.id == name) cell.reason_to_skip = disproof.text();
  }
  if (const auto optimum = claims.bounds()) cell.alpha = alpha_of(weight, *optimum);
}

void verify(const Catalogue& catalogue, PreparedCell& cell, const std::string& label) {
  const Points points = cell.instance.set.points;
  const Execution execution = execute_once(cell.request, points);
  const Judgement judgement = judge(points, execution.solution.triangulation);
  if (judgement.violation) {
    cell.reason_to_skip = "invalid output: " + *judgement.violation;
  } else if (OptimumClaims* claims = cheap_optimum(catalogue, cell.instance, label)) {
    rate(cell, *claims, execution.solution, judgement.weight, label);
  }
}

}  // namespace

std::string BenchmarkCell::name() const {
  return with_parameters(algorithm->name, algorithm_parameters) + '/' +
         with_parameters(family->name, family_parameters) + '/' + std::to_string(n);
}

namespace {

std::vector<Index> sizes(const AlgorithmInfo& algorithm, const GeneratorInfo& family, Index max_n) {
  const Index of_algorithm = max_n_for(algorithm, {});
  if (family.fixed_n != 0) {
    return family.fixed_n <= of_algorithm ? std::vector<Index>{family.fixed_n} : std::vector<Index>{};
  }
  const Index of_family = family.max_n == 0 ? max_n : family.max_n;
  std::vector<Index> result;
  for (Index n = 10; n <= std::min({max_n, of_algorithm, of_family}); n *= 10) result.push_back(n);
  return result;
}

}  // namespace

std::vector<BenchmarkCell> benchmark_cells(const Catalogue& catalogue, Index max_n) {
  std::vector<BenchmarkCell> cells;
  for (const AlgorithmInfo& algorithm : catalogue.algorithms()) {
    for (const GivenParameters& of_algorithm : variants_of(algorithm.name, algorithm_variants())) {
      for (const GeneratorInfo& family : catalogue.generators()) {
        for (const GivenParameters& of_family : variants_of(family.name, family_variants())) {
          for (const Index n : sizes(algorithm, family, max_n)) {
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
    verify(catalogue, prepared, cell.family->name + " n=" + std::to_string(cell.n));
  } catch (const std::exception& reason) {  // the others are timed all the same
    prepared.reason_to_skip = reason.what();
  }
  return prepared;
}

void TimeOverDelaunay::measure_delaunay_time(Points points) {
  if (delaunay_times_s_.size() < kDelaunayTimes) delaunay_times_s_.push_back(measure_delaunay_time_s(points));
}

double TimeOverDelaunay::ratio(Points points) {
  while (delaunay_times_s_.size() < kDelaunayTimes) measure_delaunay_time(points);
  return median(algorithm_s_) / median(delaunay_times_s_);
}

}  // namespace mwt
