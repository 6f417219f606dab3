#include "harness/report/summary_files.h"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/number_text.h"
#include "harness/io/text/csv.h"

namespace mwt {

namespace {

template <class Row>
using Columns = std::vector<std::pair<std::string, std::function<std::string(const Row&)>>>;

template <class Row>
std::string csv_table(const std::string& study, const Columns<Row>& columns, const std::vector<Row>& rows) {
  CsvRow fields = {"schema_version", "study"};
  for (const auto& [name, text_of] : columns) fields.push_back(name);
  std::string text = csv_line(fields);
  for (const Row& row : rows) {
    fields = {std::to_string(kSchemaVersion), study};
    for (const auto& [name, text_of] : columns) fields.push_back(text_of(row));
    text += csv_line(fields);
  }
  return text;
}

std::string text_of(const std::optional<double>& value) { return value ? number_text(*value) : ""; }

// Whatever row a key is taken from by `key_of`.
template <class Row, class KeyOf>
Columns<Row> key_columns(KeyOf key_of) {
  return {{"generator", [=](const Row& row) { return key_of(row).generator; }},
          {"generator_params", [=](const Row& row) { return key_of(row).generator_params; }},
          {"algorithm", [=](const Row& row) { return key_of(row).algorithm; }},
          {"params", [=](const Row& row) { return key_of(row).params; }}};
}

// The last columns: what figures call the algorithm and the family.
template <class Row, class KeyOf>
void add_labels(Columns<Row>& columns, const Labels& labels, KeyOf key_of) {
  columns.emplace_back("label", [&labels, key_of](const Row& row) { return labels.algorithm(key_of(row)); });
  columns.emplace_back("family", [&labels, key_of](const Row& row) { return labels.family(key_of(row)); });
}

const CellKey& key_of_cell(const CellSummary& summary) { return summary.cell.key; }

using StatisticOf = std::optional<Statistic> CellSummary::*;

// name, name_lower, name_upper; the ends are empty where there is no interval.
void add_statistic(Columns<CellSummary>& columns, const std::string& name, StatisticOf member) {
  const auto end = [member](double Estimate::*part) {
    return [member, part](const CellSummary& row) {
      const auto& statistic = row.*member;
      const bool is_known = statistic && (statistic->has_interval || part == &Estimate::value);
      return is_known ? number_text(statistic->estimate.*part) : "";
    };
  };
  columns.emplace_back(name, end(&Estimate::value));
  columns.emplace_back(name + "_lower", end(&Estimate::lower));
  columns.emplace_back(name + "_upper", end(&Estimate::upper));
}

Columns<CellSummary> summary_columns(const Labels& labels) {
  using Row = CellSummary;
  const auto count = [](std::size_t Cell::*member) {
    return [member](const Row& row) { return std::to_string(row.cell.*member); };
  };
  Columns<Row> columns = key_columns<Row>(key_of_cell);
  columns.emplace_back("n", [](const Row& row) { return std::to_string(row.cell.key.n); });
  columns.emplace_back("runs", count(&Cell::runs));
  columns.emplace_back("failures", count(&Cell::failures));
  columns.emplace_back("not_applicable", count(&Cell::not_applicable));
  columns.emplace_back("instances", count(&Cell::instances));
  add_statistic(columns, "wall_time_median_s", &Row::time);
  add_statistic(columns, "time_over_delaunay_median", &Row::over_delaunay);
  columns.emplace_back("peak_rss_median_bytes", [](const Row& row) { return text_of(row.peak_rss_bytes); });
  columns.emplace_back("rated_instances", [](const Row& row) { return std::to_string(row.cell.alphas.size()); });
  add_statistic(columns, "alpha_mean", &Row::alpha_mean);
  add_statistic(columns, "alpha_median", &Row::alpha_median);
  add_statistic(columns, "alpha_p95", &Row::alpha_p95);
  columns.emplace_back("alpha_max",
                       [](const Row& row) { return row.cell.alphas.empty() ? "" : number_text(row.cell.max_alpha); });
  columns.emplace_back("optimal_share", [](const Row& row) { return text_of(row.optimal_share); });
  columns.emplace_back("optimal_share_lower",
                       [](const Row& row) { return row.optimal_range ? number_text(row.optimal_range->lower) : ""; });
  columns.emplace_back("optimal_share_upper",
                       [](const Row& row) { return row.optimal_range ? number_text(row.optimal_range->upper) : ""; });
  add_labels(columns, labels, key_of_cell);
  columns.emplace_back("stopped_early", count(&Cell::stopped_early));
  return columns;
}

const CellKey& key_of_observation(const Observation& observation) { return observation.key; }

Columns<Observation> observation_columns(const Labels& labels) {
  using Row = Observation;
  const auto count = [](std::size_t Row::*member) {
    return [member](const Row& row) { return std::to_string(row.*member); };
  };
  const auto measure = [](std::optional<double> Row::*member) {
    return [member](const Row& row) { return text_of(row.*member); };
  };
  Columns<Row> columns = key_columns<Row>(key_of_observation);
  columns.emplace_back("n", [](const Row& row) { return std::to_string(row.key.n); });
  columns.emplace_back("seed", [](const Row& row) { return std::to_string(row.seed); });
  columns.emplace_back("instance_id", [](const Row& row) { return row.instance_id; });
  columns.emplace_back("runs", count(&Row::runs));
  columns.emplace_back("failures", count(&Row::failures));
  columns.emplace_back("stopped_early", count(&Row::stopped_early));
  columns.emplace_back("wall_time_s", measure(&Row::time_s));
  columns.emplace_back("peak_rss_bytes", measure(&Row::peak_rss_bytes));
  columns.emplace_back("alpha_lower", measure(&Row::alpha_lower));
  columns.emplace_back("alpha_upper", measure(&Row::alpha_upper));
  add_labels(columns, labels, key_of_observation);
  return columns;
}

// A row of exponents.csv.
struct FittedMeasure {
  CellKey series;
  std::string measure;
  Growth growth;
};

const CellKey& key_of_series(const FittedMeasure& fitted) { return fitted.series; }

Columns<FittedMeasure> growth_columns(const Labels& labels) {
  using Row = FittedMeasure;
  const auto count = [](auto Growth::*member) {
    return [member](const Row& row) { return std::to_string(row.growth.*member); };
  };
  const auto end_of_interval = [](double Estimate::*end) {
    return [end](const Row& row) {
      const PowerLaw& law = row.growth.law;
      return law.has_interval ? number_text(law.exponent.*end) : "";
    };
  };
  Columns<Row> columns = key_columns<Row>(key_of_series);
  columns.emplace_back("measure", [](const Row& row) { return row.measure; });
  columns.emplace_back("sizes", count(&Growth::sizes));
  columns.emplace_back("observations", count(&Growth::observations));
  columns.emplace_back("min_n", count(&Growth::min_n));
  columns.emplace_back("max_n", count(&Growth::max_n));
  columns.emplace_back("exponent", [](const Row& row) { return number_text(row.growth.law.exponent.value); });
  columns.emplace_back("exponent_lower", end_of_interval(&Estimate::lower));
  columns.emplace_back("exponent_upper", end_of_interval(&Estimate::upper));
  columns.emplace_back("factor", [](const Row& row) { return number_text(std::exp(row.growth.law.log_factor.value)); });
  columns.emplace_back("r_squared", [](const Row& row) { return text_of(row.growth.law.r_squared); });
  columns.emplace_back("lack_of_fit_p", [](const Row& row) { return text_of(row.growth.lack_of_fit.p_value); });
  columns.emplace_back("max_misfit", [](const Row& row) { return number_text(row.growth.lack_of_fit.max_misfit); });
  columns.emplace_back("fits", [](const Row& row) -> std::string {
    const Fit fit = row.growth.fit();
    return fit == Fit::untested ? "" : fit == Fit::yes ? "yes" : "no";
  });
  add_labels(columns, labels, key_of_series);
  return columns;
}

}  // namespace

std::string summary_csv(const std::string& study, const std::vector<CellSummary>& cells, const Labels& labels) {
  return csv_table(study, summary_columns(labels), cells);
}

std::string observations_csv(const std::string& study, const std::vector<Observation>& observations,
                             const Labels& labels) {
  return csv_table(study, observation_columns(labels), observations);
}

std::string exponents_csv(const std::string& study, const std::vector<SeriesGrowth>& growth, const Labels& labels) {
  std::vector<FittedMeasure> rows;
  for (const SeriesGrowth& series : growth) {
    if (series.time) rows.push_back({series.series, "wall_time_s", *series.time});
    if (series.alpha) rows.push_back({series.series, "alpha", *series.alpha});
  }
  return csv_table(study, growth_columns(labels), rows);
}

std::string optima_csv(const std::string& study, const std::vector<OptimumCell>& optima, const Labels& labels) {
  using Row = OptimumCell;
  const auto verdict = [](ProofVerdict kind) {
    return [kind](const Row& row) { return std::to_string(row.count(kind)); };
  };
  Columns<Row> columns = {
      {"generator", [](const Row& row) { return row.generator; }},
      {"generator_params", [](const Row& row) { return row.generator_params; }},
      {"n", [](const Row& row) { return std::to_string(row.n); }},
      {"instances", [](const Row& row) { return std::to_string(row.instances); }},
      {"proved", [](const Row& row) { return std::to_string(row.proved); }},
      {"without_bounds", [](const Row& row) { return std::to_string(row.without_bounds); }},
      {"max_relative_width", [](const Row& row) { return number_text(row.widest); }},
      {"verified", verdict(ProofVerdict::optimal)},
      {"verified_bounds", verdict(ProofVerdict::bounded)},
      {"refused", verdict(ProofVerdict::refused)},
      {"no_verdict", verdict(ProofVerdict::failed)},
      {"max_time_s", [](const Row& row) { return text_of(row.time_s); }},
      {"max_peak_rss_bytes",
       [](const Row& row) { return row.peak_rss_bytes ? std::to_string(*row.peak_rss_bytes) : ""; }},
      {"family", [&](const Row& row) {
         return labels.family({row.generator, row.generator_params, "", "", row.n});
       }}};
  return csv_table(study, columns, optima);
}

std::string ratings_csv(const std::string& study, const std::vector<RunRecord>& runs) {
  Columns<RunRecord> columns;
  columns.emplace_back("run_id", [](const RunRecord& run) { return run.run_id; });
  columns.emplace_back("optimality", [](const RunRecord& run) { return run.optimality; });
  columns.emplace_back("alpha_lower", [](const RunRecord& run) { return text_of(run.alpha_lower); });
  columns.emplace_back("alpha_upper", [](const RunRecord& run) { return text_of(run.alpha_upper); });
  columns.emplace_back("optimal", [](const RunRecord& run) { return run.optimal; });
  columns.emplace_back("is_timed", [](const RunRecord& run) -> std::string { return run.wall_time_s ? "1" : "0"; });
  std::vector<RunRecord> rated = runs;
  std::erase_if(rated, [](const RunRecord& run) { return run.status != RunStatus::ok; });
  return csv_table(study, columns, rated);
}

}  // namespace mwt
