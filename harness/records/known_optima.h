// What a study has certified so far about the optimum of every instance, and its rows rated by that.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/numbers/interval.h"
#include "harness/rating/optimum_claims.h"
#include "harness/records/records.h"

namespace mwt {

/// A run's claim has its run_id as id, an instance's the instance_id.
class KnownOptima {
 public:
  /// Takes in what a row certifies: the optimum of an instance; the weight of a run that is ok, and what its algorithm
  /// certified. Returns the claims that are disproved now, perhaps the row's own; they no longer count.
  [[nodiscard]] std::vector<Disproof> add(const InstanceRecord& record);
  [[nodiscard]] std::vector<Disproof> add(const RunRecord& record);

  /// The best bounds that stand.
  [[nodiscard]] std::optional<Interval> of(const std::string& instance_id) const;

  /// The lightest triangulation known.
  [[nodiscard]] std::optional<KnownWeight> lightest_of(const std::string& instance_id) const;

  /// Fills in optimum, optimality, alpha and optimal of a run that is ok and was added; other rows stay as they are.
  void rate(RunRecord& record) const;

 private:
  std::map<std::string, OptimumClaims> instances_;
};

/// Whether the row is marked: its optimum is disproved.
[[nodiscard]] bool is_disproved(const InstanceRecord& record);

/// Makes the row of an instance one without an optimum.
void reject(InstanceRecord& record, const Disproof& disproof);

/// Rejects the rows whose claims recorded triangulations disprove, and rates the other runs on their instances by what
/// stands. Returns the disproved claims.
std::vector<Disproof> reject_disproved(std::vector<RunRecord>& runs, std::vector<InstanceRecord>& instances);

/// Rates the runs by all that the records certify together; those on instances without any bound stay as they are.
/// Precondition: no claim in the records is disproved.
void rate_all(std::vector<RunRecord>& runs, const std::vector<InstanceRecord>& instances);

/// The runs of a finished or running study rated as if all certified bounds in its records had been known from the
/// beginning: a row was written with what was known by then. What recorded triangulations disprove is no bound, and the
/// run that certified it an error. So the same instances are rated for every algorithm.
[[nodiscard]] std::vector<RunRecord> rated_by_all_bounds(std::vector<RunRecord> runs,
                                                         std::vector<InstanceRecord> instances);

}  // namespace mwt
