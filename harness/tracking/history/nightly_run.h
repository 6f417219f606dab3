// One nightly run: what one build measured on one machine in one study, a number per cell and measure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/tracking/cell.h"
#include "harness/tracking/result_set.h"

namespace mwt {

struct NightlyValue {
  TrackedCell cell;
  std::string measure;   ///< the name of one of measures()
  double value = 0;      ///< median over the repetitions; for failures their share
  std::size_t runs = 0;  ///< repetitions behind it
};

/// Where the instructions of a counted cell are: of the functions with at least a hundredth of them.
struct NightlyFunction {
  TrackedCell cell;  ///< its seed is 0: all seeds together, the first counted run of each
  std::string name;
  std::uint64_t instructions = 0;
};

struct NightlyRun {
  std::string git_commit;
  std::string environment;  ///< fingerprint: hash of `machine` and of the number of jobs side by side
  std::string machine;
  std::string study;
  std::string configuration;  ///< fingerprint of the study's file, and of the program if `git_commit` leaves it open
  std::string recorded_at;    ///< when its last run had ended
  std::vector<NightlyValue> values;
  std::vector<NightlyFunction> functions{};
};

/// The nightly runs of a folder, usually one: its runs by commit, environment, study and configuration, ordered by
/// time. Runs without an environment count as those of an unknown machine.
///
/// A commit does not identify the program where the sources differed from it ("-dirty") or where there was no git
/// ("unknown"). The configuration is empty for a folder without a study file whose commits identify the program.
[[nodiscard]] std::vector<NightlyRun> nightly_runs_of(const ResultSet& results);

}  // namespace mwt
