#include "harness/study/execute_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "harness/io/given_triangulation.h"
#include "harness/rating/counted_run.h"
#include "harness/rating/isolated_run.h"
#include "harness/records/profile_folder.h"
#include "harness/records/proof_folder.h"
#include "harness/run/interrupt.h"
#include "harness/run/process_pool.h"

namespace mwt {

namespace {

constexpr std::chrono::milliseconds kPatience{200};

// Whether an interrupt is requested now or within a moment. Batch systems send a signal to all processes of a job, in
// any order: what has just failed may have failed for that, and is then left to --resume.
bool is_interrupted_about_now() {
  constexpr int kLooks = 10;
  constexpr std::chrono::milliseconds kPause{10};
  for (int look = 0; look < kLooks && !InterruptWatch::requested(); ++look) std::this_thread::sleep_for(kPause);
  return InterruptWatch::requested();
}

// The ids of recorded points by label: a label stands for the same points whenever a run of it is recorded. Of points
// with several labels only one has a row in instances.csv.
std::map<std::string, std::string> recorded_ids(const ResultsFolder& folder) {
  std::map<std::string, std::string> ids;
  for (const RunRecord& record : folder.runs()) {
    if (!record.instance_id.empty()) ids[label_of_instance(record)] = record.instance_id;
  }
  for (const InstanceRecord& record : folder.instances()) ids[label_of_instance(record)] = record.instance_id;
  return ids;
}

using SharedInstance = std::shared_ptr<const Instance>;

class PlanExecution {
 public:
  PlanExecution(const Plan& plan, const Catalogue& catalogue, const RowContext& context, const ResultsFolder& folder,
                int jobs, OptimumCache* cache, Progress& progress, StudyResults& results)
      : plan_(plan),
        catalogue_(catalogue),
        context_(context),
        folder_(folder),
        cache_(cache),
        progress_(progress),
        results_(results),
        recorded_ids_(recorded_ids(folder)),
        runs_of_(plan.instances.size()),
        pool_(jobs) {
    const std::set<std::string> recorded = folder.run_ids();
    for (const PlannedRun& run : plan.runs) {
      if (!recorded.contains(run.run_id)) runs_of_[run.instance].push_back(&run);
    }
  }

  void run() {
    execute(positions_where(
        [this](std::size_t position) { return !has_optimum_row(position) || !runs_of_[position].empty(); }));
    if (InterruptWatch::requested()) return;
    execute(positions_where([this](std::size_t position) {
      const std::string* const id = recorded_id(position);
      return id != nullptr && results_.to_seek_again().contains(*id);
    }));
  }

 private:
  struct ReadyRun {
    const PlannedRun* run;
    SharedInstance instance;
  };

  template <class Condition>
  [[nodiscard]] std::vector<std::size_t> positions_where(const Condition& condition) const {
    std::vector<std::size_t> positions;
    for (std::size_t position = 0; position < plan_.instances.size(); ++position) {
      if (condition(position)) positions.push_back(position);
    }
    return positions;
  }

  // Everything that is missing of the instances at these positions.
  void execute(const std::vector<std::size_t>& positions) {
    for (const std::size_t position : positions) {
      progress_.expect(runs_of_[position].size() + (has_optimum_row(position) ? 0 : 1));
    }
    for (std::size_t next = 0; wait_for_room();) {
      if (!ready_.empty()) {
        const ReadyRun ready = std::move(ready_.front());
        ready_.pop_front();
        start(ready);
      } else if (next < positions.size()) {
        begin(positions[next++]);
      } else if (pool_.is_empty()) {
        break;
      } else {
        wait();
      }
    }
    while (!pool_.is_empty() && !InterruptWatch::requested()) wait();
  }

  // Null as long as no row names the points.
  [[nodiscard]] const std::string* recorded_id(std::size_t position) const {
    const auto entry = recorded_ids_.find(plan_.instances[position].label());
    return entry == recorded_ids_.end() ? nullptr : &entry->second;
  }

  [[nodiscard]] bool has_optimum_row(std::size_t position) const {
    const std::string* const id = recorded_id(position);
    return id != nullptr && results_.has_optimum_row(*id);
  }

  void wait() {
    pool_.wait(kPatience);
    progress_.refresh();
  }

  // False if an interrupt was requested instead.
  bool wait_for_room() {
    while (pool_.is_full() && !InterruptWatch::requested()) wait();
    return !InterruptWatch::requested();
  }

