#include "harness/tracking/comparison/comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/records/machine_state.h"
#include "harness/records/profile_folder.h"
#include "harness/statistics/quantile.h"
#include "harness/statistics/shift.h"

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

/// Runs without an instance failed before they had one; they are no sign of another instance.
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

std::set<std::string> machines_of(const ResultSet& results, const Runs& runs) {
  std::set<std::string> machines;
  for (const RunRecord* run : runs) machines.insert(machine_of(results.environment_of(*run)));
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

bool has_cpu_times(const Runs& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const RunRecord* run) {
    return run->status != RunStatus::ok || run->cpu_time_s.value_or(0) > 0;
  });
}

MachineState state_of(const ResultSet& results) { return machine_state_of(results.runs, results.environments); }

std::string commit_of(const ResultSet& results) {
  std::set<std::string> commits;
  for (const RunRecord& run : results.runs) commits.insert(run.git_commit);
  return commits.size() == 1 && !commits.begin()->empty() ? *commits.begin() : "unknown";
}

std::string cell_label(const TrackedCell& cell) { return algorithm_label(cell) + " on " + instance_label(cell); }

bool succeeded(const Runs& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const RunRecord* run) { return run->status == RunStatus::ok; });
}

/// "3 cells only in the base: a; b; c", a few of them by name.
std::string naming(const std::vector<std::string>& cells, const std::string& what) {
  constexpr std::size_t kNamed = 5;
  std::string text = fmt::format("{} {}: ", counted(cells.size(), "cell"), what);
  for (std::size_t i = 0; i < std::min(kNamed, cells.size()); ++i) text += (i == 0 ? "" : "; ") + cells[i];
  return cells.size() > kNamed ? fmt::format("{}; and {} more", text, cells.size() - kNamed) : text;
}

class Comparer {
 public:
  Comparer(const ResultSet& base, const ResultSet& now, const CompareOptions& options)
      : base_(base), now_(now), runs_of_base_(by_cell(base.runs)), runs_of_now_(by_cell(now.runs)) {
    comparison_.options = options;
    comparison_.base_commit = commit_of(base);
    comparison_.new_commit = commit_of(now);
    profiles_.base = [&base](const RunRecord& run) { return read_profile(base.folder, run.run_id); };
    profiles_.now = [&now](const RunRecord& run) { return read_profile(now.folder, run.run_id); };
  }

  Comparison compare() {
    collect_common_cells();
    for (const CommonCell& cell : common_) {
      const auto findings = exact_findings(cell.cell, cell.base, cell.now, comparison_.options.threshold, profiles_);
      comparison_.findings.insert(comparison_.findings.end(), findings.begin(), findings.end());
    }
    find_what_vanished();
    note_counts();
    name_failing_cells();
    compare_times();
    return std::move(comparison_);
  }

 private:
  void note(const std::string& text) { comparison_.notes.push_back(text); }

  void name_cells(const std::vector<std::string>& cells, const std::string& what) {
    if (!cells.empty()) note(naming(cells, what));
  }

  void note_count(std::size_t count, const std::string& what) {
    if (count > 0) note(fmt::format("{} {}", counted(count, "cell"), what));
  }

  void collect_common_cells() {
    std::vector<std::string> other_instances;
    for (const auto& [cell, runs] : runs_of_now_) {
      const auto before = runs_of_base_.find(cell);
      if (before == runs_of_base_.end()) {
        comparison_.only_in_new.push_back(cell_label(cell));
        continue;
      }
      CommonCell common{cell, before->second, runs};
      if (same_instance(common)) {
        common_.push_back(std::move(common));
      } else {
        other_instances.push_back(cell_label(cell));
      }
    }
    for (const auto& [cell, runs] : runs_of_base_) {
      if (!runs_of_now_.contains(cell)) comparison_.only_in_base.push_back(cell_label(cell));
    }
    if (common_.empty()) throw InputError(base_.folder + " and " + now_.folder + " have no cell in common");
    comparison_.compared_cells = common_.size();
    name_cells(other_instances, "not compared: the generator makes other points now");
    name_cells(comparison_.only_in_base, "only in the base");
    name_cells(comparison_.only_in_new, "only in the new results");
  }

