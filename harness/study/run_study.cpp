#include "harness/study/run_study.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "harness/rating/optimum_search.h"
#include "harness/run/interrupt.h"
#include "harness/run/machine/environment.h"
#include "harness/run/machine/machine_watch.h"
#include "harness/study/study_session.h"

namespace mwt {

namespace {

void require_same_build(const StudySession& session) {
  const std::set<std::string> recorded = session.folder.run_ids();
  const auto& planned = session.plan.runs;
  const bool is_complete =
      std::all_of(planned.begin(), planned.end(), [&](const PlannedRun& run) { return recorded.contains(run.run_id); });
  if (is_complete || session.options.accepts_other_build) return;
  for (const RunRecord& run : session.folder.runs()) {
    if (run.binary_sha256 == session.environment.binary_sha256) continue;
    throw InputError(session.options.folder + ": its runs were recorded by another build of mwt (commit " +
                     run.git_commit + "; this one: " + session.environment.git_commit +
                     "); choose a new folder with --out, or mix the two with --accept-other-build");
  }
}

// Under one name there must be one instance, whenever its runs were recorded.
template <class Record>
void require_unchanged_files(const StudySession& session, const std::vector<Record>& records) {
  std::map<std::string, std::string> ids;  // by the parameter that names the file
  for (const PlannedInstance& planned : session.plan.instances) {
    if (planned.generator == kFileGenerator) ids[planned.parameters] = planned.file_instance_id;
  }
  for (const Record& record : records) {
    const auto id = record.generator == kFileGenerator ? ids.find(record.generator_params) : ids.end();
    if (id == ids.end() || record.instance_id.empty() || id->second == record.instance_id) continue;
    throw InputError(parse_canonical(record.generator_params)["file"] +
                     ": has changed since its runs were recorded in " + session.options.folder +
                     "; restore it, or choose a new folder with --out");
  }
}

// Other reasons why recorded runs are not this study's any more.
void require_planned(const StudySession& session) {
  if (session.options.accepts_other_build) return;
  for (const RunRecord& run : session.folder.runs()) {
    if (session.planned_ids.contains(run.run_id)) continue;
    throw InputError(session.options.folder + ": its run of " + name_with_parameters(run.algorithm, run.params) +
                     " on " + label_of_instance(run) +
                     " is none of this study any more: a point file, a start file or this mwt has changed or is gone;"
                     " restore it, choose a new folder with --out, or keep such runs with --accept-other-build");
  }
}

void announce_plan(StudySession& session) {
  const std::string shard = session.options.shard.text();
  session.out << "study " << session.study.name << (shard.empty() ? "" : ", shard " + shard) << ": "
              << session.plan.instances.size() << " instances, " << session.plan.runs.size() << " runs, results in "
              << session.options.folder << '\n';
  for (const std::string& note : session.plan.notes) session.out << "  " << note << '\n';
  for (const std::string& warning : session.folder.warnings()) session.out << "  warning: " << warning << '\n';
  for (const std::string& warning : timing_warnings(session.environment))
    session.out << "  warning: " << warning << '\n';
  const std::size_t recorded = session.folder.runs().size();
  if (recorded > 0) session.out << "  recorded already: " << recorded << " runs\n";
}

// What earlier invocations certified is known to this one.
template <class Record>
void adopt_optima(StudySession& session, const std::vector<Record>& records) {
  std::map<std::string, std::pair<std::string, std::vector<Disproof>>> disproofs;  // by instance, with its label
  for (const Record& record : records) {
    for (const Disproof& disproof : session.known.add(record)) {
      auto& [label, of_instance] = disproofs[record.instance_id];
      label = label_of_instance(record);
      of_instance.push_back(disproof);
    }
  }
  // Settling changes the records: only now.
  for (const auto& [instance_id, entry] : disproofs) session.settle(instance_id, entry.first, entry.second);
}

// An instance whose optimum was disproved has none until one is found that stands.
void seek_disproved_optima_again(StudySession& session) {
  for (const InstanceRecord& instance : session.folder.instances()) {
    if (is_disproved(instance) && !instance.optimum_lower) session.to_seek_again.insert(instance.instance_id);
  }
}

void announce_end(const StudySession& session, const MachineWatch& watch) {
  for (const std::string& warning : watch.warnings()) session.out << "  warning: " << warning << '\n';
  if (session.outcome.interrupted) session.out << "interrupted; the same command with --resume runs the rest\n";
}

}  // namespace

StudyOutcome run_study(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // before the folder is made
  StudySession session(study, catalogue, options, out);
  require_unchanged_files(session, session.folder.instances());
  require_unchanged_files(session, session.folder.runs());
  require_planned(session);
  require_same_build(session);
  session.folder.append(session.environment);
  announce_plan(session);
  adopt_optima(session, session.folder.instances());
  adopt_optima(session, session.folder.runs());
  seek_disproved_optima_again(session);
  const InterruptWatch interrupt_watch;
  const MachineWatch machine_watch;
  seek_optima(session);
  execute_runs(session);
  if (!session.to_seek_again.empty() && !InterruptWatch::requested()) seek_optima(session);
  session.outcome.interrupted = InterruptWatch::requested();
  announce_end(session, machine_watch);
  return session.outcome;
}

}  // namespace mwt
