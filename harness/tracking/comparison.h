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
// - Results of two folders were measured at different times, and the machine drifts between them more than
//   between the repetitions of one folder. A cell must therefore also stand out from the other cells' ratios (Student's
//   t with 3 degrees of freedom, for they have heavy tails, and with their robust standard deviation); an algorithm's
//   observations are its cells, and they must also be slower than the cells of the other algorithms. What slows
//   everything shows in the row of all algorithms, which is judged only where the yardstick was measured in each run.
//
// Quality and failures are compared exactly, memory by its extremes; see exact_findings.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/tracking/exact_findings.h"
#include "harness/tracking/result_set.h"
#include "harness/tracking/time_table.h"

namespace mwt {

struct Comparison {
  CompareOptions options;
  std::string time_measure;        ///< what was compared; empty if no times were
  std::vector<std::string> notes;  ///< what the reader must know: refusals, cells of one side only, no yardstick
  std::vector<TimeRow> algorithms;
  std::vector<TimeRow> cells;
  std::vector<ExactFinding> findings;
  std::size_t compared_cells = 0;

  [[nodiscard]] bool has_regression() const;        ///< of anything
  [[nodiscard]] bool has_exact_regression() const;  ///< of quality, failures or memory

  /// The names, without parameters, of the algorithms with a regression of time; all of them if the row "all" has one.
  [[nodiscard]] std::vector<std::string> slower_algorithms() const;
};

/// Times are compared by the given measure, else: of paired results cpu_time_s (wall_time_s where several threads were
/// allowed, or a run was measured for less than 10 ms), which does not count the time that others took from the
/// process; of folders relative_time if every cell has it, else again cpu_time_s or wall_time_s. Only repetitions that
/// succeeded count.
///
/// Cells whose runs all come from one and the same binary on both sides are reported as such and their times not
/// judged. If the machines differ (machine_of()), no times are compared. Deterministic.
/// Throws InputError if the two have no cell in common.
[[nodiscard]] Comparison compare(const ResultSet& base, const ResultSet& now, const CompareOptions& options);

}  // namespace mwt
