#include "harness/report/side_by_side.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "base/number_text.h"
#include "harness/io/text/aligned_table.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"
#include "harness/records/environment.h"
#include "harness/report/observations.h"
#include "harness/statistics/bootstrap.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr const char* kAbsent = "-";

// The values of one measure of a cell, by instance.
using ByInstance = std::map<std::string, double>;

struct CellValues {
  std::set<std::string> instances;
  ByInstance times;
  ByInstance alphas;
};

std::map<CellKey, CellValues> values_by_cell(const ReportData& data) {
  std::map<CellKey, CellValues> by_cell;
  for (const Observation& observation : observations_of(data.records.runs)) {
    CellValues& values = by_cell[observation.key];
    if (observation.runs > observation.failures) values.instances.insert(observation.instance_id);
    if (observation.time_s) values.times[observation.instance_id] = *observation.time_s;
    if (observation.alpha_upper) values.alphas[observation.instance_id] = *observation.alpha_upper;
  }
  return by_cell;
}

std::vector<double> values_of(const ByInstance& by_instance) {
  std::vector<double> values;
  for (const auto& [instance, value] : by_instance) values.push_back(value);
  return values;
}

bool are_on_the_same_instances(const ByInstance& a, const ByInstance& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.first == y.first; });
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Statistic with_interval(const Estimate& estimate) { return {estimate, true}; }
Statistic without_interval(double value) { return {{value, value, value}, false}; }

std::optional<Statistic> ratio_of_medians(const ByInstance& a, const ByInstance& b) {
  const std::vector<double> first = values_of(a), second = values_of(b);
  const auto is_positive = [](double value) { return value > 0; };
  if (first.empty() || second.empty() || !std::ranges::all_of(first, is_positive) ||
      !std::ranges::all_of(second, is_positive))
    return std::nullopt;
  if (std::min(first.size(), second.size()) < kMinForInterval) return without_interval(median(second) / median(first));
  return with_interval(are_on_the_same_instances(a, b) ? bootstrap_paired_ratio_of_medians(second, first)
                                                       : bootstrap_ratio_of_medians(second, first));
}

std::optional<Statistic> change_of_means(const ByInstance& a, const ByInstance& b) {
  const std::vector<double> first = values_of(a), second = values_of(b);
  if (first.empty() || second.empty()) return std::nullopt;
  if (std::min(first.size(), second.size()) < kMinForInterval)
    return without_interval(mean_of(second) - mean_of(first));
  if (!are_on_the_same_instances(a, b)) {
    return with_interval(bootstrap_two_samples(
        first, second, [](std::span<const double> x, std::span<const double> y) { return mean_of(y) - mean_of(x); }));
  }
  std::vector<double> changes;
  std::ranges::transform(second, first, std::back_inserter(changes), std::minus{});
  return with_interval(bootstrap(changes, mean_of));
}

PairedCell paired_cell(const CellKey& key, const CellValues& a, const CellValues& b) {
  PairedCell cell;
  cell.key = key;
  cell.common_instances = static_cast<std::size_t>(
      std::ranges::count_if(a.instances, [&](const std::string& instance) { return b.instances.contains(instance); }));
  cell.time_ratio = ratio_of_medians(a.times, b.times);
  cell.alpha_change = change_of_means(a.alphas, b.alphas);
  return cell;
}

// The cells with runs.
std::map<CellKey, const CellSummary*> summaries_by_cell(const ReportData& data) {
  std::map<CellKey, const CellSummary*> by_cell;
  for (const CellSummary& summary : data.summaries) {
    if (summary.cell.runs > 0) by_cell[summary.cell.key] = &summary;
  }
  return by_cell;
}

// What a study has of each aspect, in the order of its runs.
using Aspects = std::vector<std::pair<std::string, std::vector<std::string>>>;

class AspectsOfStudy {
 public:
  void add(const std::string& aspect, const std::string& value) {
    const auto found = std::ranges::find(aspects_, aspect, &Aspects::value_type::first);
    std::vector<std::string>& values =
        found == aspects_.end() ? aspects_.emplace_back(aspect, std::vector<std::string>{}).second : found->second;
    if (!value.empty() && seen_.emplace(aspect, value).second) values.push_back(value);
  }

