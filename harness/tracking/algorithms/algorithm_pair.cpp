#include "harness/tracking/algorithms/algorithm_pair.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/error.h"
#include "geometry/numbers/interval.h"
#include "harness/io/text/text.h"
#include "harness/statistics/false_discovery.h"
#include "harness/statistics/quantile.h"
#include "harness/tracking/cell.h"
#include "harness/tracking/measures.h"

namespace mwt {

namespace {

using RunsOfOne = std::vector<const RunRecord*>;

/// The points of a run: also by their hash, for a name may stand for other points in another build.
using PairKey = std::tuple<std::string, Index, std::uint64_t, std::string>;  // family, n, seed, instance_id

/// The successful runs of both algorithms on the same points.
struct InstancePair {
  RunsOfOne a;
  RunsOfOne b;
};

/// What one algorithm has on some points.
struct SideOfPair {
  RunsOfOne successful;
  std::set<std::string> failures;
};

bool is_called(const std::string& label, const std::string& wanted) {
  const std::vector<std::string> words = split(wanted, ' '), known = split(label, ' ');
  if (words.front() != known.front()) return false;
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return std::ranges::find(known, word) != known.end(); });
}

std::string chosen_algorithm(const ResultSet& results, const std::string& option, const std::string& wanted) {
  std::set<std::string> labels;
  for (const RunRecord& run : results.runs) labels.insert(algorithm_label(cell_of(run)));
  if (labels.contains(wanted)) return wanted;
  std::vector<std::string> called;
  for (const std::string& label : labels) {
    if (is_called(label, wanted)) called.push_back(label);
  }
  if (called.size() == 1) return called.front();
  if (!called.empty())
    throw InputError(fmt::format("{} {}: {} has several of these; add a parameter, as in \"{}\"; there are: {}", option,
                                 wanted, results.folder, called.front(), joined(called)));
  throw InputError(fmt::format("{} {}: {} has no such algorithm; it has: {}", option, wanted, results.folder,
                               joined({labels.begin(), labels.end()})));
}

std::map<PairKey, SideOfPair> sides_of(const ResultSet& results, const std::string& algorithm) {
  std::map<PairKey, SideOfPair> sides;
  for (const RunRecord& run : results.runs) {
    const TrackedCell cell = cell_of(run);
    if (algorithm_label(cell) != algorithm || run.instance_id.empty()) continue;
    SideOfPair& side = sides[{family_label(cell), run.n, run.seed, run.instance_id}];
    if (run.status == RunStatus::ok) {
      side.successful.push_back(&run);
    } else {
      side.failures.insert(std::string(name_of(run.status)));
    }
  }
  return sides;
}

Interval weight_of_runs(const RunsOfOne& runs) {
  std::vector<double> lower, upper;
  for (const RunRecord* run : runs) {
    lower.push_back(run->weight_lower.value());
    upper.push_back(run->weight_upper.value());
  }
  return {median(lower), median(upper)};
}

/// log(b / a) of the weights, 0 where the certified intervals meet.
double log_ratio_of_weights(const InstancePair& pair) {
  const Interval a = weight_of_runs(pair.a), b = weight_of_runs(pair.b);
  const bool may_be_equal = a.lower <= b.upper && b.lower <= a.upper;
  return may_be_equal ? 0 : std::log(b.middle() / a.middle());
}

class AlgorithmComparer {
 public:
  AlgorithmComparer(const ResultSet& results, const AlgorithmPairOptions& options) : results_(results) {
    result_.folder = results.folder;
    result_.a = chosen_algorithm(results, "--algorithm-a", options.a);
    result_.b = chosen_algorithm(results, "--algorithm-b", options.b);
    if (result_.a == result_.b) throw InputError("--algorithm-a and --algorithm-b are both " + result_.a);
    collect_pairs();
    result_.time_measure = options.time_measure.value_or(usual_time_measure());
    if (measure_named(result_.time_measure).aspect != Aspect::time)
      throw InputError("--measure " + result_.time_measure +
                       " is not a time; times are relative_time, wall_time_s, cpu_time_s");
  }

  AlgorithmPair compare() {
    note_early_ends();
    compare_alpha();
    compare_times();
    return std::move(result_);
  }

 private:
  /// The observations of a row.
  struct Observations {
    std::vector<double> log_ratios;
    std::vector<double> a;
    std::vector<double> b;
  };

  using Cells = std::map<std::pair<std::string, Index>, Observations>;

  void collect_pairs() {
    std::map<PairKey, SideOfPair> of_a = sides_of(results_, result_.a), of_b = sides_of(results_, result_.b);
    std::size_t only_a = 0, only_b = 0, neither = 0;
    std::set<std::string> failures;
    for (const auto& [key, a] : of_a) {
      const auto b = of_b.find(key);
      if (b == of_b.end()) continue;
      const bool a_is_there = !a.successful.empty(), b_is_there = !b->second.successful.empty();
      if (a_is_there && b_is_there) {
        pairs_[key] = {a.successful, b->second.successful};
        continue;
      }
      ++(a_is_there ? only_a : b_is_there ? only_b : neither);
      failures.insert(a.failures.begin(), a.failures.end());
      failures.insert(b->second.failures.begin(), b->second.failures.end());
    }
    if (pairs_.empty())
      throw InputError(
          fmt::format("{}: no instance on which both {} and {} succeeded", results_.folder, result_.a, result_.b));
    if (only_a + only_b + neither > 0) {
      result_.notes.push_back(fmt::format(
          "left out: {} on which {} alone succeeded, {} on which {} alone did, {} on which neither did ({})",
          counted(only_a, "instance"), result_.a, only_b, result_.b, neither,
          joined({failures.begin(), failures.end()})));
    }
    std::size_t unpaired = 0;
    for (const auto& [key, a] : of_a) unpaired += of_b.contains(key) ? 0 : 1;
    for (const auto& [key, b] : of_b) unpaired += of_a.contains(key) ? 0 : 1;
    if (unpaired > 0)
      result_.notes.push_back(counted(unpaired, "instance") + " left out, on which only one of the two was run");
  }

