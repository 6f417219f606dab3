#include "harness/tracking/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/error.h"

namespace mwt {

namespace {

using Runs = std::vector<const RunRecord*>;

/// A cell that both sides have.
struct CommonCell {
  TrackedCell cell;
  Runs base;
  Runs now;
};

std::set<std::string> values_of_field(const Runs& runs, std::string RunRecord::*field) {
  std::set<std::string> values;
  for (const RunRecord* run : runs) values.insert(run->*field);
  return values;
}

/// Runs without an instance have failed before they had one; they do not say that it is another.
bool same_instance(const CommonCell& cell) {
  std::set<std::string> base = values_of_field(cell.base, &RunRecord::instance_id);
  std::set<std::string> now = values_of_field(cell.now, &RunRecord::instance_id);
  base.erase("");
  now.erase("");
  return base.empty() || now.empty() || base == now;
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

/// Whether every successful run was measured long enough for the ticks of CPU clocks, which may last milliseconds.
bool has_steady_cpu_time(const Runs& runs) {
  constexpr double kLongEnough = 0.01;
  return std::all_of(runs.begin(), runs.end(), [](const RunRecord* run) {
    if (run->status != RunStatus::ok) return true;
    return run->wall_time_s.value_or(0) * static_cast<double>(run->iterations.value_or(1)) >= kLongEnough;
  });
}

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
    TimeTable table = make_time_table(timed, comparison_.options, measure.name == "relative_time");
    comparison_.algorithms = std::move(table.algorithms);
    comparison_.cells.insert(comparison_.cells.end(), table.cells.begin(), table.cells.end());
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
    if (comparison_.options.paired) return note_too_few_pairs(timed);
    note(
        "measured at different times: only differences beyond machine drift are reported; "
        "--build-a and --build-b compare two builds more keenly");
    if (!has_yardstick) note("no yardstick in these results: what slows all algorithms alike cannot be seen");
    if (timed.size() < kCellsToTellSpread)
      note("too few cells to see how differently the two sessions treat them: cells are judged by repetitions alone");
  }

  /// The smallest p-value of k pairs is 2^-k; one cell alone must reach error_rate / (number of cells).
  void note_too_few_pairs(const std::vector<TimedCell>& timed) {
    std::size_t pairs = paired_log_ratios(timed.front()).size();
    for (const TimedCell& cell : timed) pairs = std::min(pairs, paired_log_ratios(cell).size());
    const double cells = static_cast<double>(timed.size());
    const auto needed = static_cast<std::size_t>(std::ceil(std::log2(cells / comparison_.options.error_rate)));
    if (pairs < needed) {
      note("too few repetitions to tell a single cell's change from noise: " + std::to_string(needed) +
           " are needed for so many cells");
    }
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
      if (row.name != kAllAlgorithms) all.insert(row.name);
      if (is_regression(row)) slower.insert(row.name);
    }
  }
  const std::set<std::string>& chosen = slower.contains(kAllAlgorithms) ? all : slower;
  return {chosen.begin(), chosen.end()};
}

Comparison compare(const ResultSet& base, const ResultSet& now, const CompareOptions& options) {
  return Comparer(base, now, options).compare();
}

}  // namespace mwt
