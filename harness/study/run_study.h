// Runs a study from plan to records.
#pragma once

#include <optional>
#include <ostream>
#include <set>
#include <string>

#include "harness/records/results_folder.h"
#include "harness/run/catalogue.h"
#include "harness/study/plan.h"
#include "harness/study/study.h"
#include "harness/study/study_results.h"

namespace mwt {

struct RunOptions {
  std::string folder;  ///< where the records go
  bool resume = false;
  int jobs = 1;  ///< runs side by side; more than one disturbs times
  bool is_terminal = false;
  std::optional<std::string>
      cache_folder{};  ///< where proved optima are kept (harness/rating/optimum_cache.h); none: nowhere
  Shard shard{};
  std::optional<std::set<std::string>> instances{};  ///< labels of those that the shard consists of; without, they are
                                                     ///< dealt out in turn (part_of())
  bool only_optima = false;                          ///< whether runs are left to another call
  FolderUse folder_use = FolderUse::locked;
  bool accepts_other_build = false;  ///< whether records of another build of this program may be continued
};

/// Instance by instance: first its optimum, from the cache if it has it, then every run that is not recorded yet, each
/// in a process of its own; every result is on the disk before the next one begins. Progress and notes go to `out`.
///
/// Every row's optimum is all that is certified about its instance by then: what the optimum sources found, what exact
/// runs found since, and, as an upper end, the run's own weight. A checked triangulation that is lighter than a
/// certified lower bound disproves the claim: the claimant's row becomes an error (an instance loses its optimum), it
/// is announced and removed from the cache, and the other runs on the instance are rated anew. If that leaves an
/// instance without an optimum, it is sought again in the end.
///
/// Throws InputError for everything that is wrong with the study or the folder, before anything is run: also if runs
/// are missing in a folder whose runs were recorded by another build, for times and results of two are not one study.
[[nodiscard]] StudyOutcome run_study(const Study& study, const Catalogue& catalogue, const RunOptions& options,
                                     std::ostream& out);

}  // namespace mwt