  // Throws InputError if the family has no such instance after all, or if it is another one than when the study was
  // planned or begun; what the family throws.
  [[nodiscard]] SharedInstance make(std::size_t position) {
    const PlannedInstance& planned = plan_.instances[position];
    auto made = std::make_shared<const Instance>(make_instance(planned.make_points(), planned.label()));
    const bool is_as_planned = planned.file_instance_id.empty() || made->id == planned.file_instance_id;
    if (!is_as_planned) throw InputError(planned.label() + ": the file has changed while the study ran");
    const auto [recorded, is_new] = recorded_ids_.emplace(planned.label(), made->id);
    if (!is_new && recorded->second != made->id) {
      throw InputError(planned.label() + ": these are other points than those that were recorded under this name");
    }
    return made;
  }

  // Makes the instance, and begins everything that is missing of it.
  void begin(std::size_t position) {
    const std::string label = plan_.instances[position].label();
    const bool is_expected_to_seek = !has_optimum_row(position);
    SharedInstance instance;
    try {
      instance = make(position);
    } catch (const std::exception& error) {
      give_up(position, error.what());
      return;
    }
    if (results_.has_optimum_row(instance->id)) {
      if (is_expected_to_seek) progress_.advance(false, label);  // sought for the same points under another label
      make_ready(position, instance);
    } else if (const auto sought = waiting_.find(instance->id); sought != waiting_.end()) {
      sought->second.push_back({position, instance});
      progress_.advance(false, label);
    } else {
      waiting_[instance->id] = {{position, instance}};
      seek(position, instance);
    }
  }

  void give_up(std::size_t position, const std::string& why) {
    const PlannedInstance& planned = plan_.instances[position];
    progress_.announce(planned.label() + ": no instance: " + why);
    progress_.advance(true, planned.label());
    for (const PlannedRun* run : std::exchange(runs_of_[position], {})) {
      record_without_running(*run, "", RunStatus::error, "no instance: " + why);
    }
  }

  void make_ready(std::size_t position, const SharedInstance& instance) {
    for (const PlannedRun* run : std::exchange(runs_of_[position], {})) ready_.push_back({run, instance});
  }

  void seek(std::size_t position, const SharedInstance& instance) {
    const OptimumRequest request{instance,
                                 sources_for(*instance),
                                 context_.study.optimum_limits,
                                 cache_,
                                 results_.lightest_of(instance->id),
                                 proof_file_for(*instance)};
    seek_optimum(
        pool_, request, [this, position, instance, may_find = !request.sources.empty()](const FoundOptimum& found) {
          const bool is_found = found.note.empty() && (!found.proof || found.proof->verdict != ProofVerdict::failed);
          if (may_find && !is_found && !found.is_cached && is_interrupted_about_now()) return;
          record(plan_.instances[position], *instance, found);
          for (const auto& [same_points, made] : std::exchange(waiting_[instance->id], {}))
            make_ready(same_points, made);
          waiting_.erase(instance->id);
        });
  }

  // Empty if the study asks for none.
  [[nodiscard]] std::string proof_file_for(const Instance& instance) const {
    const bool is_asked_for = instance.set.points.size() <= context_.study.max_proof_n;
    return is_asked_for ? proof_file(folder_.path(), instance.id) : "";
  }

  [[nodiscard]] std::vector<const AlgorithmInfo*> sources_for(const Instance& instance) const {
    if (!context_.study.seeks_optimum) return {};
    const auto n = static_cast<Index>(instance.set.points.size());
    return optimum_sources_for(catalogue_, context_.study.optimum_sources, n, instance.hull_size == n);
  }

  void record(const PlannedInstance& planned, const Instance& instance, const FoundOptimum& found) {
    for (const std::string& warning : found.warnings) {
      progress_.announce("warning: " + planned.label() + ": " + warning);
    }
    const bool is_well = results_.add(row_of(context_, planned, instance, found), found.contradictions);
    const bool is_refused = found.proof && found.proof->verdict == ProofVerdict::refused;
    if (is_refused) progress_.announce(planned.label() + ": the verifier refuses the proof: " + found.proof->note);
    progress_.advance(!is_well || is_refused, planned.label());
  }

