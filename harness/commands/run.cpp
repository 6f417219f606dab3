#include <unistd.h>

#include <iostream>
#include <memory>

#include "harness/catalogue.h"
#include "harness/commands/commands.h"
#include "harness/optimum_cache.h"
#include "harness/study/run_study.h"

namespace mwt {

namespace {

struct Options {
  std::string study;
  std::optional<std::string> folder;
  bool resume = false;
  int jobs = 1;
  bool no_cache = false;
};

int run(const Options& options) {
  const Study study = read_study(find_study_file(options.study));
  RunOptions run_options;
  run_options.folder = options.folder.value_or("results/" + study.name);
  run_options.resume = options.resume;
  run_options.jobs = options.jobs;
  run_options.is_terminal = isatty(STDOUT_FILENO) == 1;
  if (!options.no_cache) run_options.cache_folder = optimum_cache_folder();
  const StudyOutcome outcome = run_study(study, Catalogue::built_in(), run_options, std::cout);
  if (outcome.interrupted) return kExitInterrupted;
  return outcome.contradictions > 0 ? kExitFailure : kExitOk;
}

}  // namespace

Command run_command() {
  const auto options = std::make_shared<Options>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("study", options->study, "name of a study (mwt list studies) or path of a study file");
    declared.option("--out", options->folder, "folder for the records; results/STUDY if not given");
    declared.flag("--resume", options->resume, "continue in a folder that has records: run only what is missing");
    declared.positive("--jobs", options->jobs, "runs side by side; more than one disturbs the times");
    declared.flag("--no-cache", options->no_cache, "seek every optimum anew; leave the optimum cache alone");
  };
  return {"run", "Run a study: every run isolated, checked and recorded", declare, [options] { return run(*options); }};
}

}  // namespace mwt
