#include "harness/benchmark/prepared_cell.h"

#include <fmt/core.h>

#include <algorithm>
#include <iostream>

#include "base/error.h"
#include "geometry/delaunay.h"
#include "harness/rating/optimum_search.h"
#include "harness/statistics/quantile.h"

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

// A claim that a triangulation disproves counts no more, and its solver is wrong.
void report_contradiction(const std::string& instance, const std::string& what) {
  std::cerr << instance << ": " << what << '\n';
}

// What is certified about an instance with few enough points; null for others. Cells follow one another by algorithm,
// and instances come again and again: each is solved once. In this process, for a child's copy of Google Benchmark
// would write to its output file, too.
OptimumClaims* cheap_optimum(const Catalogue& catalogue, const Instance& instance, const std::string& label) {
  static std::map<std::string, OptimumClaims> optima;
  const auto n = static_cast<Index>(instance.set.points.size());
  if (n > kMaxRatedN) return nullptr;
  const auto [entry, is_new] = optima.try_emplace(instance.id);
  if (is_new) {
    const FoundOptimum found = seek_optimum_here(instance, optimum_sources_for(catalogue, {}, n), kOptimumTime);
    for (const std::string& what : found.contradictions) report_contradiction(label, what);
    if (found.interval) static_cast<void>(entry->second.add_claim({"optimum", found.source, *found.interval}));
  }
  return &entry->second;
}

void verify(const Catalogue& catalogue, PreparedCell& cell, const std::string& label) {
  const Points points = cell.instance.set.points;
  const AlgorithmInfo& algorithm = *cell.request.algorithm;
  cell.run = judged(algorithm, points, execute_once(cell.request, points));
  if (cell.run.status == RunStatus::invalid_output) {
    cell.reason_to_skip = "invalid output: " + cell.run.message;
    return;
  }
  if (is_disproved(cell.run)) report_contradiction(label, cell.run.message);
  if (OptimumClaims* claims = cheap_optimum(catalogue, cell.instance, label)) {
    for (const Disproof& disproof : add_run(*claims, "run", algorithm.name, cell.run)) {
      report_contradiction(label, disproof.text());
      if (disproof.claim.id == "run") reject(cell.run, disproof);
    }
    rate(cell.run, claims->bounds());
  }
  cell.reason_to_skip = cell.run.message;  // empty unless its bound is disproved
}

}  // namespace

std::string BenchmarkCell::name() const {
  return fmt::format("{}/{}/{}", with_parameters(algorithm->name, algorithm_parameters),
                     with_parameters(family->name, family_parameters), n);
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
    verify(catalogue, prepared, fmt::format("{} n={}", cell.family->name, cell.n));
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
