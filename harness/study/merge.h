// Joins the shards of one study, run apart, to what a single run would have recorded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/records/results_folder.h"
#include "harness/run/catalogue.h"

namespace mwt {

struct MergeOptions {
  std::vector<std::string> folders;            ///< of the shards; at least one
  std::string target;                          ///< must not hold anything yet
  std::optional<std::string> instance_folder;  ///< of the study's point files, if it has any
  std::optional<std::string> study_path{};     ///< the study file; without, its copy in the first folder, which has
                                               ///< no commands and start files beside it
  bool accepts_other_build = false;            ///< whether shards of several commits may be joined
  FolderUse folder_use = FolderUse::locked;    ///< of the shards' folders and the target
};

struct MergeOutcome {
  std::size_t runs = 0;
  std::vector<std::string> contradictions;  ///< claims about optima that a triangulation of another shard disproves
  std::vector<std::string> warnings;
};

/// Writes `target`: rows of runs and instances in the order of the study's plan, as a single run would have written
/// them; of equal instances the first. Disproved claims become errors (records/known_optima.h).
///
/// Throws InputError, and writes nothing: a folder without records, of another schema version, or in use; folders of
/// different studies or commits, or with different points under one name; a run in two folders, or not of the study
/// (overlap); a planned run in none (gap).
MergeOutcome merge_results(const MergeOptions& options, const Catalogue& catalogue);

}  // namespace mwt
