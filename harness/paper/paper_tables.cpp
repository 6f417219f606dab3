#include "harness/paper/paper_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/number_text.h"
#include "harness/io/text/text.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kMostTimeColumns = 3;

std::string bold_if(bool is_bold, const std::string& text) { return is_bold ? "\\textbf{" + text + "}" : text; }

double mean_gap(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// The statistics of one algorithm on the instances of one block.
struct QualityRow {
  std::string label;
  std::size_t failures = 0;
  std::size_t optimal = 0;
  std::vector<double> gaps;  // failures left out
  std::optional<Statistic> mean;
  bool is_best = false;

  [[nodiscard]] double quantile_of_gap(double p) const { return quantile(gaps, p); }
};

QualityRow quality_row(const PaperData& data, std::size_t algorithm, const std::vector<std::size_t>& instances) {
  QualityRow row;
  row.label = data.algorithms[algorithm];
  row.gaps = data.values(PaperMeasure::gap, algorithm, instances);
  row.failures = std::erase(row.gaps, kPaperFailure);
  for (const std::size_t i : instances) row.optimal += data.outcomes[algorithm][i].is_optimal;
  if (row.gaps.size() >= kMinForInterval)
    row.mean = Statistic{bootstrap(row.gaps, mean_gap), true};
  else if (!row.gaps.empty())
    row.mean = Statistic{{mean_gap(row.gaps), 0, 0}, false};
  return row;
}

struct QualityBlock {
  std::string family;  // empty: all
  std::vector<std::size_t> instances;
  std::vector<QualityRow> rows;

  // Whether no row of the block has a smaller value.
  [[nodiscard]] bool is_smallest(const QualityRow& row, double (*value_of)(const QualityRow&)) const {
    return std::ranges::all_of(
        rows, [&](const QualityRow& other) { return other.gaps.empty() || value_of(row) <= value_of(other); });
  }
};

double mean_of_row(const QualityRow& row) { return row.mean->estimate.value; }
double median_of_row(const QualityRow& row) { return median(row.gaps); }

std::string percent_text(double share) { return latex_number(100 * share); }

std::vector<std::string> latex_cells(const QualityBlock& block, const QualityRow& row) {
  std::vector<std::string> cells = {"\\quad " + latex_text(row.label), std::to_string(row.failures)};
  if (row.gaps.empty()) {
    cells.insert(cells.end(), 6, "--");
    return cells;
  }
  const Statistic& mean = *row.mean;
  const bool best_mean = row.is_best && block.is_smallest(row, mean_of_row);
  const bool best_median = row.is_best && block.is_smallest(row, median_of_row);
  cells.push_back(bold_if(best_mean, percent_text(mean.estimate.value)));
  cells.push_back(mean.has_interval ? percent_text(mean.estimate.lower) + "--" + percent_text(mean.estimate.upper)
                                    : "--");
  cells.push_back(bold_if(best_median, percent_text(median(row.gaps))));
  cells.push_back(percent_text(row.quantile_of_gap(0.95)));
  cells.push_back(percent_text(row.quantile_of_gap(1)));
  cells.push_back(std::to_string(row.optimal));
  return cells;
}

CsvRow csv_cells(const QualityBlock& block, const QualityRow& row) {
  CsvRow cells = {block.family.empty() ? "*" : block.family, row.label, std::to_string(block.instances.size()),
                  std::to_string(row.failures)};
  if (row.gaps.empty()) {
    cells.insert(cells.end(), 6, "");
  } else {
    const Estimate& mean = row.mean->estimate;
    cells.push_back(number_text(mean.value));
    cells.push_back(row.mean->has_interval ? number_text(mean.lower) : "");
    cells.push_back(row.mean->has_interval ? number_text(mean.upper) : "");
    for (const double p : {0.5, 0.95, 1.0}) cells.push_back(number_text(row.quantile_of_gap(p)));
  }
  cells.push_back(std::to_string(row.optimal));
  cells.push_back(row.is_best ? "1" : "0");
  return cells;
}

std::vector<QualityBlock> quality_blocks(const PaperData& data, const std::vector<std::string>& families) {
  std::vector<QualityBlock> blocks = {{"", data.common(PaperMeasure::gap), {}}};
  for (const std::string& family : families) {
    std::vector<std::size_t> instances = data.common(PaperMeasure::gap, family);
    if (instances.size() == blocks.front().instances.size()) continue;  // the only family
    if (!instances.empty()) blocks.push_back({family, std::move(instances), {}});
  }
  std::vector<std::vector<AlgorithmPair>> pairs;
  for (const QualityBlock& block : blocks) pairs.push_back(pairs_on(data, PaperMeasure::gap, block.instances));
  adjust_for_many(pairs);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t a = 0; a < data.algorithms.size(); ++a)
      blocks[b].rows.push_back(quality_row(data, a, blocks[b].instances));
    if (const auto winner = winner_of(pairs[b])) blocks[b].rows[*winner].is_best = true;
  }
  return blocks;
}

