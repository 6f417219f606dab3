// A folder of results as tracking reads it: of any schema version, old ones included.
#pragma once

#include <string>
#include <vector>

#include "harness/records.h"

namespace mwt {

struct ResultSet {
  std::string folder;
  std::vector<RunRecord> runs;
  std::vector<EnvironmentRecord> environments;

  /// The environment of a run; an empty one if environments.csv has none.
  [[nodiscard]] EnvironmentRecord environment_of(const RunRecord& run) const;
};

/// Reads runs.csv and environments.csv (which may be missing) by the names of their columns: columns that this version
/// does not know are left out, those that the file lacks stay empty. A torn last row is left out.
/// Throws InputError "FILE[:LINE]: what": no runs.csv, no column that says which run a row is, a malformed field.
[[nodiscard]] ResultSet read_results(const std::string& folder);

/// What makes two machines the same for comparing times: processor, logical CPUs, memory to the gigabyte. Empty if the
/// environment tells none of them.
[[nodiscard]] std::string machine_of(const EnvironmentRecord& environment);

}  // namespace mwt