  void note_counts() {
    const auto is_counted = [](const Runs& runs) {
      return std::ranges::any_of(kComparedCounts,
                                 [&](const char* name) { return !values_of(measure_named(name), runs).empty(); });
    };
    std::size_t counted_cells = 0;
    for (const CommonCell& cell : common_) counted_cells += is_counted(cell.base) && is_counted(cell.now) ? 1 : 0;
    if (counted_cells == 0) return;
    note(fmt::format("instructions were counted on both sides in {} of {}: a difference of {}% counts", counted_cells,
                     counted(common_.size(), "cell"), 100 * kCountThreshold));
    for (const ExactFinding& finding : comparison_.findings) {
      if (finding.is_confirmed) continue;
      note("counted once on a side, and not confirmed by a second run: " + cell_label(finding.cell) + ": " +
           finding.text);
    }
  }

  /// What failed before and fails now is no finding, but it is listed.
  void name_failing_cells() {
    std::vector<std::string> failing;
    const auto has_failure = [](const Runs& runs) {
      return std::any_of(runs.begin(), runs.end(), [](const RunRecord* run) { return is_failure(run->status); });
    };
    for (const CommonCell& cell : common_) {
      if (has_failure(cell.base) && has_failure(cell.now)) failing.push_back(cell_label(cell.cell));
    }
    name_cells(failing, "with failed runs on both sides");
  }

  /// An algorithm of the base without any cell in the new results, or a cell of one that has others: whoever relies on
  /// it misses it.
  void find_what_vanished() {
    std::set<std::string> present;
    for (const auto& [cell, runs] : runs_of_now_) present.insert(algorithm_label(cell));
    std::map<std::string, std::pair<TrackedCell, std::size_t>> vanished;
    for (const auto& [cell, runs] : runs_of_base_) {
      if (runs_of_now_.contains(cell)) continue;
      if (present.contains(algorithm_label(cell))) {
        comparison_.findings.push_back({cell, Aspect::failures, true, "is not run any more"});
        continue;
      }
      TrackedCell algorithm = cell;
      algorithm.generator = algorithm.generator_params = "";
      algorithm.n = 0;
      algorithm.seed = 0;
      ++vanished.try_emplace(algorithm_label(cell), algorithm, 0).first->second.second;
    }
    for (const auto& [label, algorithm] : vanished) {
      const std::string cells = counted(algorithm.second, "cell");
      comparison_.findings.push_back(
          {algorithm.first, Aspect::failures, true, "has no runs any more; the base has " + cells});
    }
  }

  /// Of different machines only if forced; otherwise the cells are left out, and counted.
  bool may_compare_times(const CommonCell& cell) {
    const std::set<std::string> base = machines_of(base_, cell.base);
    if (base.size() == 1 && base == machines_of(now_, cell.now)) return true;
    ++comparison_.cells_of_other_machines;
    return comparison_.options.force;
  }

