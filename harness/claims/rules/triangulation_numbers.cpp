// C11: the number of triangulations.
#include "harness/claims/rules/triangulation_numbers.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <set>

#include "base/number_text.h"
#include "harness/claims/rules/rules.h"
#include "harness/io/text/text.h"

namespace mwt {

Runs counting_runs(const StudyRecords& records) {
  return finished_runs(records, [](const RunRecord& run) {
    const bool counts = run.algorithm == "brute_force" || run.algorithm == "subset_dp";
    return counts && !run.triangulation_count.empty();
  });
}

std::map<std::string, GrowthFactor> growth_factors(const Runs& runs, Index min_n) {
  std::map<std::string, GrowthFactor> factors;
  for (const auto& [family, of_family] : by_family(runs)) {
    GrowthFactor growth;
    std::set<std::string> instances;
    std::set<Index> sizes;
    std::vector<Measurement> measurements;
    for (const RunRecord* run : of_family) {
      const std::optional<double> count = parse_number(run->triangulation_count);
      const bool can_be_fitted = count && *count > 0 && std::isfinite(*count);
      if (run->n < min_n || !can_be_fitted || !instances.insert(run->instance_id).second) continue;
      growth.runs.push_back(run);
      sizes.insert(run->n);
      // A power law in exp(n) is an exponential one in n.
      measurements.push_back({std::exp(run->n), *count});
    }
    if (sizes.size() < 3) continue;
    const Estimate slope = fit_power_law(measurements)->exponent;
    growth.factor = {std::exp(slope.value), std::exp(slope.lower), std::exp(slope.upper)};
    factors.emplace(family, std::move(growth));
  }
  return factors;
}

std::string factor_text(const Estimate& factor) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", factor.value, factor.lower, factor.upper);
}

std::string catalan_number(unsigned k) {
  std::uint64_t number = 1;
  for (unsigned i = 0; i < k; ++i) {
    // C(i+1) = C(i) 2 (2i+1) / (i+2), divided first where that leaves no remainder, to stay within 64 bits.
    const std::uint64_t factor = 2 * (2 * std::uint64_t{i} + 1), divisor = std::uint64_t{i} + 2;
    const std::uint64_t whole = number / divisor, rest = number % divisor;
    number = whole * factor + rest * factor / divisor;
  }
  return std::to_string(number);
}

bool is_convex_family(const std::string& family) { return family == "circle" || family == "integer_circle"; }

namespace claims {

namespace {

constexpr Index kMaxPoints = 37;  // of which the Catalan number fits

Finding judge_triangulation_numbers(const StudyRecords& records) {
  Finding finding;
  finding.rows = counting_runs(records);
  finding.details.header = {"algorithm", "family", "n", "seed", "triangulations", "Catalan C(n-2)"};
  std::size_t convex = 0, agreeing = 0;
  Index largest = 0;
  for (const RunRecord* run : finding.rows) {
    const bool is_convex = is_convex_family(run->generator) && run->n <= kMaxPoints;
    const std::string catalan = is_convex ? catalan_number(run->n - 2) : "";
    finding.details.rows.push_back({run->algorithm, run->generator, std::to_string(run->n), std::to_string(run->seed),
                                    run->triangulation_count, catalan});
    if (!is_convex) continue;
    ++convex;
    agreeing += run->triangulation_count == catalan ? 1U : 0U;
    largest = std::max(largest, run->n);
  }
  finding.missing = fmt::format("counts in convex position (circle, integer_circle), n at most {}", kMaxPoints);
  if (convex == 0) return finding;
  finding.missing = "counts on uniform points at three sizes, which would show that their number grows";
  const auto factors = growth_factors(finding.rows, 3);
  const auto uniform = factors.find("uniform");
  const bool grows = uniform != factors.end() && uniform->second.factor.lower > 1;
  finding.verdict = agreeing < convex ? ClaimVerdict::refuted
                    : grows           ? ClaimVerdict::reproduced
                                      : ClaimVerdict::undecided;
  finding.measured = fmt::format("{} of {} counts in convex position, up to n = {}, are the Catalan number C(n-2)",
                                 grouped(agreeing), grouped(convex), grouped(largest));
  if (uniform != factors.end()) {
    finding.measured += "; uniform sets multiply by " + factor_text(uniform->second.factor) + " per point";
  }
  return finding;
}

}  // namespace

Claim triangulation_numbers() {
  return {
      "C11",
      "A convex polygon of n points has C(n-2) triangulations (Catalan); in general the number is exponential",
      "4.2",
      "counts of brute_force and subset_dp; convex position: circle, integer_circle",
      "reproduced: every count in convex position is the Catalan number, and on uniform points the number's growth per "
      "point is above 1 with 95% confidence; refuted: some count is another; otherwise undecided",
      "mwt generate integer_circle --n 16 -o p.csv && mwt solve p.csv --algorithm subset_dp",
      judge_triangulation_numbers};
}

}  // namespace claims

}  // namespace mwt
