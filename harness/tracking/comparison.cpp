#include "harness/tracking/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/error.h"
#include "harness/statistics/false_discovery.h"
#include "harness/statistics/quantile.h"
#include "harness/statistics/shift.h"
#include "harness/tracking/time_comparison.h"

namespace mwt {

namespace {

using Runs = std::vector<const RunRecord*>;
using Repetitions = std::map<int, double>;  ///< logarithms of times

constexpr const char* kAll = "all";            ///< the row of all algorithms
constexpr std::size_t kCellsToTellSpread = 5;  ///< fewer do not show how differently two sessions treat a cell

/// A cell that both sides have.
struct CommonCell {
  TrackedCell cell;
  Runs base;
  Runs now;
};

/// A cell whose times are judged.
struct TimedCell {
  TrackedCell cell;
  Repetitions base;
  Repetitions now;
};

struct JudgedRow {
  TimeRow row;
  TimeJudgement judgement;
};

std::set<std::string> values_of_field(const Runs& runs, std::string RunRecord::*field) {
  std::set<std::string> values;
  for (const RunRecord* run : runs) values.insert(run->*field);
  return values;
}

bool same_instance(const CommonCell& cell) {
  return values_of_field(cell.base, &RunRecord::instance_id) == values_of_field(cell.now, &RunRecord::instance_id);
}

bool same_binary(const CommonCell& cell) {
  const auto base = values_of_field(cell.base, &RunRecord::binary_sha256);
  return base.size() == 1 && !base.begin()->empty() && base == values_of_field(cell.now, &RunRecord::binary_sha256);
}

std::set<std::string> machines_of(const ResultSet& results) {
  std::set<std::string> machines;
  for (const EnvironmentRecord& environment : results.environments) machines.insert(machine_of(environment));
  return machines;
}

Repetitions log_times(const Measure& measure, const Runs& runs) {
  Repetitions times;
  for (const RunRecord* run : runs) {
    const auto time = measure.of(*run);
    if (time && *time > 0) times[run->repetition] = std::log(*time);
  }
  return times;
}

std::vector<double> values_of(const Repetitions& repetitions) {
  std::vector<double> values;
  for (const auto& [repetition, value] : repetitions) values.push_back(value);
  return values;
}

/// Whether every successful run was measured long enough for the ticks of CPU clocks, which may last milliseconds.
bool has_steady_cpu_time(const Runs& runs) {
  constexpr double kLongEnough = 0.01;
  return std::all_of(runs.begin(), runs.end(), [](const RunRecord* run) {
    if (run->status != RunStatus::ok) return true;
    return run->wall_time_s.value_or(0) * static_cast<double>(run->iterations.value_or(1)) >= kLongEnough;
  });
}

/// now - base for each repetition that both sides have.
Repetitions paired_log_ratios(const TimedCell& cell) {
  Repetitions ratios;
  for (const auto& [repetition, time] : cell.now) {
    const auto before = cell.base.find(repetition);
    if (before != cell.base.end()) ratios[repetition] = time - before->second;
  }
  return ratios;
}

/// In each repetition the pseudo-median over the cells.
std::vector<double> typical_by_repetition(const std::vector<const TimedCell*>& cells) {
  std::map<int, std::vector<double>> ratios;
  for (const TimedCell* cell : cells) {
    for (const auto& [repetition, ratio] : paired_log_ratios(*cell)) ratios[repetition].push_back(ratio);
  }
  std::vector<double> typical;
  for (const auto& [repetition, values] : ratios) typical.push_back(pseudo_median(values));
  return typical;
}

/// Judges the times of the cells of both sides, one row per cell and one per algorithm.
class TimeTable {
 public:
  TimeTable(const std::vector<TimedCell>& cells, const CompareOptions& options, bool has_yardstick)
      : cells_(cells), options_(options), has_yardstick_(has_yardstick) {
    for (const TimedCell& cell : cells_) {
      log_ratios_.push_back(options_.paired ? pseudo_median(values_of(paired_log_ratios(cell)))
                                            : shift_between(values_of(cell.base), values_of(cell.now)));
    }
  }

  [[nodiscard]] std::vector<TimeRow> cell_rows() const {
    std::vector<JudgedRow> rows;
    for (const TimedCell& cell : cells_) rows.push_back(cell_row(cell));
    return decided(rows);
  }

  [[nodiscard]] std::vector<TimeRow> algorithm_rows() const {
    std::map<std::string, std::vector<std::size_t>> members;
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      members[algorithm_label(cells_[i].cell)].push_back(i);
      all.push_back(i);
    }
    std::vector<JudgedRow> rows;
    for (const auto& [algorithm, cells] : members) rows.push_back(algorithm_row(algorithm, cells));
    if (members.size() > 1) rows.push_back(algorithm_row(kAll, all));
    return decided(rows);
  }

