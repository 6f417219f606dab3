#include "harness/report/growth_laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"
#include "harness/statistics/power_law.h"

namespace mwt {

namespace {

constexpr double kWidestAlpha = .01;  // relative width of a certified alpha that still counts

// Certified alphas of the instances to which a law applies, by n.
using Alphas = std::multimap<Index, Interval>;

Alphas alphas_for(const GeneratorInfo& family, const GrowthLaw& law, const std::vector<RunRecord>& runs,
                  const Catalogue& catalogue) {
  const AlgorithmInfo& algorithm = catalogue.algorithm(law.algorithm);
  const std::string params = Parameters(algorithm.name, algorithm.parameters, law.algorithm_parameters).canonical();
  const std::string family_params = Parameters(family.name, family.parameters, law.parameters).canonical();
  Alphas alphas;
  std::set<std::string> seen;
  for (const RunRecord& run : runs) {
    const bool is_meant = run.generator == family.name && run.generator_params == family_params &&
                          run.algorithm == law.algorithm && run.params == params && run.n >= law.min_n &&
                          run.n <= law.max_n;
    if (!is_meant || run.status != RunStatus::ok || !run.alpha_lower || !run.alpha_upper) continue;
    const Interval alpha{*run.alpha_lower, *run.alpha_upper};
    if (alpha.relative_width() <= kWidestAlpha && seen.insert(run.instance_id).second) alphas.emplace(run.n, alpha);
  }
  return alphas;
}

// The smallest and the largest slope from the mean of one size to that of the next, in logarithms.
Interval neighbouring_slopes(const Alphas& alphas) {
  std::vector<std::pair<double, double>> means;  // log n, mean of log alpha
  for (auto it = alphas.begin(); it != alphas.end();) {
    const auto end = alphas.upper_bound(it->first);
    double sum = 0;
    const auto count = static_cast<double>(std::distance(it, end));
    const double log_n = std::log(it->first);
    for (; it != end; ++it) sum += std::log(it->second.middle());
    means.emplace_back(log_n, sum / count);
  }
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 1; i < means.size(); ++i) {
    const double slope = (means[i].second - means[i - 1].second) / (means[i].first - means[i - 1].first);
    range = {std::min(range.lower, slope), std::max(range.upper, slope)};
  }
  return range;
}

void test_power(LawFinding& finding, const Alphas& alphas) {
  if (finding.sizes < 3 || finding.max_n / 4 < finding.min_n) return;
  std::vector<Measurement> measurements;
  for (const auto& [n, alpha] : alphas) measurements.push_back({static_cast<double>(n), alpha.middle()});
  const PowerLaw fit = fit_power_law(measurements).value();
  finding.measured = fit.exponent;
  if (!fit.has_interval) {
    const Interval slopes = neighbouring_slopes(alphas);
    finding.measured.lower = slopes.lower;
    finding.measured.upper = slopes.upper;
  }
  const GrowthLaw& law = *finding.law;
  const bool is_inside = finding.measured.value >= law.lowest && finding.measured.value <= law.highest;
  const bool is_outside = finding.measured.upper < law.lowest || finding.measured.lower > law.highest;
  finding.agreement = is_inside ? Agreement::agrees : is_outside ? Agreement::disagrees : Agreement::undecided;
}

void test_range(LawFinding& finding, const Alphas& alphas) {
  const GrowthLaw& law = *finding.law;
  Interval range = alphas.begin()->second;
  bool all_inside = true, some_outside = false;
  for (const auto& [n, alpha] : alphas) {
    range = {std::min(range.lower, alpha.lower), std::max(range.upper, alpha.upper)};
    all_inside = all_inside && alpha.lower >= law.lowest && alpha.upper <= law.highest;
    some_outside = some_outside || alpha.upper < law.lowest || alpha.lower > law.highest;
  }
  finding.measured = {range.middle(), range.lower, range.upper};
  finding.agreement = all_inside ? Agreement::agrees : some_outside ? Agreement::disagrees : Agreement::undecided;
}

LawFinding tested(const GeneratorInfo& family, const GrowthLaw& law, const Alphas& alphas) {
  LawFinding finding;
  finding.family = &family;
  finding.law = &law;
  for (auto it = alphas.begin(); it != alphas.end(); it = alphas.upper_bound(it->first)) ++finding.sizes;
  finding.min_n = alphas.begin()->first;
  finding.max_n = alphas.rbegin()->first;
  if (law.kind == GrowthLaw::Kind::power) {
    test_power(finding, alphas);
  } else {
    test_range(finding, alphas);
  }
  return finding;
}

std::string with_parameters(const std::string& name, const std::map<std::string, std::string>& parameters) {
  std::string text = name;
  for (const auto& [key, value] : parameters) text += ' ' + key + '=' + value;
  return text;
}

std::string interval_text(double lower, double upper, int decimals) {
  return fmt::format("[{}, {}]", fixed(lower, decimals), fixed(upper, decimals));
}

}  // namespace

std::string_view name_of(Agreement agreement) {
  switch (agreement) {
    case Agreement::agrees: return "agrees";
    case Agreement::disagrees: return "DISAGREES";
    case Agreement::undecided: return "undecided";
    case Agreement::too_few_sizes: return "too few sizes";
  }
  return "undecided";
}

std::vector<LawFinding> test_growth_laws(const std::vector<RunRecord>& runs, const Catalogue& catalogue) {
  std::vector<LawFinding> findings;
  for (const GeneratorInfo& family : catalogue.generators()) {
    for (const GrowthLaw& law : family.growth_laws) {
      const Alphas alphas = alphas_for(family, law, runs, catalogue);
      if (!alphas.empty()) findings.push_back(tested(family, law, alphas));
    }
  }
  return findings;
}

std::string growth_law_table(const std::vector<LawFinding>& findings) {
  if (findings.empty()) return "";
  AlignedTable table({"family", "algorithm", "n", "sizes", "law", "measured", "verdict"}, {1, 4, 5, 6});
  for (const LawFinding& finding : findings) {
    const GrowthLaw& law = *finding.law;
    const bool is_power = law.kind == GrowthLaw::Kind::power;
    const bool is_known = finding.agreement != Agreement::too_few_sizes;
    const std::string interval = interval_text(finding.measured.lower, finding.measured.upper, 4);
    const std::string measured = is_power ? fixed(finding.measured.value, 3) + ' ' + interval : interval;
    table.add_row({with_parameters(finding.family->name, law.parameters),
                   with_parameters(law.algorithm, law.algorithm_parameters),
                   fmt::format("{}..{}", finding.min_n, finding.max_n), std::to_string(finding.sizes),
                   (is_power ? "exponent " : "alpha ") + interval_text(law.lowest, law.highest, is_power ? 2 : 4),
                   is_known ? measured : "-", std::string(name_of(finding.agreement))});
  }
  return table.text();
}

}  // namespace mwt