  [[nodiscard]] const Aspects& all() const { return aspects_; }

 private:
  Aspects aspects_;
  std::set<std::pair<std::string, std::string>> seen_;
};

// Numbers ascending; names stay in the order of the runs.
void sort_numbers(Aspects& aspects) {
  for (auto& [aspect, values] : aspects) {
    const auto number = [](const std::string& value) { return parse_whole_number<std::uint64_t>(value); };
    if (std::ranges::all_of(values, [&](const std::string& value) { return number(value).has_value(); }))
      std::ranges::sort(values, {}, [&](const std::string& value) { return *number(value); });
  }
}

// Every aspect, whether or not the study has a value of it: two studies have the same aspects in the same order.
Aspects aspects_of(const ReportData& data, const Labels& labels) {
  AspectsOfStudy aspects;
  for (const char* aspect : {"study", "families", "sizes", "seeds", "algorithms"}) aspects.add(aspect, "");
  for (const RunRecord& run : data.records.runs) {
    const CellKey key{run.generator, run.generator_params, run.algorithm, run.params, run.n};
    aspects.add("study", run.study);
    aspects.add("families", labels.family(key));
    aspects.add("sizes", std::to_string(run.n));
    aspects.add("seeds", std::to_string(run.seed));
    aspects.add("algorithms", labels.algorithm(key));
    aspects.add("repetitions", std::to_string(run.repetition));
    aspects.add("threads", std::to_string(run.threads));
    aspects.add("time limit in s", number_text(run.time_limit_s));
    aspects.add("memory limit in bytes", std::to_string(run.memory_limit_bytes));
    aspects.add("commit", run.git_commit);
    aspects.add("program", run.binary_sha256.substr(0, 16));
  }
  for (const char* aspect : {"machine", "compiler", "runs side by side"}) aspects.add(aspect, "");
  for (const EnvironmentRecord& environment : data.records.environments) {
    aspects.add("machine", machine_of(environment));
    aspects.add("compiler", environment.compiler);
    aspects.add("runs side by side", std::to_string(environment.jobs));
  }
  Aspects all = aspects.all();
  sort_numbers(all);
  return all;
}

std::vector<std::string> missing_in(const std::vector<std::string>& values, const std::vector<std::string>& others) {
  std::vector<std::string> missing;
  std::ranges::copy_if(values, std::back_inserter(missing),
                       [&](const std::string& value) { return std::ranges::find(others, value) == others.end(); });
  return missing;
}

std::vector<PlanDifference> differences_of(const Aspects& a, const Aspects& b) {
  std::vector<PlanDifference> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    PlanDifference difference{a[i].first, missing_in(a[i].second, b[i].second), missing_in(b[i].second, a[i].second)};
    if (!difference.only_a.empty() || !difference.only_b.empty()) differences.push_back(std::move(difference));
  }
  return differences;
}

std::vector<std::string> warnings_of(const SideBySide& both) {
  std::vector<std::string> warnings;
  for (const auto& [name, data] : {std::pair("A", both.a), std::pair("B", both.b)}) {
    for (const std::string& warning : data->warnings) warnings.push_back(std::string(name) + ": " + warning);
  }
  const auto differs = [&](const char* aspect) {
    return std::ranges::find(both.differences, aspect, &PlanDifference::aspect) != both.differences.end();
  };
  if (differs("machine") || differs("runs side by side"))
    warnings.emplace_back(
        "the machines differ, or how many runs they ran side by side: ratios of times show that, too");
  const bool has_other_instances = std::ranges::any_of(both.cells, [](const PairedCell& cell) {
    return cell.a != nullptr && cell.b != nullptr &&
           cell.common_instances < std::max(cell.a->cell.instances, cell.b->cell.instances);
  });
  if (has_other_instances)
    warnings.emplace_back("some cells are of different instances, as their column states: ratios show that, too");
  return warnings;
}