 private:
  [[nodiscard]] JudgedRow cell_row(const TimedCell& cell) const {
    JudgedRow judged;
    judged.row.name = cell.cell.algorithm;
    judged.row.algorithm = algorithm_label(cell.cell);
    judged.row.instance = instance_label(cell.cell);
    judged.row.base = std::exp(median(values_of(cell.base)));
    judged.row.now = std::exp(median(values_of(cell.now)));
    if (options_.paired) {
      const std::vector<double> ratios = values_of(paired_log_ratios(cell));
      judged.row.observations = ratios.size();
      judged.judgement = judge_log_ratios(ratios, options_.threshold);
    } else {
      judged.row.observations = std::min(cell.base.size(), cell.now.size());
      judged.judgement = judge_log_times(values_of(cell.base), values_of(cell.now), options_.threshold);
      if (cells_.size() >= kCellsToTellSpread) require_standing_out(judged.judgement, log_ratios_, options_.threshold);
    }
    return judged;
  }

  [[nodiscard]] JudgedRow algorithm_row(const std::string& algorithm, const std::vector<std::size_t>& members) const {
    const std::vector<double> observations = observations_of(members);
    JudgedRow judged;
    judged.row.name = algorithm == kAll ? kAll : cells_[members.front()].cell.algorithm;
    judged.row.algorithm = algorithm;
    judged.row.observations = observations.size();
    judged.judgement = judge_log_ratios(observations, options_.threshold);
    if (options_.paired) return judged;
    std::vector<double> others;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (std::find(members.begin(), members.end(), i) == members.end()) others.push_back(log_ratios_[i]);
    }
    require_difference_from_others(judged.judgement, observations, others, options_.threshold);
    // Without the yardstick nobody knows whether all algorithms or the machine became slower.
    if (others.empty() && !has_yardstick_) judged.judgement.p_slower = judged.judgement.p_faster = 1;
    return judged;
  }

  [[nodiscard]] std::vector<double> observations_of(const std::vector<std::size_t>& members) const {
    std::vector<const TimedCell*> cells;
    std::vector<double> log_ratios;
    for (const std::size_t i : members) {
      cells.push_back(&cells_[i]);
      log_ratios.push_back(log_ratios_[i]);
    }
    return options_.paired ? typical_by_repetition(cells) : log_ratios;
  }

  /// With the correction for as many tests as there are rows.
  [[nodiscard]] std::vector<TimeRow> decided(const std::vector<JudgedRow>& judged) const {
    std::vector<double> slower, faster;
    for (const JudgedRow& one : judged) {
      slower.push_back(one.judgement.p_slower);
      faster.push_back(one.judgement.p_faster);
    }
    slower = benjamini_hochberg(slower);
    faster = benjamini_hochberg(faster);
    std::vector<TimeRow> rows;
    for (std::size_t i = 0; i < judged.size(); ++i) {
      TimeRow& row = rows.emplace_back(judged[i].row);
      row.ratio = judged[i].judgement.ratio;
      row.q_slower = slower[i];
      row.q_faster = faster[i];
      if (row.q_slower <= options_.error_rate && row.ratio.lower > 1 + options_.threshold)
        row.verdict = Verdict::regression;
      if (row.q_faster <= options_.error_rate && row.ratio.upper < 1 / (1 + options_.threshold))
        row.verdict = Verdict::improvement;
    }
    return rows;
  }

  const std::vector<TimedCell>& cells_;
  const CompareOptions& options_;
  bool has_yardstick_;
  std::vector<double> log_ratios_;  // of each cell
};

class Comparer {
 public:
  Comparer(const ResultSet& base, const ResultSet& now, const CompareOptions& options)
      : base_(base), now_(now), runs_of_base_(by_cell(base.runs)), runs_of_now_(by_cell(now.runs)) {
    comparison_.options = options;
  }

  Comparison compare() {
    collect_common_cells();
    for (const CommonCell& cell : common_) {
      const auto findings = exact_findings(cell.cell, cell.base, cell.now, comparison_.options.threshold);
      comparison_.findings.insert(comparison_.findings.end(), findings.begin(), findings.end());
    }
    if (may_compare_times()) compare_times();
    return std::move(comparison_);
  }

 private:
  void note(const std::string& text) { comparison_.notes.push_back(text); }

  void note_count(std::size_t count, const std::string& what) {
    if (count > 0) note(std::to_string(count) + (count == 1 ? " cell " : " cells ") + what);
  }

  void collect_common_cells() {
    std::size_t other_instances = 0;
    for (const auto& [cell, runs] : runs_of_now_) {
      const auto before = runs_of_base_.find(cell);
      if (before == runs_of_base_.end()) continue;
      CommonCell common{cell, before->second, runs};
      if (same_instance(common)) {
        common_.push_back(std::move(common));
      } else {
        ++other_instances;
      }
    }
    if (common_.empty()) throw InputError(base_.folder + " and " + now_.folder + " have no cell in common");
    comparison_.compared_cells = common_.size();
    note_count(other_instances, "not compared: the generator makes other points now");
    note_count(runs_of_base_.size() - common_.size() - other_instances, "only in the base");
    note_count(runs_of_now_.size() - common_.size() - other_instances, "only in the new results");
  }

