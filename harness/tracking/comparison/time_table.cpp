#include "harness/tracking/comparison/time_table.h"

#include <algorithm>
#include <cmath>

#include "harness/statistics/false_discovery.h"
#include "harness/statistics/quantile.h"
#include "harness/statistics/shift.h"
#include "harness/tracking/comparison/time_comparison.h"

namespace mwt {

namespace {

struct JudgedRow {
  TimeRow row;
  TimeJudgement judgement;
};

std::vector<double> values_of(const Repetitions& repetitions) {
  std::vector<double> values;
  for (const auto& [repetition, value] : repetitions) values.push_back(value);
  return values;
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
class TableMaker {
 public:
  TableMaker(const std::vector<TimedCell>& cells, const CompareOptions& options, const Measuring& measuring)
      : cells_(cells), options_(options), measuring_(measuring) {
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
    if (members.size() > 1) rows.push_back(algorithm_row(kAllAlgorithms, all));
    return decided(rows);
  }

 private:
  [[nodiscard]] JudgedRow cell_row(const TimedCell& cell) const {
    JudgedRow judged;
    judged.row.name = cell.cell.algorithm;
    judged.row.algorithm = algorithm_label(cell.cell);
    judged.row.instance = instance_label(cell.cell);
    judged.row.cell = cell.cell;
    judged.row.base = std::exp(median(values_of(cell.base)));
    judged.row.now = std::exp(median(values_of(cell.now)));
    if (options_.paired) {
      const std::vector<double> ratios = values_of(paired_log_ratios(cell));
      judged.row.observations = ratios.size();
      judged.judgement = judge_log_ratios(ratios, options_.threshold);
    } else {
      judged.row.observations = std::min(cell.base.size(), cell.now.size());
      judged.judgement = judge_log_times(values_of(cell.base), values_of(cell.now), options_.threshold);
      if (cells_.size() >= kMinCellsForSpread) require_standing_out(judged.judgement, log_ratios_, options_.threshold);
    }
    return judged;
  }

  [[nodiscard]] JudgedRow algorithm_row(const std::string& algorithm, const std::vector<std::size_t>& members) const {
    const std::vector<double> observations = observations_of(members);
    JudgedRow judged;
    judged.row.name = algorithm == kAllAlgorithms ? kAllAlgorithms : cells_[members.front()].cell.algorithm;
    judged.row.algorithm = algorithm;
    judged.row.observations = observations.size();
    judged.judgement = judge_log_ratios(observations, options_.threshold);
    if (options_.paired) return judged;
    std::vector<double> others;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (std::find(members.begin(), members.end(), i) == members.end()) others.push_back(log_ratios_[i]);
    }
    require_difference_from_others(judged.judgement, observations, others, options_.threshold);
    // Without the Delaunay time, slower algorithms cannot be distinguished from a slower machine.
    if (others.empty() && !measuring_.has_delaunay_time) judged.judgement.p_slower = judged.judgement.p_faster = 1;
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
      row.verdict = verdict_of(row, judged[i].judgement);
    }
    return rows;
  }

  /// Sure of a difference: after the correction for many tests, so that few alarms are false. Sure that there is none:
  /// without it, each row by itself, for there the error would be to miss one.
  [[nodiscard]] Verdict verdict_of(const TimeRow& row, const TimeJudgement& judgement) const {
    const double most = 1 + options_.threshold, least = 1 / most;
    if (row.q_slower <= options_.error_rate && row.ratio.lower > most) return Verdict::regression;
    if (row.q_faster <= options_.error_rate && row.ratio.upper < least) return Verdict::improvement;
    const bool excludes_slower = judgement.p_not_slower <= options_.error_rate && row.ratio.upper <= most;
    const bool excludes_faster = judgement.p_not_faster <= options_.error_rate && row.ratio.lower >= least;
    if (!measuring_.can_exclude || !excludes_slower) return Verdict::unclear;
    return excludes_faster ? Verdict::same : Verdict::not_slower;
  }

  const std::vector<TimedCell>& cells_;
  const CompareOptions& options_;
  Measuring measuring_;
  std::vector<double> log_ratios_;  // of each cell
};

}  // namespace

Repetitions paired_log_ratios(const TimedCell& cell) {
  Repetitions ratios;
  for (const auto& [repetition, time] : cell.now) {
    const auto before = cell.base.find(repetition);
    if (before != cell.base.end()) ratios[repetition] = time - before->second;
  }
  return ratios;
}

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::same: return "same";
    case Verdict::not_slower: return "not slower";
    case Verdict::unclear: return "unclear";
    case Verdict::regression: return "regression";
    case Verdict::improvement: return "improvement";
    case Verdict::identical_binary: return "identical binary";
  }
  return "";
}

TimeTable make_time_table(const std::vector<TimedCell>& cells, const CompareOptions& options,
                          const Measuring& measuring) {
  const TableMaker maker(cells, options, measuring);
  return {maker.algorithm_rows(), maker.cell_rows()};
}

}  // namespace mwt
