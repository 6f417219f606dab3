#include "harness/report/final_rating.h"

#include "harness/study/known_optima.h"

namespace mwt {

std::vector<RunRecord> finally_rated(const StudyRecords& records) {
  KnownOptima known;
  // Bounds that exclude earlier ones have been announced and recorded as CONTRADICTION; the earlier ones stand here.
  for (const InstanceRecord& instance : records.instances) {
    if (const auto bounds = optimum_of(instance)) static_cast<void>(known.add(instance.instance_id, *bounds));
  }
  for (const RunRecord& run : records.runs) {
    if (const auto bounds = optimum_of(run)) static_cast<void>(known.add(run.instance_id, *bounds));
  }
  std::vector<RunRecord> runs = records.runs;
  for (RunRecord& run : runs) {
    RunRecord rated = run;
    if (known.rate(rated)) run = std::move(rated);
  }
  return runs;
}

}  // namespace mwt