  void note_early_ends() {
    const auto was_early = [](const RunRecord* run) { return run->stopped_early.value_or(false); };
    std::size_t early_a = 0, early_b = 0;
    for (const auto& [key, pair] : pairs_) {
      early_a += std::ranges::any_of(pair.a, was_early) ? 1 : 0;
      early_b += std::ranges::any_of(pair.b, was_early) ? 1 : 0;
    }
    if (early_a + early_b > 0)
      result_.notes.push_back(fmt::format("stopped early, and compared as they are: {} on {}, {} on {}", result_.a,
                                          counted(early_a, "instance"), result_.b, counted(early_b, "instance")));
  }

  [[nodiscard]] std::string usual_time_measure() const {
    const auto has_cpu_time = [](const RunRecord* run) { return run->threads == 1 && run->cpu_time_s > 0.0; };
    const bool all_have = std::ranges::all_of(pairs_, [&](const auto& pair) {
      return std::ranges::all_of(pair.second.a, has_cpu_time) && std::ranges::all_of(pair.second.b, has_cpu_time);
    });
    return all_have ? "cpu_time_s" : "wall_time_s";
  }

  void compare_alpha() {
    const Measure& alpha = measure_named("alpha");
    Cells cells;
    for (const auto& [key, pair] : pairs_) {
      Observations& cell = cells[{std::get<0>(key), std::get<1>(key)}];
      cell.log_ratios.push_back(log_ratio_of_weights(pair));
      const auto a = typical(alpha, pair.a), b = typical(alpha, pair.b);
      if (a && b) {
        cell.a.push_back(a->value);
        cell.b.push_back(b->value);
      }
    }
    result_.alpha = rows_of(cells);
  }

  void compare_times() {
    const Measure& measure = measure_named(result_.time_measure);
    std::size_t elsewhere = 0, missing = 0;
    Cells cells;
    for (const auto& [key, pair] : pairs_) {
      if (!same_machine(pair)) {
        ++elsewhere;
        continue;
      }
      const auto a = typical(measure, pair.a), b = typical(measure, pair.b);
      if (!a || !b || !(a->value > 0) || !(b->value > 0)) {
        ++missing;
        continue;
      }
      Observations& cell = cells[{std::get<0>(key), std::get<1>(key)}];
      cell.log_ratios.push_back(std::log(b->value / a->value));
      cell.a.push_back(a->value);
      cell.b.push_back(b->value);
    }
    result_.times = rows_of(cells);
    if (elsewhere > 0)
      result_.notes.push_back("times left out of " + counted(elsewhere, "instance") + ": different machines ran them");
    if (missing > 0)
      result_.notes.push_back(fmt::format("times left out of {}: no {}", counted(missing, "instance"), measure.name));
  }

  [[nodiscard]] bool same_machine(const InstancePair& pair) const {
    std::set<std::string> machines;
    for (const RunsOfOne* runs : {&pair.a, &pair.b}) {
      for (const RunRecord* run : *runs) machines.insert(machine_of(results_.environment_of(*run)));
    }
    return machines.size() == 1;
  }

  [[nodiscard]] std::vector<PairRow> rows_of(const Cells& cells) const {
    std::vector<PairRow> rows;
    std::vector<double> all, p_values;
    for (const auto& [place, cell] : cells) {
      PairRow& row = rows.emplace_back(PairRow{place.first, place.second, {}, {}, compare_pairs(cell.log_ratios)});
      if (cell.a.size() == cell.log_ratios.size()) {
        row.a = median(cell.a);
        row.b = median(cell.b);
      }
      all.insert(all.end(), cell.log_ratios.begin(), cell.log_ratios.end());
      p_values.push_back(row.comparison.p_value);
    }
    const std::vector<double> adjusted = benjamini_hochberg(p_values);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].q_value = adjusted[i];
    if (rows.size() > 1) {
      rows.push_back({"all", 0, {}, {}, compare_pairs(all)});
      rows.back().q_value = rows.back().comparison.p_value;
    }
    for (PairRow& row : rows) row.verdict = verdict_of(row);
    return rows;
  }

  [[nodiscard]] PairVerdict verdict_of(const PairRow& row) const {
    if (row.comparison.zero == row.comparison.pairs()) return PairVerdict::equal;
    if (row.q_value > result_.error_rate) return PairVerdict::not_sure;
    return row.comparison.effect < 0 ? PairVerdict::b_is_better : PairVerdict::a_is_better;
  }

  const ResultSet& results_;
  std::map<PairKey, InstancePair> pairs_;
  AlgorithmPair result_;
};

}  // namespace

AlgorithmPair compare_algorithms(const ResultSet& results, const AlgorithmPairOptions& options) {
  return AlgorithmComparer(results, options).compare();
}

}  // namespace mwt