  void start(const ReadyRun& ready) {
    const PlannedRun& run = *ready.run;
    const std::string& instance_id = ready.instance->id;
    if (plan_.instances[run.instance].n > run.max_n) {
      record_without_running(run, instance_id, RunStatus::not_applicable,
                             fmt::format("beyond the largest n for this algorithm: {}", run.max_n));
      return;
    }
    Request request;
    try {
      request = request_for(run, *ready.instance);
    } catch (const InputError& error) {
      record_without_running(run, instance_id, RunStatus::error, std::string("no start: ") + error.what());
      return;
    }
    const Timing timing{context_.study.min_time_s, context_.study.measures_delaunay_time};
    start_isolated_run(pool_, request, *ready.instance, context_.study.limits, timing,
                       [this, ready, request](const RatedRun& ended) {
                         if (is_failure(ended.status) && is_interrupted_about_now()) return;
                         if (is_to_be_counted(*ready.run, request, ended)) {
                           count(ready, request, ended);
                         } else {
                           record(*ready.run, ready.instance->id, ended);
                         }
                       });
  }

  [[nodiscard]] bool is_to_be_counted(const PlannedRun& run, const Request& request, const RatedRun& ended) const {
    const bool is_wanted = plan_.instances[run.instance].n <= context_.study.max_counted_n;
    return is_wanted && run.repetition < kCountedRepetitions && can_be_counted(ended, request);
  }

  // Executes the run once more under callgrind; it is recorded with what that counts, or without.
  void count(const ReadyRun& ready, const Request& request, const RatedRun& ended) {
    start_counted_run(pool_, context_.program, request, *ready.instance, context_.study.limits, ended,
                      [this, ready, ended](const CountedRun& counted) {
                        if (!counted.profile && is_interrupted_about_now()) return;
                        RatedRun run = ended;
                        if (counted.profile) {
                          const CallgrindCounts& counts = counted.profile->counts;
                          run.callgrind_instructions = counts.instructions;
                          run.callgrind_l1_misses = counts.l1_misses;
                          run.callgrind_ll_misses = counts.ll_misses;
                          run.callgrind_branch_misses = counts.branch_misses;
                          write_profile(folder_.path(), ready.run->run_id, counted.profile->functions);
                        } else {
                          progress_.announce("warning: " + ready.run->algorithm->name + " on " +
                                             plan_.instances[ready.run->instance].label() +
                                             " is not counted: " + counted.why_not);
                        }
                        record(*ready.run, ready.instance->id, std::move(run));
                      });
  }

  // Throws InputError: the given start is no triangulation of the instance.
  [[nodiscard]] Request request_for(const PlannedRun& run, const Instance& instance) const {
    const PlannedInstance& planned = plan_.instances[run.instance];
    Request request;
    request.algorithm = run.algorithm;
    request.parameters = run.parameters;
    request.seed = planned.seed;
    request.threads = context_.study.threads;
    request.time_limit_s = context_.study.limits.time_s;
    if (run.start_file) request.start = read_triangulation(*run.start_file, instance.set, planned.make_points());
    return request;
  }

  void record_without_running(const PlannedRun& run, const std::string& instance_id, RunStatus status,
                              const std::string& message) {
    RatedRun none;
    fail(none, status, message);
    record(run, instance_id, std::move(none));
  }

  void record(const PlannedRun& planned, const std::string& instance_id, RatedRun run) {
    const PlannedInstance& instance = plan_.instances[planned.instance];
    RunRecord row = row_of(context_, instance, instance_id, planned, std::move(run));
    if (planned.algorithm->exactness == Exactness::exact) {
      const OptimumKey key = optimum_key(instance_id, *planned.algorithm, planned.parameters);
      results_.compare_with_cache(row, key);
      row = results_.add(std::move(row));
      results_.keep_in_cache(row, key);
    } else {
      row = results_.add(std::move(row));
    }
    progress_.advance(is_failure(row.status), row.algorithm + " on " + instance.label());
  }

  const Plan& plan_;
  const Catalogue& catalogue_;
  const RowContext& context_;
  const ResultsFolder& folder_;
  OptimumCache* cache_;
  Progress& progress_;
  StudyResults& results_;
  std::map<std::string, std::string> recorded_ids_;      // of points, by label
  std::vector<std::vector<const PlannedRun*>> runs_of_;  // those neither recorded nor begun, by instance
  std::deque<ReadyRun> ready_;
  // Positions in the plan whose runs begin when the optimum of their common points has been sought, by instance id.
  std::map<std::string, std::vector<std::pair<std::size_t, SharedInstance>>> waiting_;
  ProcessPool pool_;  // last: its processes end before what their results refer to
};

}  // namespace

void execute_plan(const Plan& plan, const Catalogue& catalogue, const RowContext& context, const ResultsFolder& folder,
                  int jobs, OptimumCache* cache, Progress& progress, StudyResults& results) {
  PlanExecution(plan, catalogue, context, folder, jobs, cache, progress, results).run();
}

}  // namespace mwt
