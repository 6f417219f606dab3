#include "harness/paper/paper_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kMostAlgorithms = 10;  // more lines cannot be told apart in one figure

CellKey key_of(const RunRecord& run) { return {run.generator, run.generator_params, run.algorithm, run.params, run.n}; }

bool is_named(const std::vector<std::string>& names, const std::string& label, const std::string& entry) {
  return std::ranges::any_of(names, [&](const std::string& name) { return name == label || name == entry; });
}

void require_known(const std::vector<std::string>& names, const std::set<std::string>& known, const std::string& what) {
  for (const std::string& name : names) {
    if (known.contains(name)) continue;
    const std::vector<std::string> all(known.begin(), known.end());
    throw InputError("the study has no " + what + " '" + name + "'; it has: " + joined(all));
  }
}

void require_known(const ReportData& report, const PaperSelection& selection) {
  std::set<std::string> families, algorithms, sizes;
  for (const Cell& cell : report.cells) {
    families.insert({report.labels.family(cell.key), cell.key.generator});
    algorithms.insert({report.labels.algorithm(cell.key), cell.key.algorithm});
    sizes.insert(std::to_string(cell.key.n));
  }
  require_known(selection.families, families, "family");
  require_known(selection.algorithms, algorithms, "algorithm");
  std::vector<std::string> chosen_sizes;
  for (const Index n : selection.sizes) chosen_sizes.push_back(std::to_string(n));
  require_known(chosen_sizes, sizes, "size");
}

bool is_chosen(const RunRecord& run, const ReportData& report, const PaperSelection& selection) {
  const CellKey key = key_of(run);
  if (!selection.families.empty() && !is_named(selection.families, report.labels.family(key), run.generator))
    return false;
  if (!selection.sizes.empty() && std::ranges::find(selection.sizes, run.n) == selection.sizes.end()) return false;
  return selection.algorithms.empty() || is_named(selection.algorithms, report.labels.algorithm(key), run.algorithm);
}

// The repetitions of one algorithm on one instance.
struct Repetitions {
  std::vector<double> times, lower, upper;
  PaperOutcome outcome;

  void add(const RunRecord& run) {
    if (run.status == RunStatus::not_applicable) return;
    if (!outcome.is_run) outcome.is_optimal = true;
    outcome.is_run = true;
    if (run.status != RunStatus::ok) {
      if (outcome.status.empty() || outcome.status == "ok") outcome.status = name_of(run.status);
      return;
    }
    if (outcome.status.empty()) outcome.status = "ok";
    outcome.is_early = outcome.is_early || run.stopped_early.value_or(false);
    outcome.is_optimal = outcome.is_optimal && run.optimal == "yes" && run.optimality == "proved";
    if (run.wall_time_s) times.push_back(*run.wall_time_s);
    if (run.optimality == "proved" && run.alpha_lower && run.alpha_upper) {
      lower.push_back(*run.alpha_lower);
      upper.push_back(*run.alpha_upper);
    }
  }

  [[nodiscard]] PaperOutcome finished() const {
    PaperOutcome result = outcome;
    result.is_optimal = result.is_optimal && result.status == "ok";
    if (!times.empty()) result.time_s = median(times);
    if (!lower.empty()) {
      result.alpha_lower = median(lower);
      result.alpha_upper = median(upper);
    }
    return result;
  }
};

struct Collection {
  std::map<std::string, std::size_t> algorithm_numbers;
  std::map<std::tuple<std::string, Index, std::uint64_t>, std::size_t> instance_numbers;
  std::vector<PaperInstance> instances;
  std::vector<std::vector<Repetitions>> repetitions;  // by algorithm, then by instance

  void add(const RunRecord& run, const Labels& labels) {
    const CellKey key = key_of(run);
    const std::string family = labels.family(key);
    const auto [place, is_new] = instance_numbers.try_emplace({family, run.n, run.seed}, instances.size());
    if (is_new) instances.push_back({run.instance_id, family, run.n, run.seed, false});
    PaperInstance& instance = instances[place->second];
    if (instance.instance_id.empty()) instance.instance_id = run.instance_id;
    instance.has_optimum = instance.has_optimum || run.optimality == "proved";
    std::vector<Repetitions>& of_algorithm = repetitions[algorithm_numbers.at(labels.algorithm(key))];
    if (of_algorithm.size() <= place->second) of_algorithm.resize(place->second + 1);
    of_algorithm[place->second].add(run);
  }
};

bool is_comparable(const PaperOutcome& outcome) {
  // A run on another machine than that of the report has no time; it cannot be compared by it.
  return outcome.is_run && (outcome.status != "ok" || outcome.time_s);
}

std::size_t number_of_runs(const PaperData& data, std::size_t algorithm) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < data.instances.size(); ++i)
    count += data.instances[i].has_optimum && is_comparable(data.outcomes[algorithm][i]);
  return count;
}

