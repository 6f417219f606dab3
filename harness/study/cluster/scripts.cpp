#include "harness/study/cluster/scripts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace mwt {

namespace {

constexpr std::uint64_t kOwnMemoryMb = 512;  // of mwt itself: points, the plan
constexpr int kLeadTime = 60;                // s; a task stops within one

void require_plain(const std::string& folder) {
  const bool is_plain = std::ranges::all_of(folder, [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("/._+-=,@:~ ").find(static_cast<char>(c)) != std::string::npos;
  });
  if (!is_plain) {
    throw InputError(folder +
                     ": the path of the folder must consist of ASCII letters, digits, blanks and /._+-=,@:~ for "
                     "Slurm's scripts; choose another with --out");
  }
}

const char* purpose_of(JobKind kind) {
  switch (kind) {
    case JobKind::optima: return "seeks the optima of one shard per task";
    case JobKind::runs: return "runs one shard per task; it begins when the shard's optima are there";
    case JobKind::merge: return "joins the records of all shards and reports on them";
  }
  return "";
}

std::string commands_of(JobKind kind, const std::string& folder) {
  const std::string program = fmt::format("\"{}/mwt\"", folder);
  switch (kind) {
    case JobKind::optima:
      return fmt::format("exec {} cluster task \"{}\" \"$SLURM_ARRAY_TASK_ID\" --optima\n", program, folder);
    case JobKind::runs: return fmt::format("exec {} cluster task \"{}\" \"$SLURM_ARRAY_TASK_ID\"\n", program, folder);
    case JobKind::merge:
      return fmt::format(
          "{0} cluster merge \"{1}\" &&\n  {0} report \"{1}/merged\" --tables \"{1}/merged/tables.txt\"\n", program,
          folder);
  }
  return "";
}

// Beginning with the memory: what others set later wins.
std::vector<std::string> options_of(JobKind kind, const std::string& folder, const Study& study,
                                    const SlurmRequest& request) {
  const bool is_array = kind != JobKind::merge;
  std::vector<std::string> options = {
      fmt::format("--job-name=mwt-{}-{}", study.name, to_text(kind)),
      fmt::format("--output=\"{}/logs/{}{}.log\"", folder, to_text(kind), is_array ? "-%a" : ""),
      "--open-mode=append",
      "--requeue",
  };
  if (!is_array) {
    SlurmRequest of_merge = request;
    of_merge.exclusive = false;
    for (const std::string& word : of_merge.words()) options.push_back(word);
    return options;
  }
  // Stops a task cleanly before its time limit; it queues itself again and goes on.
  options.push_back(fmt::format("--signal=B:USR1@{}", kLeadTime));
  if (kind == JobKind::runs) options.emplace_back("--kill-on-invalid-dep=yes");
  options.push_back(fmt::format("--cpus-per-task={}", study.threads));
  const std::uint64_t bytes = std::max(study.limits.memory_bytes, study.optimum_limits.memory_bytes);
  options.push_back(fmt::format("--mem={}M", (bytes >> 20) + kOwnMemoryMb));
  for (const std::string& word : request.words()) options.push_back(word);
  return options;
}

}  // namespace

std::string script_name(JobKind kind) { return to_text(kind) + ".sbatch"; }

std::string script_text(JobKind kind, const std::string& folder, const Study& study, const SlurmRequest& request) {
  require_plain(folder);
  std::string text = fmt::format(
      "#!/bin/bash\n# Study {}: {}.\n# Written by mwt cluster submit; mwt cluster resubmit submits it again.\n",
      study.name, purpose_of(kind));
  for (const std::string& option : options_of(kind, folder, study, request)) text += "#SBATCH " + option + '\n';
  return text + commands_of(kind, folder);
}

}  // namespace mwt