std::vector<RunRecord> runs_of_both(const ReportData& a, const ReportData& b) {
  std::vector<RunRecord> runs = a.records.runs;
  runs.insert(runs.end(), b.records.runs.begin(), b.records.runs.end());
  return runs;
}

std::string side_text(const char* name, const ReportData& data) {
  return fmt::format("{}: {} (study {}, {})\n", name, data.folder, data.records.runs.front().study,
                     counted(data.records.runs.size(), "run"));
}

constexpr std::size_t kMostValues = 6;

std::string list_text(const std::vector<std::string>& values) {
  if (values.empty()) return kAbsent;
  if (values.size() <= kMostValues) return joined(values);
  const std::vector<std::string> first(values.begin(), values.begin() + kMostValues);
  return joined(first) + fmt::format(" and {} more", values.size() - kMostValues);
}

std::string plan_table(const SideBySide& both) {
  if (both.differences.empty()) return "The plans, programs and machines do not differ.\n";
  AlignedTable table({"differs", "only in A", "only in B"}, {1, 2});
  for (const PlanDifference& difference : both.differences)
    table.add_row({difference.aspect, list_text(difference.only_a), list_text(difference.only_b)});
  return table.text();
}

std::string time_text(const CellSummary* side) {
  return side && side->time ? readable_duration(side->time->estimate.value) : kAbsent;
}

std::string alpha_text(const CellSummary* side) {
  return side && side->alpha_mean ? fixed(side->alpha_mean->estimate.value, 5) : kAbsent;
}

std::string failures_text(const CellSummary* side) {
  return side ? fmt::format("{} of {}", side->cell.failures, side->cell.runs) : kAbsent;
}

std::string ratio_text(const std::optional<Statistic>& ratio) {
  return ratio ? fixed(ratio->estimate.value, 3) : kAbsent;
}

std::string change_text(const std::optional<Statistic>& change) {
  return change ? fmt::format("{:+.6f}", change->estimate.value) : kAbsent;
}

std::string interval_text(const std::optional<Statistic>& statistic, int digits) {
  if (!statistic || !statistic->has_interval) return kAbsent;
  return fixed(statistic->estimate.lower, digits) + " .. " + fixed(statistic->estimate.upper, digits);
}

std::string instances_text(const PairedCell& cell) {
  if (cell.a == nullptr || cell.b == nullptr) return cell.a != nullptr ? "only A" : "only B";
  const std::size_t most = std::max(cell.a->cell.instances, cell.b->cell.instances);
  return cell.common_instances == most ? "all" : fmt::format("{} of {}", cell.common_instances, most);
}

std::vector<std::string> table_row(const PairedCell& cell, const Labels& labels) {
  return {labels.algorithm(cell.key),
          std::to_string(cell.key.n),
          instances_text(cell),
          time_text(cell.a),
          time_text(cell.b),
          ratio_text(cell.time_ratio),
          interval_text(cell.time_ratio, 3),
          alpha_text(cell.a),
          alpha_text(cell.b),
          change_text(cell.alpha_change),
          interval_text(cell.alpha_change, 6),
          failures_text(cell.a),
          failures_text(cell.b)};
}

std::string number_or_empty(const std::optional<Statistic>& statistic, double Estimate::*part) {
  if (!statistic || (part != &Estimate::value && !statistic->has_interval)) return "";
  return number_text(statistic->estimate.*part);
}

void add_statistic_to(CsvRow& row, const std::optional<Statistic>& statistic) {
  for (const auto part : {&Estimate::value, &Estimate::lower, &Estimate::upper})
    row.push_back(number_or_empty(statistic, part));
}

