// The results of a study as they come in: every row is written at once, rated by what is certified so far, and
// corrected if a triangulation disproves what it rests on.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "harness/rating/optimum_cache.h"
#include "harness/records/known_optima.h"
#include "harness/records/results_folder.h"

namespace mwt {

struct StudyOutcome {
  std::size_t runs = 0;            ///< recorded by this invocation
  std::size_t failures = 0;        ///< of these
  std::size_t contradictions = 0;  ///< claims about optima that triangulations disproved: a wrong solver
  bool interrupted = false;        ///< by Ctrl-C or SIGTERM
};

class StudyResults {
 public:
  using Announce = std::function<void(const std::string& line)>;

  /// Takes over what is in the folder already. `announce` gets a line for every contradiction.
  StudyResults(ResultsFolder& folder, OptimumCache* cache, Announce announce);
  StudyResults(const StudyResults&) = delete;
  StudyResults& operator=(const StudyResults&) = delete;

  /// Writes the row of an instance whose optimum has been sought, in the place of an earlier one if there is one.
  /// `contradictions` of the search are counted. Returns whether all is well.
  bool add(const InstanceRecord& record, const std::vector<std::string>& contradictions);

  /// Rates a run and writes its row. Returns the row as written.
  RunRecord add(RunRecord run);

  /// Compares an exact run with what the cache has of the same solver and parameters, and puts it there if it is new.
  /// Throws nothing: a run that the cache disproves becomes an error.
  void compare_with_cache(RunRecord& run, const OptimumKey& key);
  void keep_in_cache(const RunRecord& row, const OptimumKey& key);

  /// Whether the instance has a row whose optimum stands or was never found.
  [[nodiscard]] bool has_optimum_row(const std::string& instance_id) const;

  [[nodiscard]] std::optional<KnownWeight> lightest_of(const std::string& instance_id) const {
    return known_.lightest_of(instance_id);
  }

  /// Instances whose optimum was disproved and has not been sought since.
  [[nodiscard]] const std::set<std::string>& to_seek_again() const { return to_seek_again_; }

  [[nodiscard]] const StudyOutcome& outcome() const { return outcome_; }

 private:
  template <class Record>
  void adopt(const std::vector<Record>& records);
  void settle(const std::string& instance_id, const std::string& label, const std::vector<Disproof>& disproofs);

  ResultsFolder& folder_;
  OptimumCache* cache_;
  Announce announce_;
  KnownOptima known_;
  std::set<std::string> recorded_;  // ids of instances that have a row
  std::set<std::string> to_seek_again_;
  StudyOutcome outcome_;
};

}  // namespace mwt
