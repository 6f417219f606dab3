// Joins the shards of one study, run apart, to what a single run would have recorded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/catalogue.h"

namespace mwt {

struct MergeOptions {
  std::vector<std::string> folders;            ///< of the shards; at least one
  std::string target;                          ///< must not hold anything yet
  std::optional<std::string> instance_folder;  ///< of the study's point files, if it has any
  bool accepts_other_build = false;            ///< whether shards of several commits may be joined
};

/// Writes `target`: rows of runs and instances in the order of the study's plan, as a single run would have written
/// them; of equal instances the first. Returns the number of runs.
///
/// Throws InputError, and writes nothing: a folder without records, of another schema version, or in use; folders of
/// different studies or commits; a run in two folders, or not of the study (overlap); a planned run in none (gap).
/// Throws std::logic_error if certified optima of one instance exclude each other: a solver is wrong.
std::size_t merge_results(const MergeOptions& options, const Catalogue& catalogue);

}  // namespace mwt
