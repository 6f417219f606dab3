#include "harness/report/tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr int kAlphaDigits = 5;
constexpr int kExponentDigits = 3;
constexpr const char* kNothing = "-";

// 0% and 100% mean none and all.
std::string percent(double share) {
  const double rounded = std::round(100 * share);
  return fixed(share > 0 && share < 1 ? std::clamp(rounded, 1.0, 99.0) : rounded, 0) + '%';
}

std::string duration(const std::optional<Statistic>& time) {
  return time ? readable_duration(time->estimate.value) : kNothing;
}

std::string duration_range(const std::optional<Statistic>& time) {
  if (!time || !time->has_interval) return kNothing;
  return readable_duration(time->estimate.lower) + " .. " + readable_duration(time->estimate.upper);
}

std::string alpha(const std::optional<Statistic>& statistic) {
  return statistic ? fixed(statistic->estimate.value, kAlphaDigits) : kNothing;
}

// What would be shown as "-0.000" is shown as 0.
double without_sign_of_zero(double exponent) { return std::abs(exponent) < 0.0005 ? 0 : exponent; }

std::string range(const Estimate& estimate, int digits) {
  return fixed(without_sign_of_zero(estimate.lower), digits) + " .. " +
         fixed(without_sign_of_zero(estimate.upper), digits);
}

std::string alpha_range(const std::optional<Statistic>& statistic) {
  return statistic && statistic->has_interval ? range(statistic->estimate, kAlphaDigits) : kNothing;
}

// Several cells as one: their instances side by side.
struct Total {
  std::size_t runs = 0;
  std::size_t failures = 0;
  std::size_t not_applicable = 0;
  std::size_t optimal = 0;
  std::vector<double> alphas;
  double max_alpha = 0;

  void add(const Cell& cell) {
    runs += cell.runs;
    failures += cell.failures;
    not_applicable += cell.not_applicable;
    optimal += cell.optimal;
    alphas.insert(alphas.end(), cell.alphas.begin(), cell.alphas.end());
    max_alpha = std::max(max_alpha, cell.max_alpha);
  }

  [[nodiscard]] std::vector<std::string> row(const std::string& name) const {
    std::vector<std::string> cells = {name, std::to_string(runs), std::to_string(failures),
                                      std::to_string(not_applicable), std::to_string(alphas.size())};
    if (alphas.empty()) {
      cells.insert(cells.end(), 5, kNothing);
      return cells;
    }
    const auto count = static_cast<double>(alphas.size());
    const double mean = std::accumulate(alphas.begin(), alphas.end(), 0.0) / count;
    for (const double value : {mean, median(alphas), quantile(alphas, 0.95), max_alpha})
      cells.push_back(fixed(value, kAlphaDigits));
    cells.push_back(percent(static_cast<double>(optimal) / count));
    return cells;
  }
};

// Tables with the same columns, each under the name of its family. Families come one after the other.
class FamilyTables {
 public:
  explicit FamilyTables(std::vector<std::string> header) : header_(std::move(header)) {}

  void add_row(const std::string& family, std::vector<std::string> cells) {
    if (tables_.empty() || tables_.back().first != family) tables_.emplace_back(family, AlignedTable(header_));
    tables_.back().second.add_row(std::move(cells));
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [family, table] : tables_) text += (text.empty() ? "" : "\n") + family + '\n' + table.text("  ");
    return text;
  }

 private:
  std::vector<std::string> header_;
  std::vector<std::pair<std::string, AlignedTable>> tables_;
};

std::vector<std::string> cell_row(const CellSummary& summary, const Labels& labels) {
  const Cell& cell = summary.cell;
  return {labels.algorithm(cell.key),
          std::to_string(cell.key.n),
          std::to_string(cell.runs),
          std::to_string(cell.failures),
          duration(summary.time),
          duration_range(summary.time),
          alpha(summary.alpha_mean),
          alpha_range(summary.alpha_mean),
          alpha(summary.alpha_median),
          alpha(summary.alpha_p95),
          cell.alphas.empty() ? kNothing : fixed(cell.max_alpha, kAlphaDigits),
          summary.optimal_share ? percent(*summary.optimal_share) : kNothing};
}

