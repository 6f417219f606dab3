#include "harness/study/rows.h"

#include <utility>

#include "harness/rating/quality.h"

namespace mwt {

RunRecord row_of(const RowContext& context, const PlannedInstance& instance, const std::string& instance_id,
                 const PlannedRun& planned, RatedRun run) {
  const Study& study = context.study;
  RunRecord record;
  static_cast<RatedRun&>(record) = std::move(run);
  const auto start = context.command_starts.find(planned.algorithm->name);
  if (start != context.command_starts.end() && record.status == RunStatus::ok)
    record.counters.emplace_back("start_time_s", start->second);
  record.run_id = planned.run_id;
  record.study = study.name;
  record.env_id = context.environment.env_id;
  record.recorded_at = utc_now();
  record.git_commit = context.environment.git_commit;
  record.binary_sha256 = context.environment.binary_sha256;
  record.algorithm = planned.algorithm->name;
  record.params = planned.parameters.canonical();
  record.generator = instance.generator;
  record.generator_params = instance.parameters;
  record.n = instance.n;
  record.seed = instance.seed;
  record.instance_id = instance_id;
  record.repetition = planned.repetition;
  record.threads = study.threads;
  record.time_limit_s = study.limits.time_s;
  record.memory_limit_bytes = study.limits.memory_bytes;
  return record;
}

InstanceRecord row_of(const RowContext& context, const PlannedInstance& planned, const Instance& instance,
                      const FoundOptimum& found) {
  InstanceRecord record;
  record.instance_id = instance.id;
  record.study = context.study.name;
  record.env_id = context.environment.env_id;
  record.recorded_at = utc_now();
  record.generator = planned.generator;
  record.generator_params = planned.parameters;
  record.n = planned.n;
  record.seed = planned.seed;
  record.distinct = static_cast<Index>(instance.set.points.size());
  record.duplicates = instance.set.duplicates();
  record.hull_size = instance.hull_size;
  if (found.interval) {
    record.optimum_lower = found.interval->lower;
    record.optimum_upper = found.interval->upper;
  }
  record.optimality = name_of(optimality_of(found.interval));
  record.optimum_source = found.source;
  record.optimum_time_s = found.time_s;
  record.optimum_note = found.note;
  if (found.proof) {
    record.verified = found.proof->verdict;
    record.proof_note = found.proof->note;
    record.verify_time_s = found.proof->time_s;
    record.proof_bytes = found.proof->bytes;
  }
  return record;
}

}  // namespace mwt