  void note_other_machines() {
    const std::size_t count = comparison_.cells_of_other_machines;
    if (count == 0) return;
    const std::string cells = count == common_.size() ? "" : fmt::format(" of {} cells", count);
    note("the machines differ" + (comparison_.options.force
                                      ? ": ratios of times" + cells + " compare the machines as much as the programs"
                                      : ": times" + cells + " are not compared (--force compares them nevertheless)"));
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
      return cell.cell.threads == 1 && has_cpu_times(cell.base) && has_cpu_times(cell.now);
    });
    return by_cpu ? measure_named("cpu_time_s") : wall;
  }

  void compare_times() {
    const Measure& measure = choose_measure();
    note_load();
    std::vector<TimedCell> timed;
    for (const CommonCell& cell : common_) {
      if (!may_compare_times(cell)) continue;
      comparison_.time_measure = measure.name;
      if (same_binary(cell) && !comparison_.options.force) {
        add_identical_row(cell, measure);
        continue;
      }
      TimedCell times{cell.cell, log_times(measure, cell.base), log_times(measure, cell.now)};
      const bool comparable =
          comparison_.options.paired ? !paired_log_ratios(times).empty() : !times.base.empty() && !times.now.empty();
      if (comparable) {
        timed.push_back(std::move(times));
      } else if (succeeded(cell.base) && succeeded(cell.now)) {
        comparison_.untimed.push_back(cell_label(cell.cell));
      }
    }
    note_other_machines();
    name_cells(comparison_.untimed, "whose times are missing though runs succeeded");
    note_count(comparison_.cells.size(), "run by one and the same binary on both sides: their times are not judged");
    if (timed.empty()) return;
    note_weaknesses(timed, measure.name == "relative_time");
    TimeTable table = make_time_table(timed, comparison_.options, measuring(measure.name == "relative_time"));
    comparison_.algorithms = std::move(table.algorithms);
    comparison_.cells.insert(comparison_.cells.end(), table.cells.begin(), table.cells.end());
  }

  void note_load() { note("load: base " + load_text(state_of(base_)) + "; new results " + load_text(state_of(now_))); }

  /// Pairs can exclude a slowdown; two folders cannot, unless the machine was in the same state.
  Measuring measuring(bool has_delaunay_time) {
    if (comparison_.options.paired) return {has_delaunay_time, true};
    const std::string difference = difference_of_states(has_delaunay_time);
    if (!difference.empty()) note(difference + ": no slowdown is excluded by these results");
    return {has_delaunay_time, difference.empty()};
  }

  /// Why a slowdown may not show in two folders; empty if there is no reason.
  std::string difference_of_states(bool has_delaunay_time) const {
    if (!has_delaunay_time) return "without the Delaunay time it is unknown whether the machine was as fast both times";
    for (const ResultSet* side : {&base_, &now_}) {
      if (was_busy(state_of(*side))) return "the machine was busy with other programs";
      if (!was_idle(state_of(*side)))
        return "without CPU times it is unknown whether the machine was busy with other programs";
    }
    std::vector<double> log_ratios;
    for (const CommonCell& cell : common_) {
      const auto before = delaunay_time_of(cell.base), after = delaunay_time_of(cell.now);
      if (before && after) log_ratios.push_back(std::log(*after / *before));
    }
    const double ratio = std::exp(pseudo_median(log_ratios));
    const double most = 1 + comparison_.options.threshold;
    if (ratio <= most && ratio >= 1 / most) return "";
    return "the Delaunay time itself took x" + fixed(ratio, 3) + " as long";
  }

  static std::optional<double> delaunay_time_of(const Runs& runs) {
    std::vector<double> times;
    for (const RunRecord* run : runs) {
      if (run->delaunay_time_s.value_or(0) > 0) times.push_back(*run->delaunay_time_s);
    }
    return times.empty() ? std::nullopt : std::optional(median(times));
  }

  void add_identical_row(const CommonCell& cell, const Measure& measure) {
    const auto before = typical(measure, cell.base);
    const auto after = typical(measure, cell.now);
    if (!before || !after) return;
    TimeRow row;
    row.name = cell.cell.algorithm;
    row.algorithm = algorithm_label(cell.cell);
    row.instance = instance_label(cell.cell);
    row.cell = cell.cell;
    row.observations = std::min(before->runs, after->runs);
    row.base = before->value;
    row.now = after->value;
    const double ratio = after->value / before->value;
    row.ratio = {ratio, ratio, ratio};
    row.verdict = Verdict::identical_binary;
    comparison_.cells.push_back(row);
  }

  void note_weaknesses(const std::vector<TimedCell>& timed, bool has_delaunay_time) {
    if (comparison_.options.paired) return note_too_few_pairs(timed);
    note(
        "measured at different times: only differences beyond machine drift are reported; --build-a and --build-b run "
        "two builds in turn, which shows smaller ones");
    if (!has_delaunay_time) note("no Delaunay time in these results: what slows all algorithms alike does not show");
    if (timed.size() < kMinCellsForSpread)
      note("too few cells to see how differently the two sessions treat them: cells are judged by repetitions alone");
  }

  /// The smallest p-value of k pairs is 2^-k; one cell alone must reach error_rate / (number of cells).
  void note_too_few_pairs(const std::vector<TimedCell>& timed) {
    std::size_t pairs = paired_log_ratios(timed.front()).size();
    for (const TimedCell& cell : timed) pairs = std::min(pairs, paired_log_ratios(cell).size());
    const double cells = static_cast<double>(timed.size());
    const auto needed = static_cast<std::size_t>(std::ceil(std::log2(cells / comparison_.options.error_rate)));
    if (pairs < needed) {
      note(fmt::format(
          "too few repetitions to distinguish a single cell's change from noise: {} are needed for so many cells",
          needed));
    }
  }

  const ResultSet& base_;
  const ResultSet& now_;
  std::map<TrackedCell, Runs> runs_of_base_;
  std::map<TrackedCell, Runs> runs_of_now_;
  std::vector<CommonCell> common_;
  Profiles profiles_;
  Comparison comparison_;
};

