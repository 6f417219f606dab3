#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "base/error.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"
#include "harness/run/isolated_run.h"
#include "harness/study/study_session.h"

namespace mwt {

namespace {

class RunPhase {
 public:
  explicit RunPhase(StudySession& session)
      : session_(session),
        recorded_(session.folder.run_ids()),
        progress_(session.out, session.options.is_terminal, "runs", missing()),
        pool_(session.options.jobs) {
    session_.progress = &progress_;
  }
  ~RunPhase() { session_.progress = nullptr; }
  RunPhase(const RunPhase&) = delete;
  RunPhase& operator=(const RunPhase&) = delete;

  void run() {
    for (const PlannedRun& run : session_.plan.runs) {
      if (recorded_.contains(run.run_id)) continue;
      if (!wait_for_room(pool_, progress_)) break;
      start(run);
    }
    wait_for_all(pool_, progress_);
  }

 private:
  [[nodiscard]] std::size_t missing() const {
    const auto& runs = session_.plan.runs;
    return static_cast<std::size_t>(std::count_if(
        runs.begin(), runs.end(), [&](const PlannedRun& run) { return !recorded_.contains(run.run_id); }));
  }

  void start(const PlannedRun& run) {
    RunRecord keys = keys_of(run);
    std::shared_ptr<const Instance> instance;
    try {
      instance = session_.instances.make(run.instance);
      keys.instance_id = instance->id;
    } catch (const std::exception& error) {
      record_without_running(std::move(keys), RunStatus::error, std::string("no instance: ") + error.what());
      return;
    }
    if (keys.n > run.max_n) {
      record_without_running(std::move(keys), RunStatus::not_applicable,
                             "beyond the largest n for this algorithm: " + std::to_string(run.max_n));
      return;
    }
    Request request;
    try {
      request = request_for(run, *instance);
    } catch (const InputError& error) {
      record_without_running(std::move(keys), RunStatus::error, std::string("no start: ") + error.what());
      return;
    }
    const Timing timing{session_.study.min_time_s, session_.study.measures_delaunay_time};
    start_isolated_run(pool_, request, instance, keys, session_.study.limits, timing, [this, &run](RunRecord ended) {
      const bool is_exact = run.algorithm->exactness == Exactness::exact;
      if (is_exact && ended.certified_lower) compare_with_cache(run, ended);
      const RunRecord& row = record(std::move(ended));
      if (is_exact && row.status == RunStatus::ok && row.certified_lower) remember(run, row);
    });
  }

  // The cache may hold what the same solver proved before, although the study does not take it for the optimum.
  void compare_with_cache(const PlannedRun& run, RunRecord& ended) {
    if (!session_.cache || ended.status != RunStatus::ok) return;
    const OptimumKey key = optimum_key(ended.instance_id, *run.algorithm, run.parameters);
    const std::optional<CachedOptimum> earlier = session_.cache->find(key);
    if (!earlier) return;
    OptimumClaims claims;
    static_cast<void>(claims.add_claim({"cache", session_.cache->path_of(key), earlier->interval}));
    const Interval own{*ended.certified_lower, ended.weight_upper.value()};
    for (const Disproof& disproof : claims.add_claim({"run", run.algorithm->name, own})) {
      if (disproof.claim.id == "run") {
        reject(ended, disproof);
      } else {
        session_.announce(disproof.text() + "; it is thrown out");
        static_cast<void>(session_.cache->discard_disproved(ended.instance_id, disproof.weight));
      }
    }
  }

  // Other studies need not solve the instance again.
  void remember(const PlannedRun& run, const RunRecord& row) {
    if (!session_.cache) return;
    const OptimumKey key = optimum_key(row.instance_id, *run.algorithm, run.parameters);
    const Interval optimum{*row.certified_lower, row.weight_upper.value()};
    if (!session_.cache->find(key)) session_.cache->store(key, {optimum, row.wall_time_s.value_or(0)});
  }

  // Throws InputError: the given start is no triangulation of the instance.
  [[nodiscard]] Request request_for(const PlannedRun& run, const Instance& instance) const {
    const PlannedInstance& planned = session_.plan.instances[run.instance];
    Request request;
    request.algorithm = run.algorithm;
    request.parameters = run.parameters;
    request.seed = planned.seed;
    request.threads = session_.study.threads;
    request.time_limit_s = session_.study.limits.time_s;
    if (run.start_file) request.start = read_triangulation(*run.start_file, instance.set, planned.make_points());
    return request;
  }

  [[nodiscard]] RunRecord keys_of(const PlannedRun& run) const {
    const PlannedInstance& planned = session_.plan.instances[run.instance];
    const Study& study = session_.study;
    RunRecord record;
    record.run_id = run.run_id;
    record.study = study.name;
    record.env_id = session_.environment.env_id;
    record.git_commit = session_.environment.git_commit;
    record.binary_sha256 = session_.environment.binary_sha256;
    record.algorithm = run.algorithm->name;
    record.params = run.parameters.canonical();
    record.generator = planned.generator;
    record.generator_params = planned.parameters;
    record.n = planned.n;
    record.seed = planned.seed;
    record.repetition = run.repetition;
    record.threads = study.threads;
    record.time_limit_s = study.limits.time_s;
    record.memory_limit_bytes = study.limits.memory_bytes;
    return record;
  }

  void record_without_running(RunRecord run, RunStatus status, const std::string& message) {
    run.status = status;
    run.message = message;
    run.recorded_at = utc_now();
    record(std::move(run));
  }

  // Completes the row, writes it and returns it.
  const RunRecord& record(RunRecord run) {
    const std::string instance_label =
        run.generator + " n=" + std::to_string(run.n) + " seed=" + std::to_string(run.seed);
    const std::string label = run.algorithm + " on " + instance_label;
    StudyOutcome& outcome = session_.outcome;
    const std::vector<Disproof> disproofs = session_.known.add(run);
    for (const Disproof& disproof : disproofs) {
      if (disproof.claim.id == run.run_id) reject(run, disproof);
    }
    session_.known.rate(run);
    if (is_disproved(run) && disproofs.empty()) {
      ++outcome.contradictions;
      progress_.announce(label + ": " + run.message);
    }
    session_.folder.append(run);
    session_.settle(run.instance_id, instance_label, disproofs);
    ++outcome.runs;
    if (is_failure(run.status)) ++outcome.failures;
    progress_.advance(is_failure(run.status), label);
    return session_.folder.runs().back();
  }

  StudySession& session_;
  std::set<std::string> recorded_;  // run ids
  Progress progress_;
  ProcessPool pool_;  // last: its processes end before what their results refer to
};

}  // namespace

void execute_runs(StudySession& session) { RunPhase(session).run(); }

}  // namespace mwt