std::string fit_text(const Growth& growth) {
  switch (growth.fit()) {
    case Fit::yes: return "yes";
    case Fit::no: return "no, x" + fixed(growth.lack_of_fit.max_misfit, 2);
    case Fit::untested: return kNothing;
  }
  return kNothing;
}

std::vector<std::string> growth_cells(const std::optional<Growth>& growth) {
  if (!growth) return {kNothing, kNothing, kNothing, kNothing, kNothing};
  const PowerLaw& law = growth->law;
  return {fmt::format("{} .. {}", growth->min_n, growth->max_n),
          fixed(without_sign_of_zero(law.exponent.value), kExponentDigits),
          law.has_interval ? range(law.exponent, kExponentDigits) : kNothing,
          law.r_squared ? fixed(*law.r_squared, kExponentDigits) : kNothing, fit_text(*growth)};
}

}  // namespace

std::string algorithm_table(const std::vector<Cell>& cells, const Labels& labels) {
  std::vector<std::string> order;  // of the registry within every family, so that of the first family will do
  std::map<std::string, Total> totals;
  for (const Cell& cell : cells) {
    const std::string name = labels.algorithm(cell.key);
    const auto [entry, is_new] = totals.try_emplace(name);
    if (is_new) order.push_back(name);
    entry->second.add(cell);
  }
  AlignedTable table({"algorithm", "runs", "failures", "not applicable", "rated instances", "alpha mean", "median",
                      "p95", "max", "optimal"});
  for (const std::string& name : order) table.add_row(totals.at(name).row(name));
  return "alpha by algorithm, all families and sizes together (rated: instances with a proved optimum)\n" +
         table.text();
}

std::string cell_tables(const std::vector<CellSummary>& cells, const Labels& labels) {
  const bool has_delaunay_times = std::any_of(
      cells.begin(), cells.end(), [](const CellSummary& summary) { return summary.over_delaunay.has_value(); });
  std::vector<std::string> header = {"algorithm",  "n",   "runs",   "failed", "median time", "95%",
                                     "alpha mean", "95%", "median", "p95",    "max",         "optimal"};
  if (has_delaunay_times) header.push_back("time / Delaunay's");
  FamilyTables tables(std::move(header));
  for (const CellSummary& summary : cells) {
    if (summary.cell.runs == 0) continue;
    std::vector<std::string> row = cell_row(summary, labels);
    if (has_delaunay_times)
      row.push_back(summary.over_delaunay ? fixed(summary.over_delaunay->estimate.value, 2) : kNothing);
    tables.add_row(labels.family(summary.cell.key), std::move(row));
  }
  return tables.text();
}

std::string growth_tables(const std::vector<SeriesGrowth>& growth, const Labels& labels) {
  FamilyTables tables(
      {"algorithm", "time: sizes", "exponent", "95%", "R^2", "fits", "alpha: sizes", "exponent", "95%", "R^2", "fits"});
  for (const SeriesGrowth& series : growth) {
    std::vector<std::string> row = {labels.algorithm(series.series)};
    for (const auto* law : {&series.time, &series.alpha}) {
      for (std::string& cell : growth_cells(*law)) row.push_back(std::move(cell));
    }
    tables.add_row(labels.family(series.series), std::move(row));
  }
  const std::string text = tables.text();
  if (text.empty()) return "";
  return "growth with n: exponents e of c n^e, least squares through the logarithms\n"
         "fits: no, where the medians do not lie on a power law (F test of lack of fit at 1%) and it misses one by so "
         "much, "
         "more than\na tenth; the exponent is then the mean slope of a curve, which other sizes need not have\n\n" +
         text;
}

}  // namespace mwt
