#include <iostream>
#include <memory>

#include "harness/cli/commands/commands.h"
#include "harness/study/merge.h"

namespace mwt {

Command merge_command() {
  const auto options = std::make_shared<MergeOptions>();
  const auto declare = [options](CommandOptions& declared) {
    declared.arguments("folders", options->folders, kFolder, "results folders of all shards of one study");
    declared.required("-o,--out", options->target, kFolder, "folder for the joined records");
    declared.option("--instances", options->instance_folder, kFolder,
                    "folder of the study's point files, if it has any");
    declared.option("--study", options->study_path, kFile,
                    "the study file, if commands or start files that it names count from its folder");
    declared.flag("--accept-other-build", options->accepts_other_build,
                  "join shards although they come from different commits of mwt");
  };
  const auto run = [options] {
    const MergeOutcome outcome = merge_results(*options, Catalogue::built_in());
    for (const std::string& warning : outcome.warnings) std::cerr << "mwt: warning: " << warning << '\n';
    for (const std::string& contradiction : outcome.contradictions) std::cout << contradiction << '\n';
    std::cout << outcome.runs << " runs of " << options->folders.size() << " folders joined in " << options->target
              << '\n';
    return static_cast<int>(outcome.contradictions.empty() ? kExitOk : kExitFailure);
  };
  return {"merge", "Join the shards of a study, run apart with --shard", declare, run};
}

}  // namespace mwt
