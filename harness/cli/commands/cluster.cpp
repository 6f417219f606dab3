#include <fmt/core.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/cli/commands/commands.h"
#include "harness/io/terminal.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_cache.h"
#include "harness/run/catalogue.h"
#include "harness/study/cluster/shard_task.h"
#include "harness/study/cluster/status.h"
#include "harness/study/cluster/submit.h"

namespace mwt {

namespace {

struct ClusterArguments {
  std::string action;
  std::string target;
  std::string task;
  std::optional<Index> shards;
  std::optional<std::string> folder;
  std::optional<std::string> instances;
  bool no_cache = false;
  bool write_only = false;
  bool only_optima = false;
  SlurmRequest request;
};

// An option that the action does not take is a mistake, not a wish to be ignored.
void require_only_its_options(const ClusterArguments& options) {
  struct Given {
    const char* name;
    bool is_given;
    std::vector<std::string> actions;
  };
  const std::vector<std::string> submits = {"submit", "resubmit"};
  const std::vector<Given> all = {
      {"--shards", options.shards.has_value(), {"submit"}},
      {"--out", options.folder.has_value(), {"submit"}},
      {"--instances", options.instances.has_value(), {"submit"}},
      {"--no-cache", options.no_cache, {"submit"}},
      {"--write-only", options.write_only, {"submit"}},
      {"--optima", options.only_optima, {"task"}},
      {"the number of a shard", !options.task.empty(), {"task"}},
      {"an option for Slurm", !options.request.words().empty(), submits},
  };
  for (const Given& option : all) {
    if (!option.is_given || std::ranges::find(option.actions, options.action) != option.actions.end()) continue;
    throw InputError(fmt::format("cluster {} does not take {}; it is for cluster {}", options.action, option.name,
                                 joined(option.actions, " and ")));
  }
}

int submit(const ClusterArguments& options) {
  if (!options.shards || *options.shards < 1) throw InputError("give the number of parts: --shards N");
  SubmitOptions submitted;
  submitted.study_path = find_study_file(options.target);
  submitted.instance_folder = options.instances;
  const Study study = read_study(submitted.study_path, options.instances);
  submitted.folder = options.folder.value_or("results/" + study.name + "-cluster");
  if (!options.no_cache) submitted.cache_folder = optimum_cache_folder();
  submitted.shards = *options.shards;
  submitted.request = options.request;
  submitted.only_writes = options.write_only;
  submit_study(study, Catalogue::built_in(), submitted, std::cout);
  return kExitOk;
}

int run_task(const ClusterFolder& folder, const ClusterArguments& options) {
  const auto shard = parse_whole_number<std::size_t>(options.task);
  if (!shard) throw InputError("give the number of a shard: mwt cluster task FOLDER SHARD");
  switch (run_shard_task(folder, Catalogue::built_in(), *shard, options.only_optima, std::cout)) {
    case TaskEnd::complete: return kExitOk;
    case TaskEnd::stuck: return kExitNegative;
    case TaskEnd::stopped:
    case TaskEnd::requeued: return kExitInterrupted;
  }
  return kExitFailure;
}

int merge(const ClusterFolder& folder) {
  const MergeOutcome outcome = merge_shards(folder, Catalogue::built_in());
  for (const std::string& warning : outcome.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  for (const std::string& contradiction : outcome.contradictions) std::cout << contradiction << '\n';
  std::cout << outcome.runs << " runs of " << folder.settings().shards << " shards joined in " << folder.file("merged")
            << '\n';
  return outcome.contradictions.empty() ? kExitOk : kExitFailure;
}

int cluster(const ClusterArguments& options) {
  static const std::vector<std::string> known = {"submit", "status", "resubmit", "cancel", "task", "merge"};
  if (std::ranges::find(known, options.action) == known.end()) {
    throw InputError("cluster has no action '" + options.action + "'; known: " + joined(known));
  }
  require_only_its_options(options);
  if (options.action == "submit") return submit(options);
  const ClusterFolder folder(options.target);
  if (options.action == "task") return run_task(folder, options);
  if (options.action == "merge") return merge(folder);
  if (options.action == "resubmit") {
    resubmit_study(folder, options.request, std::cout);
  } else if (options.action == "cancel") {
    cancel_study(folder, std::cout);
  } else {
    std::cout << status_text(folder, status_of(folder), output_width());
  }
  return kExitOk;
}

}  // namespace

Command cluster_command() {
  const auto options = std::make_shared<ClusterArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument(
        "action", options->action, one_of("ACTION", {"submit", "status", "resubmit", "cancel", "task", "merge"}),
        "submit: divide a study into shards and submit them; status: how far each is; resubmit: what is missing; "
        "cancel: all that waits or runs; task, merge: what the jobs do, also without Slurm");
    declared.argument("target", options->target, study_kind(),
                      "with submit: a study or a study file; else the folder of a submitted study");
    declared.optional_argument("shard", options->task, kWholeNumber, "with task: the number of the shard to run");
    declared.option("--shards", options->shards, "with submit: into how many parts");
    declared.option("--out", options->folder, kFolder,
                    "with submit: folder for scripts and records; results/STUDY-cluster if not given");
    declared.option("--instances", options->instances, kFolder,
                    "with submit: folder of the study's point files, instead of the study's own");
    declared.flag("--no-cache", options->no_cache,
                  "with submit: seek every optimum anew; neither read nor write the optimum cache");
    declared.flag("--write-only", options->write_only, "with submit: write folder and scripts, but submit nothing");
    declared.flag("--optima", options->only_optima, "with task: seek the optima of the shard, and leave its runs");
    declared.option("--partition", options->request.partition, ValueKind{"PARTITION"},
                    "with submit and resubmit, as those below: partition of the nodes");
    declared.option("--time", options->request.time, ValueKind{"TIME"},
                    "time limit of a task, as sbatch takes it: minutes, or hours:minutes:seconds");
    declared.option("--mem", options->request.memory, ValueKind{"SIZE"},
                    "memory of a task (4G); the study's limit and 512 MB more if not given");
    declared.option("--constraint", options->request.constraint, ValueKind{"FEATURES"},
                    "features of the nodes: times are comparable on nodes of one kind only");
    declared.option("--account", options->request.account, ValueKind{"ACCOUNT"}, "account to charge");
    declared.option("--qos", options->request.qos, ValueKind{"QOS"}, "quality of service");
    declared.flag("--exclusive", options->request.exclusive,
                  "a node per task, so that no other job disturbs the times");
    declared.repeated("--sbatch", options->request.others, ValueKind{"OPTION"},
                      "any other option of sbatch, such as --sbatch=--nice=100; repeatable");
  };
  return {"cluster", "Run a study on a Slurm cluster: submit its shards, see how far they are, go on after failures",
          declare, [options] { return cluster(*options); }};
}

}  // namespace mwt