  bool may_compare_times() {
    if (machines_of(base_) == machines_of(now_)) return true;
    note(std::string("the machines differ") + (comparison_.options.force
                                                   ? ": ratios of times say as much about them as about the programs"
                                                   : ": times are not compared (--force compares them nevertheless)"));
    return comparison_.options.force;
  }

  const Measure& choose_measure() const {
    if (comparison_.options.time_measure) return measure_named(*comparison_.options.time_measure);
    const Measure& relative = measure_named("relative_time");
    const auto has_time = [](const Measure& measure, const CommonCell& cell) {
      return typical(measure, cell.base) && typical(measure, cell.now);
    };
    const Measure& wall = measure_named("wall_time_s");
    const bool all_relative = std::all_of(common_.begin(), common_.end(), [&](const CommonCell& cell) {
      return has_time(relative, cell) || !has_time(wall, cell);
    });
    if (all_relative && !comparison_.options.paired) return relative;
    const bool by_cpu = std::all_of(common_.begin(), common_.end(), [](const CommonCell& cell) {
      return cell.cell.threads == 1 && has_steady_cpu_time(cell.base) && has_steady_cpu_time(cell.now);
    });
    return by_cpu ? measure_named("cpu_time_s") : wall;
  }

  void compare_times() {
    const Measure& measure = choose_measure();
    std::vector<TimedCell> timed;
    for (const CommonCell& cell : common_) {
      if (same_binary(cell) && !comparison_.options.force) {
        add_identical_row(cell, measure);
        continue;
      }
      TimedCell times{cell.cell, log_times(measure, cell.base), log_times(measure, cell.now)};
      const bool comparable =
          comparison_.options.paired ? !paired_log_ratios(times).empty() : !times.base.empty() && !times.now.empty();
      if (comparable) timed.push_back(std::move(times));
    }
    note_count(comparison_.cells.size(), "run by one and the same binary on both sides: their times are not judged");
    comparison_.time_measure = measure.name;
    if (timed.empty()) return;
    note_weaknesses(timed, measure.name == "relative_time");
    const TimeTable table(timed, comparison_.options, measure.name == "relative_time");
    comparison_.algorithms = table.algorithm_rows();
    const std::vector<TimeRow> rows = table.cell_rows();
    comparison_.cells.insert(comparison_.cells.end(), rows.begin(), rows.end());
  }

  void add_identical_row(const CommonCell& cell, const Measure& measure) {
    const auto before = typical(measure, cell.base);
    const auto after = typical(measure, cell.now);
    if (!before || !after) return;
    TimeRow row;
    row.name = cell.cell.algorithm;
    row.algorithm = algorithm_label(cell.cell);
    row.instance = instance_label(cell.cell);
    row.observations = std::min(before->runs, after->runs);
    row.base = before->value;
    row.now = after->value;
    const double ratio = after->value / before->value;
    row.ratio = {ratio, ratio, ratio};
    row.verdict = Verdict::identical_binary;
    comparison_.cells.push_back(row);
  }

  void note_weaknesses(const std::vector<TimedCell>& timed, bool has_yardstick) {
    if (comparison_.options.paired) return;
    note(
        "measured at different times: only differences beyond what the machine's mood explains are told; "
        "--build-a and --build-b compare two builds more keenly");
    if (!has_yardstick) note("no yardstick in these results: what slows all algorithms alike cannot be told");
    if (timed.size() < kCellsToTellSpread)
      note("too few cells to see how differently the two sessions treat them: cells are judged by repetitions alone");
  }

  const ResultSet& base_;
  const ResultSet& now_;
  std::map<TrackedCell, Runs> runs_of_base_;
  std::map<TrackedCell, Runs> runs_of_now_;
  std::vector<CommonCell> common_;
  Comparison comparison_;
};

bool is_regression(const TimeRow& row) { return row.verdict == Verdict::regression; }

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::same: return "same";
    case Verdict::regression: return "regression";
    case Verdict::improvement: return "improvement";
    case Verdict::identical_binary: return "identical binary";
  }
  return "";
}

bool Comparison::has_exact_regression() const {
  return std::any_of(findings.begin(), findings.end(),
                     [](const ExactFinding& finding) { return finding.is_regression; });
}

bool Comparison::has_regression() const {
  return has_exact_regression() || std::any_of(algorithms.begin(), algorithms.end(), is_regression) ||
         std::any_of(cells.begin(), cells.end(), is_regression);
}

std::vector<std::string> Comparison::slower_algorithms() const {
  std::set<std::string> slower, all;
  for (const std::vector<TimeRow>* rows : {&algorithms, &cells}) {
    for (const TimeRow& row : *rows) {
      if (row.name != kAll) all.insert(row.name);
      if (is_regression(row)) slower.insert(row.name);
    }
  }
  const std::set<std::string>& chosen = slower.contains(kAll) ? all : slower;
  return {chosen.begin(), chosen.end()};
}

Comparison compare(const ResultSet& base, const ResultSet& now, const CompareOptions& options) {
  return Comparer(base, now, options).compare();
}

}  // namespace mwt
