#include "harness/study/estimate/estimate.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"

namespace mwt {

namespace {

// Starting a process, bringing a row to the disk; checking and weighing a result.
constexpr double kOverheadPerRun = 0.006;
constexpr double kOverheadPerRunAndPoint = 2e-6;
// Making an instance: when the study is planned, before its optimum is sought, and before its runs.
constexpr double kOverheadPerInstancePoint = 4e-6;
// What a short run takes that is repeated until it can be timed (run/repeated_timing.h), in units of the time it fills.
constexpr double kFillingFactor = 4;

class WorkList {
 public:
  void add(const PlannedWork& work) {
    const auto [entry, is_new] = positions_.try_emplace({work.cell, work.is_search}, list_.size());
    if (is_new) list_.push_back(work);
    ++list_[entry->second].count;
  }

  [[nodiscard]] std::vector<PlannedWork> take() { return std::move(list_); }

 private:
  std::map<std::pair<TimedCell, bool>, std::size_t> positions_;
  std::vector<PlannedWork> list_;
};

double overhead_of(const PlannedWork& work) { return kOverheadPerRun + kOverheadPerRunAndPoint * work.cell.n; }

double filled(const PlannedWork& work, const Study& study, double seconds) {
  return work.is_search ? seconds : std::max(seconds, kFillingFactor * study.min_time_s);
}

PlannedWork work_of(const PlannedRun& run, const Study& study, const Plan& plan) {
  const PlannedInstance& instance = plan.instances[run.instance];
  PlannedWork work;
  work.cell = {name_with_parameters(run.algorithm->name, run.parameters.canonical()),
               name_with_parameters(instance.generator, instance.parameters), instance.n};
  work.algorithm = run.algorithm;
  work.parameters = run.parameters;
  work.has_start_file = run.start_file.has_value();
  work.instance = run.instance;
  work.limit_s = study.limits.time_s + study.limits.grace_s;
  return work;
}

// The search for the optimum of the instance at this position, if there is one.
std::optional<PlannedWork> search_for(std::size_t position, const Study& study, const Catalogue& catalogue,
                                      const Plan& plan) {
  if (!study.seeks_optimum) return std::nullopt;
  const PlannedInstance& instance = plan.instances[position];
  const auto sources = optimum_sources_for(catalogue, study.optimum_sources, instance.n);
  const auto source = std::find_if(sources.begin(), sources.end(),
                                   [](const AlgorithmInfo* info) { return !info->convex_position_only; });
  if (source == sources.end()) return std::nullopt;
  PlannedWork work;
  work.algorithm = *source;
  work.parameters = Parameters(work.algorithm->name, work.algorithm->parameters, {});
  work.cell = {name_with_parameters(work.algorithm->name, work.parameters.canonical()),
               name_with_parameters(instance.generator, instance.parameters), instance.n};
  work.instance = position;
  work.limit_s = study.optimum_limits.time_s + study.optimum_limits.grace_s;
  work.is_search = true;
  return work;
}

}  // namespace

std::vector<PlannedWork> planned_work(const Study& study, const Catalogue& catalogue, const Plan& plan) {
  WorkList list;
  for (const PlannedRun& run : plan.runs) {
    if (is_within_reach(run, plan)) list.add(work_of(run, study, plan));
  }
  for (std::size_t i = 0; i < plan.instances.size(); ++i) {
    if (const auto search = search_for(i, study, catalogue, plan)) list.add(*search);
  }
  return list.take();
}

std::vector<InstanceTime> estimate_instances(const Study& study, const Catalogue& catalogue, const Plan& plan,
                                             const TimeModel& model) {
  const auto likely = [&](const PlannedWork& work) {
    return overhead_of(work) + filled(work, study, model.predict(work.cell, work.limit_s).seconds);
  };
  std::vector<InstanceTime> times;
  for (std::size_t i = 0; i < plan.instances.size(); ++i) {
    const auto search = search_for(i, study, catalogue, plan);
    times.push_back({search ? likely(*search) : 0, kOverheadPerInstancePoint * plan.instances[i].n});
  }
  for (const PlannedRun& run : plan.runs) {
    if (is_within_reach(run, plan)) times[run.instance].runs_s += likely(work_of(run, study, plan));
  }
  return times;
}

DurationEstimate estimate_duration(const Study& study, const Plan& plan, const std::vector<PlannedWork>& work,
                                   const TimeModel& model) {
  DurationEstimate estimate;
  double fixed = 0;
  for (const PlannedInstance& instance : plan.instances) fixed += kOverheadPerInstancePoint * instance.n;
  for (const PlannedWork& item : work) {
    const TimePrediction prediction = model.predict(item.cell, item.limit_s);
    const auto count = static_cast<double>(item.count);
    const double seconds = count * (overhead_of(item) + filled(item, study, prediction.seconds));
    estimate.likely += seconds;
    estimate.low += count * (overhead_of(item) + filled(item, study, prediction.low));
    estimate.high += count * (overhead_of(item) + filled(item, study, prediction.high));
    estimate.most += count * (overhead_of(item) + item.limit_s);
    DurationEstimate::Part& part = item.is_search ? estimate.searches : estimate.runs[prediction.basis];
    part.count += item.count;
    part.seconds += seconds;
  }
  for (double* total : {&estimate.likely, &estimate.low, &estimate.high, &estimate.most}) *total += fixed;
  return estimate;
}

}  // namespace mwt
