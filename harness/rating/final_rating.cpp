#include "harness/rating/final_rating.h"

#include "harness/rating/known_optima.h"

namespace mwt {

std::vector<RunRecord> finally_rated(const StudyRecords& records) {
  std::vector<RunRecord> runs = records.runs;
  std::vector<InstanceRecord> instances = records.instances;
  static_cast<void>(reject_disproved(runs, instances));
  rate_all(runs, instances);
  return runs;
}

}  // namespace mwt