// The cells of one family in the time table.
struct TimeCell {
  const CellSummary* summary = nullptr;
  bool is_best = false;
};
using TimeCells = std::map<std::tuple<std::string, Index, std::string>, TimeCell>;  // family, n, label

// Up to three n, ascending: those with most common instances of the families, of equally many the largest.
std::vector<Index> time_columns(const PaperData& data, const std::vector<std::string>& families) {
  std::map<Index, std::size_t> counts;
  for (const std::string& family : families) {
    for (const std::size_t i : data.common(PaperMeasure::time, family)) ++counts[data.instances[i].n];
  }
  std::vector<Index> sizes;
  for (const auto& [n, count] : counts) sizes.push_back(n);
  std::ranges::sort(sizes, std::greater{}, [&](Index n) { return std::pair(counts[n], n); });
  if (sizes.size() > kMostTimeColumns) sizes.resize(kMostTimeColumns);
  std::ranges::sort(sizes);
  return sizes;
}

TimeCells time_cells(const ReportData& report, const PaperData& data, const std::vector<std::string>& families,
                     const std::vector<Index>& sizes) {
  TimeCells cells;
  for (const CellSummary& summary : report.summaries) {
    const CellKey& key = summary.cell.key;
    cells[{report.labels.family(key), key.n, report.labels.algorithm(key)}].summary = &summary;
  }
  std::vector<std::vector<AlgorithmPair>> pairs;
  std::vector<std::pair<std::string, Index>> names;
  for (const std::string& family : families) {
    for (const Index n : sizes) {
      std::vector<std::size_t> instances = data.common(PaperMeasure::time, family);
      std::erase_if(instances, [&](std::size_t i) { return data.instances[i].n != n; });
      pairs.push_back(pairs_on(data, PaperMeasure::time, instances));
      names.emplace_back(family, n);
    }
  }
  adjust_for_many(pairs);
  for (std::size_t b = 0; b < pairs.size(); ++b) {
    if (const auto winner = winner_of(pairs[b]))
      cells[{names[b].first, names[b].second, data.algorithms[*winner]}].is_best = true;
  }
  return cells;
}

std::string time_text(const TimeCell& cell) {
  if (cell.summary == nullptr || !cell.summary->time) return "--";
  const Statistic& time = *cell.summary->time;
  std::string text = bold_if(cell.is_best, latex_number(1e3 * time.estimate.value));
  if (time.has_interval)
    text += " {\\scriptsize " + latex_number(1e3 * time.estimate.lower, 2) + "--" +
            latex_number(1e3 * time.estimate.upper, 2) + "}";
  return text;
}

void add_csv_time(CsvRows& rows, const std::string& family, Index n, const std::string& label, const TimeCell& cell) {
  if (cell.summary == nullptr) return;
  const std::optional<Statistic>& time = cell.summary->time;
  const auto end = [&](double Estimate::*part) {
    return time && time->has_interval ? number_text(time->estimate.*part) : std::string();
  };
  rows.push_back({family, std::to_string(n), label, std::to_string(cell.summary->cell.instances),
                  std::to_string(cell.summary->cell.failures), time ? number_text(time->estimate.value) : "",
                  end(&Estimate::lower), end(&Estimate::upper), cell.is_best ? "1" : "0"});
}

// What is written with a fixed number of digits, without "-0.00".
std::string fixed_text(double value) {
  const std::string text = fixed(value, 2);
  return text == "-0.00" ? "0.00" : text;
}