CsvRow csv_row(const PairedCell& cell, const Labels& labels) {
  CsvRow row = {std::to_string(kSchemaVersion),
                cell.key.generator,
                cell.key.generator_params,
                cell.key.algorithm,
                cell.key.params,
                std::to_string(cell.key.n),
                labels.family(cell.key),
                labels.algorithm(cell.key)};
  for (const CellSummary* side : {cell.a, cell.b}) {
    row.push_back(side ? std::to_string(side->cell.runs) : "");
    row.push_back(side ? std::to_string(side->cell.failures) : "");
    row.push_back(side ? std::to_string(side->cell.instances) : "");
    row.push_back(side ? number_or_empty(side->time, &Estimate::value) : "");
    row.push_back(side ? number_or_empty(side->alpha_mean, &Estimate::value) : "");
  }
  row.push_back(std::to_string(cell.common_instances));
  add_statistic_to(row, cell.time_ratio);
  add_statistic_to(row, cell.alpha_change);
  return row;
}

}  // namespace

SideBySide side_by_side(const ReportData& a, const ReportData& b) {
  const std::vector<Cell> cells = cells_of(runs_of_both(a, b));
  SideBySide both{&a, &b, Labels(cells), {}, {}, {}};
  auto of_a = values_by_cell(a), of_b = values_by_cell(b);
  auto summaries_of_a = summaries_by_cell(a), summaries_of_b = summaries_by_cell(b);
  for (const Cell& cell : cells) {
    if (cell.runs == 0) continue;
    PairedCell& paired = both.cells.emplace_back(paired_cell(cell.key, of_a[cell.key], of_b[cell.key]));
    paired.a = summaries_of_a[cell.key];
    paired.b = summaries_of_b[cell.key];
  }
  both.differences = differences_of(aspects_of(a, both.labels), aspects_of(b, both.labels));
  both.warnings = warnings_of(both);
  return both;
}

std::string side_by_side_text(const SideBySide& both) {
  std::string text = side_text("A", *both.a) + side_text("B", *both.b) + '\n' + plan_table(both);
  for (const std::string& warning : both.warnings) text += "\nwarning: " + warning + '\n';
  text += "\nB / A: ratio of median times. Change: mean alpha of B minus that of A, below 0 where B is better.\n";
  std::vector<std::pair<std::string, AlignedTable>> tables;
  for (const PairedCell& cell : both.cells) {
    const std::string family = both.labels.family(cell.key);
    if (tables.empty() || tables.back().first != family) {
      tables.emplace_back(family, AlignedTable({"algorithm", "n", "same instances", "time A", "time B", "B / A", "95%",
                                                "alpha A", "alpha B", "change", "95%", "failed A", "failed B"}));
    }
    tables.back().second.add_row(table_row(cell, both.labels));
  }
  for (const auto& [family, table] : tables) text += '\n' + family + '\n' + table.text("  ");
  return text;
}

std::string side_by_side_cells_csv(const SideBySide& both) {
  CsvRow header = {"schema_version", "generator", "generator_params", "algorithm", "params", "n", "family", "label"};
  for (const char* side : {"a_", "b_"}) {
    for (const char* column : {"runs", "failures", "instances", "wall_time_median_s", "alpha_mean"})
      header.push_back(std::string(side) + column);
  }
  header.emplace_back("common_instances");
  for (const char* statistic : {"time_ratio", "alpha_change"}) {
    for (const char* end : {"", "_lower", "_upper"}) header.push_back(std::string(statistic) + end);
  }
  std::string text = csv_line(header);
  for (const PairedCell& cell : both.cells) text += csv_line(csv_row(cell, both.labels));
  return text;
}

std::string side_by_side_plan_csv(const SideBySide& both) {
  std::string text = csv_line({"aspect", "a", "b"});
  const auto row = [](const char* aspect, const std::string& a, const std::string& b) {
    return csv_line({aspect, a, b});
  };
  text += row("folder", both.a->folder, both.b->folder);
  text += row("runs", std::to_string(both.a->records.runs.size()), std::to_string(both.b->records.runs.size()));
  for (const PlanDifference& difference : both.differences)
    text += csv_line({difference.aspect, joined(difference.only_a), joined(difference.only_b)});
  for (const std::string& warning : both.warnings) text += row("warning", warning, "");
  return text;
}

}  // namespace mwt
