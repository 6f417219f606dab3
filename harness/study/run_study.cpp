#include "harness/study/run_study.h"

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "geometry/error.h"
#include "harness/environment.h"
#include "harness/progress.h"
#include "harness/quality.h"
#include "harness/study/interrupt.h"
#include "harness/study/isolated_run.h"
#include "harness/study/known_optima.h"
#include "harness/study/optimum_search.h"
#include "harness/study/plan.h"
#include "harness/study/results_folder.h"
#include "harness/study/summary.h"
#include "harness/text.h"

namespace mwt {

namespace {

constexpr std::chrono::milliseconds kPatience{200};

// The instances of a plan, made when they are needed. The last one stays, for runs come instance by instance.
class InstanceMaker {
 public:
  explicit InstanceMaker(const Plan& plan) : plan_(plan) {}

  std::shared_ptr<const Instance> operator()(std::size_t position) {
    if (!last_ || position != last_position_) {
      const PlannedInstance& planned = plan_.instances[position];
      last_ = std::make_shared<const Instance>(make_instance(planned.generate(), planned.label()));
      last_position_ = position;
    }
    return last_;
  }

 private:
  const Plan& plan_;
  std::shared_ptr<const Instance> last_;
  std::size_t last_position_ = 0;
};

class StudyRunner {
 public:
  StudyRunner(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out)
      : study_(study),
        catalogue_(catalogue),
        options_(options),
        out_(out),
        plan_(make_plan(study, catalogue)),
        folder_(options.folder, study, options.resume),
        environment_(describe_environment(study.name, options.jobs)),
        make_instance_(plan_) {}

  StudyOutcome run() {
    folder_.append(environment_);
    announce_plan();
    adopt_recorded();
    const InterruptWatch watch;
    seek_optima();
    execute_runs();
    outcome_.interrupted = InterruptWatch::requested();
    print_results();
    return outcome_;
  }

 private:
  void announce_plan() const {
    out_ << "study " << study_.name << ": " << plan_.instances.size() << " instances, " << plan_.runs.size()
         << " runs, results in " << options_.folder << '\n';
    for (const std::string& note : plan_.notes) out_ << "  " << note << '\n';
    for (const std::string& warning : timing_warnings(environment_)) out_ << "  warning: " << warning << '\n';
  }

  // What earlier invocations recorded counts as done and as known.
  void adopt_recorded() {
    for (const InstanceRecord& record : folder_.instances()) {
      sought_.insert(record.instance_id);
      if (const auto bounds = optimum_of(record)) add_known(record.instance_id, *bounds, "instances.csv");
    }
    for (const RunRecord& record : folder_.runs()) {
      recorded_.insert(record.run_id);
      if (const auto bounds = optimum_of(record)) add_known(record.instance_id, *bounds, "runs.csv");
    }
    if (!recorded_.empty()) out_ << "  recorded already: " << recorded_.size() << " runs\n";
  }

  void add_known(const std::string& instance_id, const Interval& bounds, const std::string& where) {
    if (known_.add(instance_id, bounds)) return;
    ++outcome_.contradictions;
    out_ << "  CONTRADICTION in " << where << ": certified optima of instance " << instance_id
         << " exclude each other\n";
  }

  void seek_optima() {
    Progress progress(out_, options_.is_terminal, "optima", plan_.instances.size());
    ProcessPool pool(options_.jobs);
    for (std::size_t i = 0; i < plan_.instances.size() && !InterruptWatch::requested(); ++i) {
      std::shared_ptr<const Instance> instance;
      try {
        instance = make_instance_(i);
      } catch (const InputError& error) {  // its runs become rows that say so
        progress.announce(plan_.instances[i].label() + ": no instance: " + error.what());
        progress.advance(true, "");
        continue;
      }
      if (!sought_.insert(instance->id).second) {
        progress.advance(false, "");
        continue;
      }
      if (!wait_for_room(pool, progress)) break;
      const auto n = static_cast<Index>(instance->set.points.size());
      std::vector<const AlgorithmInfo*> sources;
      if (study_.seeks_optimum) sources = optimum_sources_for(catalogue_, study_.optimum_sources, n);
      seek_optimum(pool, instance, std::move(sources), study_.optimum_limits,
                   [this, i, instance, &progress](const FoundOptimum& found) {
                     record_instance(plan_.instances[i], *instance, found, progress);
                   });
    }
    wait_for_all(pool, progress);
  }

  void record_instance(const PlannedInstance& planned, const Instance& instance, const FoundOptimum& found,
                       Progress& progress) {
    InstanceRecord record;
    record.instance_id = instance.id;
    record.study = study_.name;
    record.env_id = environment_.env_id;
    record.recorded_at = utc_now();
    record.generator = planned.family->name;
    record.generator_params = planned.parameters.canonical();
    record.n = planned.n;
    record.seed = planned.seed;
    record.distinct = static_cast<Index>(instance.set.points.size());
    record.duplicates = instance.set.duplicates();
    record.hull_size = instance.hull_size;
    if (found.interval) {
      record.optimum_lower = found.interval->lower;
      record.optimum_upper = found.interval->upper;
      static_cast<void>(known_.add(instance.id, *found.interval));  // its first bounds: nothing to contradict
    }
    record.optimality = name_of(optimality_of(found.interval));
    record.optimum_source = found.source;
    record.optimum_time_s = found.time_s;
    record.optimum_note = found.note;
    folder_.append(record);
    if (found.contradiction) {
      ++outcome_.contradictions;
      progress.announce(planned.label() + ": " + found.note);
    }
    progress.advance(found.contradiction, planned.label());
  }

