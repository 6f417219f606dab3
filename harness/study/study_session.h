// What the phases of one `mwt run` share.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "harness/io/progress.h"
#include "harness/rating/known_optima.h"
#include "harness/rating/optimum_cache.h"
#include "harness/records/results_folder.h"
#include "harness/run/execution.h"
#include "harness/run/process_pool.h"
#include "harness/study/plan.h"
#include "harness/study/run_study.h"

namespace mwt {

/// The instances of a plan, made when they are needed. The last one stays, for runs come instance by instance.
class InstanceMaker {
 public:
  /// `recorded`: the instances of earlier invocations.
  InstanceMaker(const Plan& plan, const std::vector<InstanceRecord>& recorded);

  /// Throws InputError if the family has no such instance after all, or if it is another one than when the study was
  /// planned or begun; what the family throws.
  [[nodiscard]] std::shared_ptr<const Instance> make(std::size_t position);

 private:
  const Plan& plan_;
  std::map<std::string, std::string> recorded_ids_;  // by label
  std::shared_ptr<const Instance> last_;
  std::size_t last_position_ = 0;
};

struct StudySession {
  StudySession(const Study& the_study, const Catalogue& the_catalogue, const RunOptions& the_options,
               std::ostream& the_out);

  const Study& study;
  const Catalogue& catalogue;
  const RunOptions& options;
  std::ostream& out;
  std::set<std::string> planned_ids;  ///< run ids of the whole study, other shards included
  const Plan plan;                    ///< of this shard
  ResultsFolder folder;
  const EnvironmentRecord environment;
  InstanceMaker instances;
  KnownOptima known;
  std::optional<OptimumCache> cache;
  StudyOutcome outcome;
  Progress* progress = nullptr;         ///< of the phase at work
  std::set<std::string> to_seek_again;  ///< instances whose recorded optimum was disproved

  /// A line for the user, above the progress line if there is one.
  void announce(const std::string& line);

  /// Tells the user of the disproved claims about an instance, throws them out of the optimum cache, and settles the
  /// records.
  void settle(const std::string& instance_id, const std::string& label, const std::vector<Disproof>& disproofs);
};

/// Seeks and records the optimum of every instance that has no row yet or is to be sought again.
void seek_optima(StudySession& session);

/// Executes and records every run that has no row yet.
void execute_runs(StudySession& session);

/// Waits until there is room in the pool, showing progress. False if an interrupt was requested instead.
[[nodiscard]] bool wait_for_room(ProcessPool& pool, Progress& progress);

/// Waits until the pool is empty or an interrupt is requested, then ends the progress line.
void wait_for_all(ProcessPool& pool, Progress& progress);

}  // namespace mwt
