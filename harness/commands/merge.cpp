#include <iostream>
#include <memory>

#include "harness/commands/commands.h"
#include "harness/study/merge.h"

namespace mwt {

Command merge_command() {
  const auto options = std::make_shared<MergeOptions>();
  const auto declare = [options](CommandOptions& declared) {
    declared.arguments("folders", options->folders, "results folders of all shards of one study");
    declared.required("-o,--out", options->target, "folder for the joined records");
    declared.option("--instances", options->instance_folder, "folder of the study's point files, if it has any");
    declared.flag("--accept-other-build", options->accepts_other_build,
                  "join shards although they come from different commits of mwt");
  };
  const auto run = [options] {
    const std::size_t runs = merge_results(*options, Catalogue::built_in());
    std::cout << runs << " runs of " << options->folders.size() << " folders joined in " << options->target << '\n';
    return static_cast<int>(kExitOk);
  };
  return {"merge", "Join the shards of a study, run apart with --shard", declare, run};
}

}  // namespace mwt
