#include "harness/study/command_starts.h"

#include <chrono>
#include <optional>

#include "harness/io/text/text.h"
#include "harness/rating/isolated_run.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/process_pool.h"

namespace mwt {

namespace {

constexpr int kStarts = 3;

RatedRun run_on_three_points(const PlannedRun& planned, const Study& study) {
  static const Instance instance = make_instance({{0, 0}, {1, 0}, {0, 1}}, "three points");
  Request request;
  request.algorithm = planned.algorithm;
  request.parameters = planned.parameters;
  request.threads = study.threads;
  request.time_limit_s = study.limits.time_s;
  RatedRun result;
  ProcessPool pool(1);
  start_isolated_run(pool, request, instance, study.limits, {}, [&](const RatedRun& run) { result = run; });
  while (!pool.is_empty()) pool.wait(std::chrono::milliseconds(200));
  return result;
}

}  // namespace

std::map<std::string, double> measure_command_starts(const Study& study, const Plan& plan,
                                                     const std::set<std::string>& recorded,
                                                     const std::function<void(const std::string& line)>& announce) {
  std::map<std::string, double> times;
  std::map<std::string, const PlannedRun*> commands;
  for (const PlannedRun& run : plan.runs) {
    if (run.algorithm->runs_outside && !recorded.contains(run.run_id)) commands.emplace(run.algorithm->name, &run);
  }
  if (!commands.empty()) remove_abandoned_command_folders();
  for (const auto& [name, planned] : commands) {
    std::optional<RatedRun> fastest;
    for (int start = 0; start < kStarts; ++start) {
      const RatedRun run = run_on_three_points(*planned, study);
      const bool is_better = run.status == RunStatus::ok && (!fastest || run.wall_time_s < fastest->wall_time_s);
      if (is_better) fastest = run;
      if (run.status != RunStatus::ok) {
        announce("warning: " + name + " does not triangulate three points: " + to_text(run.status) +
                 (run.message.empty() ? "" : ": " + run.message));
        break;
      }
    }
    if (!fastest) continue;
    times[name] = fastest->wall_time_s.value();
    announce(name + ": starting it takes " + readable_duration(times[name]) + " (three points), CPU time " +
             readable_duration(fastest->cpu_time_s.value()));
  }
  return times;
}

}  // namespace mwt
