// For tests of the claims: made-up records.
#pragma once

#include <cmath>
#include <string>

#include "harness/claims/claims.h"

namespace mwt::testing {

/// Records that a test adds run by run. Every run gets an instance of its own by default.
class MadeUpRecords {
 public:
  /// A checked run that ended `ok`.
  RunRecord& add(const std::string& algorithm, const std::string& family, Index n) {
    RunRecord run;
    run.run_id = "run" + std::to_string(records_.runs.size());
    run.instance_id = "instance" + std::to_string(records_.runs.size());
    run.algorithm = algorithm;
    run.generator = family;
    run.n = n;
    run.seed = records_.runs.size();
    run.status = RunStatus::ok;
    run.stopped_early = false;
    records_.runs.push_back(run);
    return records_.runs.back();
  }

  /// A run with this alpha against an optimum of weight 1.
  RunRecord& add_rated(const std::string& algorithm, const std::string& family, Index n, double alpha) {
    RunRecord& run = add(algorithm, family, n);
    run.optimality = "proved";
    run.optimum_lower = run.optimum_upper = 1;
    run.weight_lower = run.weight_upper = run.alpha_lower = run.alpha_upper = alpha;
    return run;
  }

  void add_instance(const std::string& id, Index distinct, Index hull_size) {
    InstanceRecord instance;
    instance.instance_id = id;
    instance.distinct = instance.n = distinct;
    instance.hull_size = hull_size;
    records_.instances.push_back(instance);
  }

  [[nodiscard]] const StudyRecords& records() const { return records_; }

 private:
  StudyRecords records_;
};

inline const Claim& claim(const std::string& id) {
  for (const Claim& claim : claims_of_the_source_report()) {
    if (claim.id == id) return claim;
  }
  throw std::out_of_range(id);
}

inline ClaimVerdict verdict(const std::string& id, const MadeUpRecords& made_up) {
  return claim(id).judge(made_up.records()).verdict;
}

/// A little noise, so that fits have intervals.
inline double wobble(int seed) { return 1 + 0.01 * (seed % 3 - 1); }

}  // namespace mwt::testing