// The chosen algorithms, ascending.
std::vector<std::size_t> best_covered(const PaperData& data) {
  std::vector<std::size_t> order;
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) order.push_back(a);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t a) { return number_of_runs(data, a); });
  std::vector<bool> is_common;
  for (const PaperInstance& instance : data.instances) is_common.push_back(instance.has_optimum);
  std::size_t best_count = 0, best_product = 0;
  for (std::size_t count = 1; count <= std::min(order.size(), kMostAlgorithms); ++count) {
    const std::vector<PaperOutcome>& of_algorithm = data.outcomes[order[count - 1]];
    for (std::size_t i = 0; i < is_common.size(); ++i) is_common[i] = is_common[i] && is_comparable(of_algorithm[i]);
    const std::size_t product = count * static_cast<std::size_t>(std::ranges::count(is_common, true));
    if (product < best_product || product == 0) continue;
    best_count = count;
    best_product = product;
  }
  order.resize(best_count > 0 ? best_count : std::min(order.size(), kMostAlgorithms));
  std::ranges::sort(order);
  return order;
}

PaperData with_algorithms(const PaperData& data, const std::vector<std::size_t>& chosen) {
  PaperData result = data;
  result.algorithms.clear();
  result.outcomes.clear();
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    if (std::ranges::find(chosen, a) == chosen.end()) {
      result.left_out.push_back(data.algorithms[a]);
      continue;
    }
    result.algorithms.push_back(data.algorithms[a]);
    result.outcomes.push_back(data.outcomes[a]);
  }
  return result;
}

// Labels of the algorithms in the order of the report.
std::vector<std::string> algorithm_labels(const ReportData& report) {
  std::vector<std::string> labels;
  for (const Cell& cell : report.cells) {
    const std::string label = report.labels.algorithm(cell.key);
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  }
  return labels;
}

}  // namespace

std::string name_of(PaperMeasure measure) { return measure == PaperMeasure::gap ? "gap" : "time"; }

std::vector<std::size_t> PaperData::common(PaperMeasure measure) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (measure == PaperMeasure::gap && !instances[i].has_optimum) continue;
    const auto can_be_compared = [&](const std::vector<PaperOutcome>& of_algorithm) {
      const PaperOutcome& outcome = of_algorithm[i];
      return measure == PaperMeasure::gap ? outcome.is_run : is_comparable(outcome);
    };
    if (std::ranges::all_of(outcomes, can_be_compared)) result.push_back(i);
  }
  return result;
}

std::vector<std::size_t> PaperData::common(PaperMeasure measure, const std::string& family) const {
  std::vector<std::size_t> result = common(measure);
  std::erase_if(result, [&](std::size_t i) { return instances[i].family != family; });
  return result;
}

double PaperData::value(PaperMeasure measure, std::size_t algorithm, std::size_t instance) const {
  const PaperOutcome& outcome = outcomes[algorithm][instance];
  if (outcome.status != "ok") return kPaperFailure;
  if (measure == PaperMeasure::time) return outcome.time_s.value();
  return outcome.is_optimal ? 0 : std::max(0.0, outcome.alpha_upper - 1);
}

std::vector<double> PaperData::values(PaperMeasure measure, std::size_t algorithm,
                                      const std::vector<std::size_t>& of) const {
  std::vector<double> result;
  for (const std::size_t i : of) result.push_back(value(measure, algorithm, i));
  return result;
}

double PaperData::difference(PaperMeasure measure, std::size_t first, std::size_t second, std::size_t instance) const {
  const double a = value(measure, first, instance);
  const double b = value(measure, second, instance);
  if (std::isinf(a) || std::isinf(b)) return a == b ? 0 : b - a;
  if (measure == PaperMeasure::time) return std::log(b) - std::log(a);
  const PaperOutcome& of_first = outcomes[first][instance];
  const PaperOutcome& of_second = outcomes[second][instance];
  const bool overlap = of_first.alpha_lower <= of_second.alpha_upper && of_second.alpha_lower <= of_first.alpha_upper;
  return overlap ? 0 : of_second.alpha_upper - of_first.alpha_upper;
}

PaperData select_for_paper(const ReportData& report, const PaperSelection& selection) {
  require_known(report, selection);
  PaperData data;
  data.study = report.records.runs.front().study;
  data.algorithms = algorithm_labels(report);
  Collection collection;
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) collection.algorithm_numbers[data.algorithms[a]] = a;
  collection.repetitions.resize(data.algorithms.size());
  for (const RunRecord& run : report.records.runs) {
    if (is_chosen(run, report, selection)) collection.add(run, report.labels);
  }
  data.instances = std::move(collection.instances);
  std::vector<std::size_t> used;
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    std::vector<PaperOutcome> outcomes;
    for (const Repetitions& repetitions : collection.repetitions[a]) outcomes.push_back(repetitions.finished());
    outcomes.resize(data.instances.size());
    if (std::ranges::any_of(outcomes, &PaperOutcome::is_run)) used.push_back(a);
    data.outcomes.push_back(std::move(outcomes));
  }
  data = with_algorithms(data, used);
  if (selection.algorithms.empty()) data = with_algorithms(data, best_covered(data));
  if (data.common(PaperMeasure::time).empty()) {
    throw InputError(report.folder + ": no instance was run by all of the algorithms " + joined(data.algorithms) +
                     "; choose fewer with --algorithms, or other --families or --sizes");
  }
  return data;
}

}  // namespace mwt