bool is_regression(const TimeRow& row) { return row.verdict == Verdict::regression; }

}  // namespace

bool Comparison::has_sure_regression() const {
  return std::any_of(findings.begin(), findings.end(), [](const ExactFinding& finding) {
    return finding.is_regression && finding.is_confirmed && !finding.depends_on_speed;
  });
}

bool Comparison::has_regression() const {
  const auto is_worse = [](const ExactFinding& finding) { return finding.is_regression && finding.is_confirmed; };
  return std::any_of(findings.begin(), findings.end(), is_worse) ||
         std::any_of(algorithms.begin(), algorithms.end(), is_regression) ||
         std::any_of(cells.begin(), cells.end(), is_regression);
}

Outcome Comparison::outcome() const {
  if (has_regression()) return Outcome::regression;
  if (cells_of_other_machines > 0 && !options.force) return Outcome::not_compared;
  return open_cells().empty() && untimed.empty() ? Outcome::not_slower : Outcome::unclear;
}

std::set<TrackedCell> Comparison::cells_that_are(const std::set<Verdict>& verdicts) const {
  std::set<std::string> chosen_algorithms;
  for (const TimeRow& row : algorithms) {
    if (verdicts.contains(row.verdict)) chosen_algorithms.insert(row.algorithm);
  }
  const bool are_all_chosen = chosen_algorithms.contains(kAllAlgorithms);
  std::set<TrackedCell> chosen;
  for (const TimeRow& row : cells) {
    if (row.verdict == Verdict::identical_binary) continue;
    if (are_all_chosen || chosen_algorithms.contains(row.algorithm) || verdicts.contains(row.verdict))
      chosen.insert(*row.cell);
  }
  return chosen;
}

std::set<TrackedCell> Comparison::open_cells() const {
  std::set<TrackedCell> open = cells_that_are({Verdict::regression, Verdict::unclear});
  for (const ExactFinding& finding : findings) {
    if (finding.is_regression && (finding.depends_on_speed || !finding.is_confirmed)) open.insert(finding.cell);
  }
  return open;
}

std::string name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::regression: return "regression";
    case Outcome::not_compared: return "not compared";
    case Outcome::unclear: return "unclear";
    case Outcome::not_slower: return "not slower";
  }
  return "";
}

Comparison compare(const ResultSet& base, const ResultSet& now, const CompareOptions& options) {
  if (base.schema_version != now.schema_version) {
    throw InputError(
        fmt::format("{} holds records of schema version {}, {} of version {}: their columns need not mean the same; "
                    "run the older study anew",
                    base.folder, base.schema_version, now.folder, now.schema_version));
  }
  if (base.has_ticking_clock == now.has_ticking_clock) return Comparer(base, now, options).compare();
  // What one side was timed with must be what the other side was timed with.
  return Comparer(without_short_cpu_times(base), without_short_cpu_times(now), options).compare();
}

}  // namespace mwt
