// A folder of results as tracking reads it: of any schema version, old ones included.
#pragma once

#include <string>
#include <vector>

#include "harness/records/environment.h"
#include "harness/records/records.h"

namespace mwt {

struct ResultSet {
  std::string folder;
  std::vector<RunRecord> runs;
  std::vector<EnvironmentRecord> environments;
  int schema_version = kSchemaVersion;
  bool has_ticking_clock = false;
  std::string study_file{};  ///< content of study.toml; empty if there is none

  /// The environment of a run; an empty one if environments.csv has none.
  [[nodiscard]] EnvironmentRecord environment_of(const RunRecord& run) const;
};

/// Reads runs.csv and environments.csv (which may be missing). Files of the present schema version must have its
/// columns in their places; those of older versions are read by the names of their columns: columns that this version
/// does not have are left out, those that the file lacks stay empty. A torn last row is left out.
///
/// Where the CPU times come from a clock with coarse ticks, as in builds of mwt that put a CPU limit on each run, they
/// are without_short_cpu_times().
///
/// Throws InputError "FILE[:LINE]: what; remedy": no runs.csv, other columns, a newer schema version or several of
/// them, a malformed field.
[[nodiscard]] ResultSet read_results(const std::string& folder);

/// Leaves out CPU times of less than a hundred ticks of a clock.
[[nodiscard]] ResultSet without_short_cpu_times(ResultSet results);

}  // namespace mwt