// Exponent with interval, R squared.
std::vector<std::string> law_cells(const std::optional<Growth>& growth) {
  if (!growth) return {"--", "--", "--"};
  const Estimate& exponent = growth->law.exponent;
  const std::string mark = growth->fit() == Fit::no ? "$^\\sim$" : "";
  const std::string interval =
      growth->law.has_interval ? fixed_text(exponent.lower) + " to " + fixed_text(exponent.upper) : "--";
  return {fixed_text(exponent.value) + mark, interval, growth->law.r_squared ? fixed(*growth->law.r_squared, 3) : "--"};
}

CsvRow law_csv(const std::string& measure, const std::string& family, const std::string& label, const Growth& growth) {
  const Estimate& exponent = growth.law.exponent;
  const auto end = [&](double value) { return growth.law.has_interval ? number_text(value) : std::string(); };
  const char* fits = growth.fit() == Fit::yes ? "yes" : growth.fit() == Fit::no ? "no" : "untested";
  return {measure,
          family,
          label,
          std::to_string(growth.sizes),
          std::to_string(growth.min_n),
          std::to_string(growth.max_n),
          number_text(exponent.value),
          end(exponent.lower),
          end(exponent.upper),
          growth.law.r_squared ? number_text(*growth.law.r_squared) : "",
          fits};
}

}  // namespace

PaperTable quality_table(const PaperData& data, const std::vector<std::string>& families) {
  PaperTable table;
  table.csv = {{"family", "label", "instances", "failures", "gap_mean", "gap_mean_lower", "gap_mean_upper",
                "gap_median", "gap_p95", "gap_max", "optimal", "is_best"}};
  table.latex.columns = "@{}lrrcrrrr@{}";
  table.latex.head = {"gap in \\%", "failed", "mean", "95\\,\\% interval", "median", "95\\,\\%", "max.", "optimal"};
  for (const QualityBlock& block : quality_blocks(data, families)) {
    const std::string name = block.family.empty() ? "all" : "\\emph{" + latex_text(block.family) + "}";
    table.latex.rows.push_back({name + ", " + std::to_string(block.instances.size()) + " instances"});
    for (const QualityRow& row : block.rows) {
      table.latex.rows.push_back(latex_cells(block, row));
      table.csv.push_back(csv_cells(block, row));
    }
  }
  return table;
}

PaperTable time_table(const ReportData& report, const PaperData& data, const std::vector<std::string>& families) {
  const std::vector<Index> sizes = time_columns(data, families);
  TimeCells cells = time_cells(report, data, families, sizes);
  PaperTable table;
  table.csv = {{"family", "n", "label", "instances", "failures", "time_median_s", "time_median_s_lower",
                "time_median_s_upper", "is_best"}};
  table.latex.columns = "@{}l" + std::string(sizes.size(), 'r') + "@{}";
  table.latex.head = {"time in ms"};
  for (const Index n : sizes) table.latex.head.push_back("$n=" + std::to_string(n) + "$");
  for (const std::string& family : families) {
    table.latex.rows.push_back({"\\emph{" + latex_text(family) + "}"});
    for (const std::string& label : data.algorithms) {
      std::vector<std::string> row = {"\\quad " + latex_text(label)};
      for (const Index n : sizes) {
        const TimeCell& cell = cells[{family, n, label}];
        row.push_back(time_text(cell));
        add_csv_time(table.csv, family, n, label, cell);
      }
      table.latex.rows.push_back(row);
    }
  }
  return table;
}

PaperTable growth_table(const ReportData& report, const PaperData& data, const std::vector<std::string>& families) {
  PaperTable table;
  table.csv = {{"measure", "family", "label", "sizes", "min_n", "max_n", "exponent", "exponent_lower", "exponent_upper",
                "r_squared", "fits"}};
  table.latex.columns = "@{}lrcrrcr@{}";
  table.latex.head = {"", "time", "95\\,\\%", "$R^2$", "$\\alpha$", "95\\,\\%", "$R^2$"};
  for (const std::string& family : families) {
    std::vector<std::vector<std::string>> rows;
    for (const SeriesGrowth& series : report.growth) {
      const std::string label = report.labels.algorithm(series.series);
      const bool is_chosen = std::ranges::find(data.algorithms, label) != data.algorithms.end();
      if (!is_chosen || report.labels.family(series.series) != family) continue;
      std::vector<std::string> row = {"\\quad " + latex_text(label)};
      for (const std::optional<Growth>& growth : {series.time, series.alpha}) {
        const std::vector<std::string> cells = law_cells(growth);
        row.insert(row.end(), cells.begin(), cells.end());
      }
      rows.push_back(row);
      if (series.time) table.csv.push_back(law_csv("time", family, label, *series.time));
      if (series.alpha) table.csv.push_back(law_csv("alpha", family, label, *series.alpha));
    }
    if (rows.empty()) continue;
    table.latex.rows.push_back({"\\emph{" + latex_text(family) + "}"});
    table.latex.rows.insert(table.latex.rows.end(), rows.begin(), rows.end());
  }
  return table;
}

