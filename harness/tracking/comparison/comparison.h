// Compares two result sets: is the new one slower, heavier, larger, or does it fail where the base did not?
//
// Two results rarely differ in nothing, and a machine is never quiet; so a slowdown is reported only if it is evident
// in three ways: the ratio's bootstrap interval lies beyond the threshold; an exact rank test of "slower by more
// than the threshold" rejects at `error_rate` after the correction of Benjamini and Hochberg for all rows of the table;
// and both rest on what was repeated independently:
//
// - Paired results (two builds run in turn, repetition by repetition; `mwt compare --build-a A --build-b B`): a pair's
//   logarithmic ratio is one observation, so that what slows both alike cancels. A cell has as many observations as
//   repetitions; an algorithm as well: in each repetition the pseudo-median (statistics/shift.h) over its cells, which
//   is far steadier than any cell.
// - Results of two folders were measured at different times, and a machine differs between them more than between the
//   repetitions of one folder. A cell must therefore also stand out from the other cells' ratios (Student's t with 3
//   degrees of freedom, for they have heavy tails, and with their robust standard deviation); an algorithm's
//   observations are its cells, and they must also be slower than the cells of the other algorithms. What slows
//   everything shows in the row of all algorithms, which is judged only where the Delaunay time was measured in each
//   run.
//
// What is no regression is not the same for that: a row is `same` or `not slower` only if "slower by more than the
// threshold" is excluded, by its interval and by an exact rank test at `error_rate`; whatever is open is `unclear`. Two
// folders exclude nothing unless the machine was in the same state: runs had the CPU nearly all the time on both sides,
// and the Delaunay time took as long.
//
// Quality and failures are compared exactly, memory by its extremes; see exact_findings.h.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "harness/tracking/comparison/exact_findings.h"
#include "harness/tracking/comparison/time_table.h"
#include "harness/tracking/result_set.h"

namespace mwt {

/// What a comparison comes to, the first that applies.
enum class Outcome {
  regression,    ///< of anything
  not_compared,  ///< no times were, because the machines differ
  unclear,       ///< some row is, or times are missing
  not_slower,
};
[[nodiscard]] std::string name_of(Outcome outcome);

struct Comparison {
  CompareOptions options;
  std::string time_measure;        ///< what was compared; empty if no times were
  std::vector<std::string> notes;  ///< for the reader: refusals, cells of one side only, load, no Delaunay time
  std::vector<TimeRow> algorithms;
  std::vector<TimeRow> cells;
  std::vector<ExactFinding> findings;
  std::size_t compared_cells = 0;
  std::size_t cells_of_other_machines = 0;  ///< of these, those whose times were not compared because machines differ
  std::vector<std::string> only_in_base;    ///< "greedy on uniform n=100 seed=1"
  std::vector<std::string> only_in_new;
  std::string base_commit;  ///< "unknown" if several builds ran, or the records do not have it
  std::string new_commit;
  std::vector<std::string> untimed;  ///< cells with successful runs, but without times that could be compared

  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] bool has_regression() const;  ///< of anything

  /// Of quality, failures or memory, and not because of a time limit that a busy machine lets a run reach.
  [[nodiscard]] bool has_sure_regression() const;

  /// The cells with one of these verdicts themselves, all of an algorithm whose row has one, all there are if the row
  /// "all" has one.
  [[nodiscard]] std::set<TrackedCell> cells_that_are(const std::set<Verdict>& verdicts) const;

  /// The cells of which it is not excluded that they are worse, and that runs in turn may settle: cells_that_are
  /// regression or unclear, and those that reached a time limit as they did not before.
  [[nodiscard]] std::set<TrackedCell> open_cells() const;
};

/// Times are compared by the given measure, else: of paired results cpu_time_s (wall_time_s where several threads were
/// allowed, or a run has no CPU time), which does not count the time that others took from the process; of folders
/// relative_time if every cell has it, else again cpu_time_s or wall_time_s. Only repetitions that succeeded count.
///
/// Cells whose runs all come from one and the same binary on both sides are reported as such and their times not
/// judged; nor are times of cells that different machines ran (machine_of()). An algorithm or a
/// cell of the base that has no runs any more is a finding: whoever relies on it misses it. Deterministic.
/// Throws InputError if the two have no cell in common, or are of different schema versions.
[[nodiscard]] Comparison compare(const ResultSet& base, const ResultSet& now, const CompareOptions& options);

}  // namespace mwt
