#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/archive/benchmark_set.h"
#include "harness/cli/commands/commands.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_cache.h"
#include "harness/records/known_optima.h"
#include "harness/records/results_folder.h"
#include "harness/report/failures.h"
#include "harness/report/optima.h"
#include "harness/report/tables.h"
#include "harness/run/catalogue.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/max_workers.h"
#include "harness/study/estimate/dry_run.h"
#include "harness/study/run_study.h"

namespace mwt {

namespace {

struct RunArguments {
  std::string study;  // empty: that of the benchmark set
  std::optional<std::string> folder;
  bool resume = false;
  int jobs = 1;
  bool no_cache = false;
  std::optional<std::string> shard;
  std::optional<std::string> instances;
  bool accept_other_build = false;
  bool dry_run = false;
  bool quiet = false;
};

// Shards go to folders of their own.
std::string default_folder(const Study& study, const Shard& shard) {
  std::string folder = "results/" + study.name;
  if (shard.count > 1) folder += fmt::format("-shard-{}-of-{}", shard.number, shard.count);
  return folder;
}

// Failures are shown in any case. Returns the exit code that the records call for.
ExitCode print_overview(const std::string& folder, bool with_alphas) {
  const StudyRecords records = read_records(folder);
  const std::vector<RunRecord> runs = rated_by_all_bounds(records.runs, records.instances);
  const std::vector<Cell> cells = cells_of(runs);
  if (with_alphas) std::cout << '\n' << algorithm_table(cells, Labels(cells));
  for (const std::string& table :
       {failure_table(runs), rejected_proof_table(records.instances), stopped_early_table(runs)}) {
    if (!table.empty()) std::cout << '\n' << table;
  }
  std::cout << "\nrecords: " << folder << "/runs.csv; all tables: mwt report " << folder << '\n';
  const auto is_wrong = [](const auto& record) { return is_disproved(record); };
  const bool has_contradiction = std::any_of(runs.begin(), runs.end(), is_wrong) ||
                                 std::any_of(records.instances.begin(), records.instances.end(), is_wrong);
  const auto failed = std::count_if(runs.begin(), runs.end(), [](const auto& run) { return is_failure(run.status); });
  if (failed > 0) std::cout << failed << " of " << runs.size() << " runs failed; the table above names them\n";
  const auto have = [&](ProofVerdict verdict) {
    return std::ranges::any_of(records.instances, [&](const auto& record) { return record.verified == verdict; });
  };
  if (has_contradiction || have(ProofVerdict::refused)) return kExitFailure;
  return failed > 0 || have(ProofVerdict::failed) ? kExitNegative : kExitOk;
}

// The study to run. A benchmark set is unpacked into `unpacked`, and its points take the place of the study's.
Study study_of(const RunArguments& options, std::optional<CommandFolder>& unpacked) {
  if (!options.instances || !is_benchmark_set(*options.instances)) {
    if (options.study.empty())
      throw InputError("name a study (mwt list studies), or a benchmark set (.tar.zst) with --instances");
    return read_study(find_study_file(options.study), options.instances);
  }
  const std::string folder = unpacked.emplace().file("set");
  unpack(read_benchmark_set(*options.instances), folder);
  Study study = read_study(options.study.empty() ? folder + "/study.toml" : find_study_file(options.study));
  study.families.clear();
  study.instance_files = {folder, {"points/*.txt"}, *options.instances};
  study.file_content +=
      "\n# Run on the points of the benchmark set with SHA-256 " + sha256_of_file(*options.instances) + '\n';
  return study;
}

int run(const RunArguments& options) {
  std::optional<CommandFolder> unpacked;
  const Study study = study_of(options, unpacked);
  RunOptions run_options;
  if (options.shard) run_options.shard = parse_shard(*options.shard);
  run_options.folder = options.folder.value_or(default_folder(study, run_options.shard));
  run_options.accepts_other_build = options.accept_other_build;
  run_options.resume = options.resume;
  run_options.jobs = options.jobs;
  run_options.is_terminal = isatty(STDOUT_FILENO) == 1;
  if (!options.no_cache) run_options.cache_folder = optimum_cache_folder();
  if (options.dry_run) {
    dry_run(study, Catalogue::built_in(), run_options, std::cout);
    return kExitOk;
  }
  const StudyOutcome outcome = run_study(study, Catalogue::built_in(), run_options, std::cout);
  const ExitCode code = print_overview(run_options.folder, !options.quiet);
  return outcome.interrupted ? kExitInterrupted : code;
}

}  // namespace

Command run_command() {
  const auto options = std::make_shared<RunArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.optional_argument("study", options->study, study_kind(),
                               "name of a study (mwt list studies) or path of a study file");
    declared.option("--out", options->folder, kFolder, "folder for the records; results/STUDY if not given");
    declared.flag("--dry-run", options->dry_run, "print what would run and an estimate of the time");
    declared.flag("--resume", options->resume, "continue in a folder that has records: run only what is missing");
    declared.positive("--jobs", options->jobs, "runs side by side; more than one distorts the times", kMaxWorkers);
    declared.flag("--quiet", options->quiet,
                  "print progress, warnings and failures only, no table of alphas at the end");
    declared.flag("--no-cache", options->no_cache, "seek every optimum anew; neither read nor write the optimum cache");
    declared.option("--shard", options->shard, ValueKind{"I/N"},
                    "i/N: run only the i-th of N parts; mwt merge joins them");
    declared.option(
        "--instances", options->instances, kFolder,
        "folder of the study's point files, instead of the study's own; or a benchmark set (mwt archive), whose "
        "points are run instead of the study's, by its own study if none is named");
    declared.flag("--accept-other-build", options->accept_other_build,
                  "with --resume: continue although the records come from another build of mwt");
  };
  return {"run", "Run a study: isolate, check and record every run", declare, [options] { return run(*options); }};
}

}  // namespace mwt