CsvRows pair_rows(const PaperData& data, PaperMeasure measure) {
  std::vector<std::vector<AlgorithmPair>> blocks = {pairs_on(data, measure, data.common(measure))};
  adjust_for_many(blocks);
  CsvRows rows = {{"first", "second", "instances", "first_better", "equal", "second_better", "p_value", "p_adjusted",
                   "effect", "shift", "shift_lower", "shift_upper"}};
  for (const AlgorithmPair& pair : blocks.front()) {
    const PairedComparison& comparison = pair.comparison;
    rows.push_back({data.algorithms[pair.first], data.algorithms[pair.second], std::to_string(comparison.pairs()),
                    std::to_string(comparison.positive), std::to_string(comparison.zero),
                    std::to_string(comparison.negative), number_text(comparison.p_value), number_text(pair.p_adjusted),
                    number_text(comparison.effect), number_text(comparison.shift),
                    comparison.interval ? number_text(comparison.interval->lower) : "",
                    comparison.interval ? number_text(comparison.interval->upper) : ""});
  }
  return rows;
}

CsvRows rank_rows(const PaperData& data, PaperMeasure measure) {
  CsvRows rows = {{"label", "mean_rank", "instances", "friedman", "p_value", "critical_difference"}};
  const auto found = ranks_on(data, measure, data.common(measure));
  if (!found) return rows;
  for (const std::size_t a : found->order) {
    rows.push_back({data.algorithms[a], number_text(found->ranks.ranks[a]), std::to_string(found->ranks.blocks),
                    number_text(found->ranks.chi_squared), number_text(found->ranks.p_value),
                    number_text(found->ranks.critical_difference)});
  }
  return rows;
}

CsvRows rank_group_rows(const PaperData& data, PaperMeasure measure) {
  CsvRows rows = {{"first_rank", "last_rank"}};
  const auto found = ranks_on(data, measure, data.common(measure));
  if (!found) return rows;
  for (const auto& [first, last] : found->groups) {
    rows.push_back(
        {number_text(found->ranks.ranks[found->order[first]]), number_text(found->ranks.ranks[found->order[last]])});
  }
  return rows;
}

CsvRows outcome_rows(const PaperData& data) {
  CsvRows rows = {{"label", "family", "n", "seed", "instance_id", "status", "stopped_early", "is_optimal", "gap",
                   "alpha_lower", "alpha_upper", "time_s", "in_gap", "in_time"}};
  const std::vector<std::size_t> gap = data.common(PaperMeasure::gap), time = data.common(PaperMeasure::time);
  const std::set<std::size_t> in_gap(gap.begin(), gap.end()), in_time(time.begin(), time.end());
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    for (std::size_t i = 0; i < data.instances.size(); ++i) {
      const PaperInstance& instance = data.instances[i];
      const PaperOutcome& outcome = data.outcomes[a][i];
      if (!outcome.is_run) continue;
      const bool is_rated = outcome.status == "ok" && instance.has_optimum;
      rows.push_back({data.algorithms[a], instance.family, std::to_string(instance.n), std::to_string(instance.seed),
                      instance.instance_id, outcome.status, outcome.is_early ? "1" : "0",
                      outcome.is_optimal ? "1" : "0", is_rated ? number_text(data.value(PaperMeasure::gap, a, i)) : "",
                      is_rated ? number_text(outcome.alpha_lower) : "",
                      is_rated ? number_text(outcome.alpha_upper) : "",
                      outcome.time_s ? number_text(*outcome.time_s) : "", in_gap.contains(i) ? "1" : "0",
                      in_time.contains(i) ? "1" : "0"});
    }
  }
  return rows;
}

}  // namespace mwt