  void execute_runs() {
    std::size_t missing = 0;
    for (const PlannedRun& run : plan_.runs) missing += recorded_.contains(run.run_id) ? 0 : 1;
    Progress progress(out_, options_.is_terminal, "runs", missing);
    ProcessPool pool(options_.jobs);
    for (const PlannedRun& run : plan_.runs) {
      if (InterruptWatch::requested()) break;
      if (recorded_.contains(run.run_id)) continue;
      if (wait_for_room(pool, progress)) start(run, pool, progress);
    }
    wait_for_all(pool, progress);
  }

  void start(const PlannedRun& run, ProcessPool& pool, Progress& progress) {
    RunRecord keys = keys_of(run);
    std::shared_ptr<const Instance> instance;
    try {
      instance = make_instance_(run.instance);
      keys.instance_id = instance->id;
    } catch (const InputError& error) {
      record_without_running(std::move(keys), RunStatus::error, std::string("no instance: ") + error.what(), progress);
      return;
    }
    if (keys.n > run.largest_n) {
      record_without_running(std::move(keys), RunStatus::not_applicable,
                             "beyond the largest n for this algorithm: " + std::to_string(run.largest_n), progress);
      return;
    }
    Request request;
    request.algorithm = run.algorithm;
    request.parameters = run.parameters;
    request.seed = keys.seed;
    request.threads = study_.threads;
    request.time_limit_s = study_.limits.time_s;
    start_isolated_run(pool, request, instance, keys, study_.limits, study_.min_time_s,
                       [this, &progress](RunRecord record) { record_run(std::move(record), progress); });
  }

  void record_without_running(RunRecord record, RunStatus status, const std::string& message, Progress& progress) {
    record.status = status;
    record.message = message;
    record.recorded_at = utc_now();
    record_run(std::move(record), progress);
  }

  [[nodiscard]] RunRecord keys_of(const PlannedRun& run) const {
    const PlannedInstance& planned = plan_.instances[run.instance];
    RunRecord record;
    record.run_id = run.run_id;
    record.study = study_.name;
    record.env_id = environment_.env_id;
    record.git_commit = environment_.git_commit;
    record.binary_sha256 = environment_.binary_sha256;
    record.algorithm = run.algorithm->name;
    record.params = run.parameters.canonical();
    record.generator = planned.family->name;
    record.generator_params = planned.parameters.canonical();
    record.n = planned.n;
    record.seed = planned.seed;
    record.repetition = run.repetition;
    record.threads = study_.threads;
    record.time_limit_s = study_.limits.time_s;
    record.memory_limit_bytes = study_.limits.memory_bytes;
    return record;
  }

  void record_run(RunRecord record, Progress& progress) {
    const std::string label = record.algorithm + " on " + record.generator + " n=" + std::to_string(record.n) +
                              " seed=" + std::to_string(record.seed);
    if (!known_.rate(record)) {
      ++outcome_.contradictions;
      progress.announce(label + ": " + record.message);
    }
    folder_.append(record);
    ++outcome_.runs;
    if (is_failure(record.status)) ++outcome_.failures;
    progress.advance(is_failure(record.status), label);
  }

  // Whether there is room; without it, an interrupt was requested.
  static bool wait_for_room(ProcessPool& pool, Progress& progress) {
    while (pool.is_full() && !InterruptWatch::requested()) {
      pool.wait(kPatience);
      progress.refresh();
    }
    return !pool.is_full();
  }

  static void wait_for_all(ProcessPool& pool, Progress& progress) {
    while (!pool.is_empty() && !InterruptWatch::requested()) {
      pool.wait(kPatience);
      progress.refresh();
    }
    progress.finish();
  }

  void print_results() const {
    out_ << '\n';
    if (!folder_.runs().empty()) out_ << summary_tables(folder_.runs()) << '\n';
    if (outcome_.interrupted) out_ << "interrupted; the rest is run by the same command with --resume\n";
    out_ << "records: " << options_.folder << "/runs.csv\n";
  }

  const Study& study_;
  const Catalogue& catalogue_;
  const RunOptions& options_;
  std::ostream& out_;
  Plan plan_;
  ResultsFolder folder_;
  EnvironmentRecord environment_;
  InstanceMaker make_instance_;
  KnownOptima known_;
  std::set<std::string> sought_;    // instance ids
  std::set<std::string> recorded_;  // run ids
  StudyOutcome outcome_;
};

}  // namespace

StudyOutcome run_study(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // before the folder is made
  return StudyRunner(study, catalogue, options, out).run();
}

}  // namespace mwt
