#include "harness/study/summary.h"

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <set>

#include "harness/aligned_table.h"
#include "harness/text.h"

namespace mwt {

namespace {

// What a table says about a group of runs.
struct Tally {
  std::size_t runs = 0;  // without those that are not applicable
  std::size_t failures = 0;
  std::size_t not_applicable = 0;
  std::size_t optimal = 0;
  std::vector<double> times;
  std::vector<double> alphas;

  void add(const RunRecord& record) {
    if (record.status == RunStatus::not_applicable) {
      ++not_applicable;
      return;
    }
    ++runs;
    if (is_failure(record.status)) ++failures;
    if (record.status != RunStatus::ok) return;
    if (record.optimal == "yes") ++optimal;
    if (record.wall_time_s) times.push_back(*record.wall_time_s);
    // Against a mere lower bound alpha would say more about the bound than about the algorithm.
    if (record.alpha_upper && record.optimality == "proved") alphas.push_back(*record.alpha_upper);
  }

  [[nodiscard]] std::string alpha_mean() const {
    if (alphas.empty()) return "-";
    return fixed(std::accumulate(alphas.begin(), alphas.end(), 0.0) / static_cast<double>(alphas.size()), 6);
  }
  [[nodiscard]] std::string alpha_max() const {
    return alphas.empty() ? "-" : fixed(*std::max_element(alphas.begin(), alphas.end()), 6);
  }
  [[nodiscard]] std::string optimal_share() const {
    if (alphas.empty()) return "-";
    return fixed(100.0 * static_cast<double>(optimal) / static_cast<double>(alphas.size()), 0) + '%';
  }
};

// Names configurations by the algorithm alone where the study has only one of it; remembers the order of appearance.
class Labels {
 public:
  explicit Labels(const std::vector<RunRecord>& runs) {
    for (const RunRecord& run : runs) {
      configurations_[run.algorithm].insert(run.params);
      families_[run.generator].insert(run.generator_params);
    }
    for (const RunRecord& run : runs) {
      algorithm_position_.try_emplace(algorithm_of(run), algorithm_position_.size());
      family_position_.try_emplace(family_of(run), family_position_.size());
    }
  }

  [[nodiscard]] std::string algorithm_of(const RunRecord& run) const {
    return configurations_.at(run.algorithm).size() == 1 ? run.algorithm : of(run.algorithm, run.params);
  }
  [[nodiscard]] std::string family_of(const RunRecord& run) const {
    return families_.at(run.generator).size() == 1 ? run.generator : of(run.generator, run.generator_params);
  }
  [[nodiscard]] std::size_t algorithm_position(const RunRecord& run) const {
    return algorithm_position_.at(algorithm_of(run));
  }
  [[nodiscard]] std::size_t family_position(const RunRecord& run) const { return family_position_.at(family_of(run)); }

 private:
  static std::string of(const std::string& name, const std::string& parameters) {
    return parameters.empty() ? name : name + ' ' + parameters;
  }

  std::map<std::string, std::set<std::string>> configurations_;
  std::map<std::string, std::set<std::string>> families_;
  std::map<std::string, std::size_t> algorithm_position_;
  std::map<std::string, std::size_t> family_position_;
};

std::string table_by_algorithm(const std::vector<RunRecord>& runs, const Labels& labels) {
  std::map<std::pair<std::size_t, std::string>, Tally> tallies;
  for (const RunRecord& run : runs) tallies[{labels.algorithm_position(run), labels.algorithm_of(run)}].add(run);
  AlignedTable table(
      {"algorithm", "runs", "failures", "not applicable", "rated", "alpha mean", "alpha max", "optimal"});
  for (const auto& [key, tally] : tallies) {
    table.add_row({key.second, std::to_string(tally.runs), std::to_string(tally.failures),
                   std::to_string(tally.not_applicable), std::to_string(tally.alphas.size()), tally.alpha_mean(),
                   tally.alpha_max(), tally.optimal_share()});
  }
  return table.text();
}

// A line of the table by cell, in the order of first appearance.
struct CellKey {
  std::size_t family_position;
  std::size_t algorithm_position;
  Index n;
  std::string family;
  std::string algorithm;

  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

std::string table_by_cell(const std::vector<RunRecord>& runs, const Labels& labels) {
  std::map<CellKey, Tally> tallies;
  for (const RunRecord& run : runs) {
    tallies[{labels.family_position(run), labels.algorithm_position(run), run.n, labels.family_of(run),
             labels.algorithm_of(run)}]
        .add(run);
  }
  AlignedTable table(
      {"family", "algorithm", "n", "runs", "failures", "median time", "alpha mean", "alpha max", "optimal"}, {1});
  for (const auto& [key, tally] : tallies) {
    if (tally.runs == 0) continue;
    table.add_row({key.family, key.algorithm, std::to_string(key.n), std::to_string(tally.runs),
                   std::to_string(tally.failures), tally.times.empty() ? "-" : readable_duration(median(tally.times)),
                   tally.alpha_mean(), tally.alpha_max(), tally.optimal_share()});
  }
  return table.text();
}

}  // namespace

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::string summary_tables(const std::vector<RunRecord>& runs) {
  const Labels labels(runs);
  return "alpha by algorithm (upper ends of certified intervals; rated: runs with a proved optimum)\n" +
         table_by_algorithm(runs, labels) + "\nby family, algorithm and n\n" + table_by_cell(runs, labels);
}

}  // namespace mwt
