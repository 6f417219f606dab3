#include "harness/study/run_study.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "harness/rating/counted_run.h"
#include "harness/rating/optimum_search.h"
#include "harness/records/environment.h"
#include "harness/records/profile_folder.h"
#include "harness/records/proof_folder.h"
#include "harness/run/interrupt.h"
#include "harness/run/machine/machine_watch.h"
#include "harness/study/command_starts.h"
#include "harness/study/execute_plan.h"
#include "harness/study/study_results.h"

namespace mwt {

namespace {

void require_same_build(const RunOptions& options, const ResultsFolder& folder, const Plan& plan,
                        const EnvironmentRecord& environment) {
  const std::set<std::string> recorded = folder.run_ids();
  const bool is_complete =
      std::ranges::all_of(plan.runs, [&](const PlannedRun& run) { return recorded.contains(run.run_id); });
  if (is_complete || options.accepts_other_build) return;
  for (const RunRecord& run : folder.runs()) {
    if (run.binary_sha256 == environment.binary_sha256) continue;
    throw InputError(
        fmt::format("{}: its runs were recorded by another build of mwt (commit {}; this one: {}); choose a new folder "
                    "with --out, or mix the two with --accept-other-build",
                    options.folder, run.git_commit, environment.git_commit));
  }
}

// Under one name there must be one instance, whenever its runs were recorded.
template <class Record>
void require_unchanged_files(const std::string& folder, const Plan& plan, const std::vector<Record>& records) {
  std::map<std::string, std::string> ids;  // by the parameter that names the file
  for (const PlannedInstance& planned : plan.instances) {
    if (planned.generator == kFileGenerator) ids[planned.parameters] = planned.file_instance_id;
  }
  for (const Record& record : records) {
    const auto id = record.generator == kFileGenerator ? ids.find(record.generator_params) : ids.end();
    if (id == ids.end() || record.instance_id.empty() || id->second == record.instance_id) continue;
    throw InputError(parse_canonical(record.generator_params)["file"] +
                     ": has changed since its runs were recorded in " + folder +
                     "; restore it, or choose a new folder with --out");
  }
}

// Other reasons why recorded runs are not this study's any more. `whole`: with the other shards.
void require_planned(const RunOptions& options, const ResultsFolder& folder, const Plan& whole) {
  if (options.accepts_other_build) return;
  const std::set<std::string> planned = run_ids_of(whole);
  for (const RunRecord& run : folder.runs()) {
    if (planned.contains(run.run_id)) continue;
    throw InputError(fmt::format(
        "{}: its run of {} on {} is none of this study any more: a point file, a start file or this mwt has changed or "
        "is gone; restore it, choose a new folder with --out, or keep such runs with --accept-other-build",
        options.folder, name_with_parameters(run.algorithm, run.params), label_of_instance(run)));
  }
}

void require_valgrind(const Study& study) {
  if (study.max_counted_n > 0 && !has_valgrind())
    throw InputError(
        "study " + study.name +
        ": counts = \"callgrind\" needs valgrind; install it (apt-get install valgrind), or delete 'counts'");
}

std::string own_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

void announce_plan(const Study& study, const RunOptions& options, const Plan& plan, const ResultsFolder& folder,
                   const EnvironmentRecord& environment, std::ostream& out) {
  const std::string shard = options.shard.text();
  out << "study " << study.name << (shard.empty() ? "" : ", shard " + shard) << ": " << plan.instances.size()
      << " instances, " << plan.runs.size() << " runs, results in " << options.folder << '\n';
  for (const std::string& note : plan.notes) out << "  " << note << '\n';
  for (const std::string& warning : folder.warnings()) out << "  warning: " << warning << '\n';
  for (const std::string& warning : timing_warnings(environment)) out << "  warning: " << warning << '\n';
  const std::size_t recorded = folder.runs().size();
  if (recorded > 0) out << "  recorded already: " << recorded << " runs\n";
}

}  // namespace

StudyOutcome run_study(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // before the folder is made
  require_valgrind(study);
  const Plan whole = make_plan(study, catalogue);
  Plan plan = options.instances ? part_of(whole, *options.instances) : part_of(whole, options.shard);
  if (options.only_optima) plan.runs.clear();
  ResultsFolder folder(options.folder, study.name, study.file_content, options.resume, options.folder_use);
  const EnvironmentRecord environment = describe_environment(study.name, options.jobs, options.shard.text());
  require_unchanged_files(options.folder, plan, folder.instances());
  require_unchanged_files(options.folder, plan, folder.runs());
  require_planned(options, folder, whole);
  require_same_build(options, folder, plan, environment);
  folder.append(environment);
  if (study.max_proof_n > 0) prepare_proof_folder(options.folder);
  if (study.max_counted_n > 0) prepare_profile_folder(options.folder);
  announce_plan(study, options, plan, folder, environment, out);

  const InterruptWatch interrupt_watch;
  const MachineWatch machine_watch;
  Progress progress(out, options.is_terminal, "steps", 0);  // execute_plan() counts them
  const auto announce = [&progress](const std::string& line) { progress.announce(line); };
  std::optional<OptimumCache> cache;
  if (options.cache_folder) {
    cache.emplace(*options.cache_folder, [&](const std::string& warning) { announce("warning: " + warning); });
  }
  OptimumCache* const cache_if_any = cache ? &*cache : nullptr;
  StudyResults results(folder, cache_if_any, announce);
  const RowContext context{study, environment, measure_command_starts(study, plan, folder.run_ids(), announce),
                           own_program()};
  execute_plan(plan, catalogue, context, folder, options.jobs, cache_if_any, progress, results);
  progress.finish();
  for (const std::string& warning : machine_watch.warnings()) out << "  warning: " << warning << '\n';
  StudyOutcome outcome = results.outcome();
  outcome.interrupted = InterruptWatch::requested();
  if (outcome.interrupted) out << "interrupted; the same command with --resume runs the rest\n";
  return outcome;
}

}  // namespace mwt
