#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/commands/history_option.h"
#include "harness/tracking/history/history.h"
#include "harness/tracking/result_set.h"

namespace mwt {

namespace {

struct TrackArguments {
  std::vector<std::string> folders;
  std::optional<std::string> history;
};

std::string word_for(History::Added added) {
  switch (added) {
    case History::Added::as_new: return "added";
    case History::Added::as_another: return "added beside older ones: the study file or the program differs";
    case History::Added::unchanged: return "already in the history";
    case History::Added::replaced: return "replace older ones";
    case History::Added::outdated: return "left out: the history has newer ones";
  }
  return "";
}

// All folders are read before the first one is added: a mistake in one leaves the history as it was.
int track(const TrackArguments& options) {
  std::vector<NightlyRun> nightly_runs;
  for (const std::string& folder : options.folders) {
    for (NightlyRun& nightly_run : nightly_runs_of(read_results(folder)))
      nightly_runs.push_back(std::move(nightly_run));
  }
  if (nightly_runs.empty()) throw InputError(options.folders.front() + ": has no runs");
  make_folder_of(history_path(options.history));
  History history(history_path(options.history), History::Mode::write);
  for (const NightlyRun& nightly_run : nightly_runs) {
    const History::Added added = history.add(nightly_run);
    std::cout << nightly_run.study << ' ' << nightly_run.git_commit << " on " << nightly_run.machine << ": "
              << nightly_run.values.size() << " values " << word_for(added) << '\n';
  }
  return kExitOk;
}

}  // namespace

Command track_command() {
  const auto options = std::make_shared<TrackArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.arguments("dir", options->folders, kFolder, "folders of results, of any schema version");
    declared.option("--history", options->history, kFile, kHistoryHelp);
  };
  return {"track", "Append a study's medians to the history", declare, [options] { return track(*options); }};
}

}  // namespace mwt
