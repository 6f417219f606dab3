#include "harness/tracking/comparison/settle.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "harness/io/text/text.h"

namespace mwt {

namespace {

ResultSet of_cells(ResultSet results, const std::set<TrackedCell>& cells) {
  std::erase_if(results.runs, [&](const RunRecord& run) { return !cells.contains(cell_of(run)); });
  return results;
}

bool is_settled(const TimeRow& row) { return row.verdict != Verdict::unclear; }

TimeRow* row_like(std::vector<TimeRow>& rows, const TimeRow& other) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const TimeRow& row) {
    return row.algorithm == other.algorithm && row.instance == other.instance;
  });
  return found == rows.end() ? nullptr : &*found;
}

void take_over_rows(std::vector<TimeRow>& all, std::vector<TimeRow> latest) {
  for (TimeRow& row : latest) {
    TimeRow* const known = row_like(all, row);
    if (known == nullptr) {
      all.push_back(std::move(row));
    } else if (!is_settled(*known)) {
      *known = std::move(row);
    }
  }
}

/// The cells that more repetitions may settle. An algorithm that is proved slower needs none.
std::set<TrackedCell> unclear_cells(const Comparison& comparison) {
  std::set<TrackedCell> cells = comparison.cells_that_are({Verdict::unclear});
  for (const TimeRow& row : comparison.algorithms) {
    if (row.verdict == Verdict::regression)
      std::erase_if(cells, [&](const TrackedCell& cell) { return algorithm_label(cell) == row.algorithm; });
  }
  return cells;
}

}  // namespace

void take_over(Comparison& all, Comparison latest, const std::set<TrackedCell>& cells) {
  take_over_rows(all.algorithms, std::move(latest.algorithms));
  take_over_rows(all.cells, std::move(latest.cells));
  std::erase_if(all.findings, [&](const ExactFinding& finding) { return cells.contains(finding.cell); });
  all.findings.insert(all.findings.end(), latest.findings.begin(), latest.findings.end());
  all.notes.insert(all.notes.end(), latest.notes.begin(), latest.notes.end());
  all.options = latest.options;
  all.time_measure = latest.time_measure;
  all.base_commit = latest.base_commit;
  all.new_commit = latest.new_commit;
  all.untimed = std::move(latest.untimed);
  all.compared_cells = std::max(all.compared_cells, latest.compared_cells);
}

std::optional<Comparison> settle(std::set<TrackedCell> cells, InterleavedBuilds& builds, int repetitions,
                                 CompareOptions options) {
  options.paired = true;
  options.error_rate /= kMaxLooks;
  Comparison all;
  for (int look = 1; look <= kMaxLooks && !cells.empty(); ++look) {
    if (!builds.run(cells, repetitions)) return std::nullopt;
    Comparison latest = compare(of_cells(read_results(builds.base_folder()), cells),
                                of_cells(read_results(builds.new_folder()), cells), options);
    latest.notes.insert(latest.notes.begin(), fmt::format("look {}: {}, both builds {} times in turn", look,
                                                          counted(cells.size(), "cell"), builds.repetitions()));
    take_over(all, std::move(latest), cells);
    cells = unclear_cells(all);
    if (!builds.is_out_of_time()) continue;
    if (!cells.empty()) all.notes.emplace_back("the time for runs in turn was up: unclear cells stay unclear");
    break;
  }
  return all;
}

Outcome Settled::outcome() const {
  if (!in_turn) return folders.outcome();
  const std::set<TrackedCell> slower = folders.cells_that_are({Verdict::regression});
  const bool stands =
      std::any_of(not_run.begin(), not_run.end(), [&](const TrackedCell& cell) { return slower.contains(cell); });
  if (stands || folders.has_sure_regression() || in_turn->has_regression()) return Outcome::regression;
  if (folders.outcome() == Outcome::not_compared) return Outcome::not_compared;
  const bool is_open = !not_run.empty() || !folders.untimed.empty() || in_turn->outcome() == Outcome::unclear;
  return is_open ? Outcome::unclear : Outcome::not_slower;
}

}  // namespace mwt
