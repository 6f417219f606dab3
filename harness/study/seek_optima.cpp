#include <exception>
#include <set>
#include <utility>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"
#include "harness/rating/quality.h"
#include "harness/study/study_session.h"

namespace mwt {

namespace {

class OptimumPhase {
 public:
  explicit OptimumPhase(StudySession& session)
      : session_(session),
        progress_(session.out, session.options.is_terminal, "optima", session.plan.instances.size()),
        pool_(session.options.jobs) {
    session_.progress = &progress_;
    for (const InstanceRecord& record : session.folder.instances()) recorded_.insert(record.instance_id);
    for (const std::string& instance_id : recorded_) {
      if (!session.to_seek_again.contains(instance_id)) sought_.insert(instance_id);
    }
    session.to_seek_again.clear();
  }

  ~OptimumPhase() { session_.progress = nullptr; }
  OptimumPhase(const OptimumPhase&) = delete;
  OptimumPhase& operator=(const OptimumPhase&) = delete;

  void run() {
    for (const PlannedInstance& planned : session_.plan.instances) {
      if (!wait_for_room(pool_, progress_)) break;
      seek(planned);
    }
    wait_for_all(pool_, progress_);
  }

 private:
  void seek(const PlannedInstance& planned) {
    std::shared_ptr<const Instance> instance;
    try {
      instance = session_.instances.make(static_cast<std::size_t>(&planned - session_.plan.instances.data()));
    } catch (const std::exception& error) {  // its runs become rows that say so
      progress_.announce(planned.label() + ": no instance: " + error.what());
      progress_.advance(true, planned.label());
      return;
    }
    const bool is_new = sought_.insert(instance->id).second;
    if (!is_new) {
      progress_.advance(false, planned.label());
      return;
    }
    const auto when_done = [this, &planned, instance](FoundOptimum found) {
      record(planned, *instance, std::move(found));
    };
    OptimumCache* const cache = session_.cache ? &*session_.cache : nullptr;
    seek_optimum(pool_, instance, sources_for(*instance), session_.study.optimum_limits, cache,
                 session_.known.lightest_of(instance->id), when_done);
  }

  [[nodiscard]] std::vector<const AlgorithmInfo*> sources_for(const Instance& instance) const {
    if (!session_.study.seeks_optimum) return {};
    const auto n = static_cast<Index>(instance.set.points.size());
    return optimum_sources_for(session_.catalogue, session_.study.optimum_sources, n, instance.hull_size == n);
  }

  void record(const PlannedInstance& planned, const Instance& instance, FoundOptimum found) {
    InstanceRecord record = keys_of(planned, instance);
    if (found.interval) {
      record.optimum_lower = found.interval->lower;
      record.optimum_upper = found.interval->upper;
    }
    record.optimality = name_of(optimality_of(found.interval));
    record.optimum_source = found.source;
    record.optimum_time_s = found.time_s;
    record.optimum_note = found.note;
    for (const std::string& warning : found.warnings)
      progress_.announce("warning: " + planned.label() + ": " + warning);
    for (const std::string& contradiction : found.contradictions) {
      ++session_.outcome.contradictions;
      progress_.announce(planned.label() + ": " + contradiction);
    }
    const std::vector<Disproof> disproofs = session_.known.add(record);
    put(record);
    session_.settle(instance.id, planned.label(), disproofs);
    progress_.advance(!found.contradictions.empty() || !disproofs.empty(), planned.label());
  }

  void put(const InstanceRecord& record) {
    if (recorded_.insert(record.instance_id).second) {
      session_.folder.append(record);
      return;
    }
    session_.folder.replace(record);
    session_.folder.settle(record.instance_id);  // its runs are rated by it
  }

  [[nodiscard]] InstanceRecord keys_of(const PlannedInstance& planned, const Instance& instance) const {
    InstanceRecord record;
    record.instance_id = instance.id;
    record.study = session_.study.name;
    record.env_id = session_.environment.env_id;
    record.recorded_at = utc_now();
    record.generator = planned.generator;
    record.generator_params = planned.parameters;
    record.n = planned.n;
    record.seed = planned.seed;
    record.distinct = static_cast<Index>(instance.set.points.size());
    record.duplicates = instance.set.duplicates();
    record.hull_size = instance.hull_size;
    return record;
  }

  StudySession& session_;
  Progress progress_;
  std::set<std::string> recorded_;  // ids of instances that have a row
  std::set<std::string> sought_;    // of those that need no search
  ProcessPool pool_;                // last: its processes end before what their results refer to
};

}  // namespace

void seek_optima(StudySession& session) { OptimumPhase(session).run(); }

}  // namespace mwt
