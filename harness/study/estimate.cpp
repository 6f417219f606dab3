#include "harness/study/estimate.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "harness/statistics/quantile.h"
#include "harness/study/optimum_search.h"

namespace mwt {

namespace {

// Starting a process, bringing a row to the disk.
constexpr double kOverheadPerRun = 0.004;
// Google Benchmark doubles its way up until the executions fill the minimum.
constexpr double kFillingFactor = 2;

using CellName = std::tuple<std::string, std::string, std::string, std::string, Index>;

CellName cell_of(const PlannedRun& run, const Plan& plan) {
  const PlannedInstance& instance = plan.instances[run.instance];
  return {instance.generator, instance.parameters, run.algorithm->name, run.parameters.canonical(), instance.n};
}

// Median wall-clock seconds of every recorded cell; a run that failed took its limit.
std::map<CellName, double> recorded_times(const StudyRecords& records) {
  std::map<CellName, std::vector<double>> times;
  for (const RunRecord& run : records.runs) {
    const double if_none = run.status == RunStatus::not_applicable ? 0 : run.time_limit_s;
    times[{run.generator, run.generator_params, run.algorithm, run.params, run.n}].push_back(
        run.wall_time_s.value_or(if_none));
  }
  std::map<CellName, double> medians;
  for (const auto& [cell, values] : times) medians[cell] = median(values);
  return medians;
}

double time_of_search(const Study& study, const Catalogue& catalogue, const PlannedInstance& instance) {
  if (!study.seeks_optimum) return 0;
  const auto sources = optimum_sources_for(catalogue, study.optimum_sources, instance.n);
  return static_cast<double>(sources.size()) * (study.optimum_limits.time_s + study.optimum_limits.grace_s);
}

}  // namespace

DurationEstimate estimate_duration(const Study& study, const Catalogue& catalogue, const Plan& plan,
                                   const StudyRecords& records) {
  DurationEstimate estimate;
  const std::map<CellName, double> recorded = recorded_times(records);
  for (const PlannedRun& run : plan.runs) {
    if (!is_within_reach(run, plan)) {
      ++estimate.known;
      continue;
    }
    estimate.least += kOverheadPerRun;
    estimate.most += study.limits.time_s + study.limits.grace_s;
    const auto cell = recorded.find(cell_of(run, plan));
    if (cell == recorded.end()) continue;
    ++estimate.known;
    estimate.likely += kOverheadPerRun + std::max(cell->second, kFillingFactor * study.min_time_s);
  }
  for (const PlannedInstance& instance : plan.instances) estimate.most += time_of_search(study, catalogue, instance);
  for (const InstanceRecord& instance : records.instances) estimate.likely += instance.optimum_time_s.value_or(0);
  return estimate;
}

}  // namespace mwt
