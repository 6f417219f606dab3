#include <fmt/core.h>

#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/commands/history_option.h"
#include "harness/cli/file_options.h"
#include "harness/io/output_file.h"
#include "harness/tracking/history/changes.h"
#include "harness/tracking/history/history.h"
#include "harness/tracking/history/history_text.h"

namespace mwt {

namespace {

struct HistoryArguments {
  std::string action;
  std::optional<std::string> history;
  std::optional<std::string> output;
  bool csv = false;
  bool json = false;
  std::optional<double> min_change;
};

std::string changes_text(const std::vector<NightlyRun>& nightly_runs, const std::vector<Change>& changes) {
  if (changes.empty()) return fmt::format("no lasting change; nightly runs in the history: {}\n", nightly_runs.size());
  std::string text;
  for (const Change& change : changes) text += describe(change, nightly_runs) + '\n';
  return text;
}

std::string answer(const HistoryArguments& options) {
  if (options.action != "export" && options.action != "changes" && options.action != "series")
    throw InputError("history has no action '" + options.action + "'; known: export, changes, series");
  if (options.action == "export" && !options.csv) throw InputError("give the form of the export: --csv");
  if (options.action == "series" && !options.json) throw InputError("give the form of the series: --json");
  const std::vector<NightlyRun> nightly_runs =
      History(history_path(options.history), History::Mode::read).nightly_runs();
  if (options.action == "export") return history_csv(nightly_runs);
  ChangeOptions change_options;
  if (options.min_change) change_options.min_change = *options.min_change / 100;
  const std::vector<Change> changes = find_changes(nightly_runs, change_options);
  if (options.action == "series") return series_json(changes, nightly_runs);
  return options.json ? changes_json(changes, nightly_runs) : changes_text(nightly_runs, changes);
}

int history(const HistoryArguments& options) {
  if (options.output) {
    const OutputOption output{"--output", *options.output};
    require_usable_outputs({&output, 1}, {history_path(options.history)});
  }
  const std::string text = answer(options);
  if (options.output) {
    write_file_atomically(*options.output, text);
  } else {
    std::cout << text;
  }
  return kExitOk;
}

}  // namespace

Command history_command() {
  const auto options = std::make_shared<HistoryArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument(
        "action", options->action, one_of("ACTION", {"export", "changes", "series"}),
        "export: all values; changes: which measures changed, when, by how much; series: both, for a dashboard");
    declared.option("--history", options->history, kFile, kHistoryHelp);
    declared.option("-o,--output", options->output, kFile, "write to this file instead of standard output");
    declared.flag("--csv", options->csv, "with export: CSV, one row per nightly run, cell and measure");
    declared.flag("--json", options->json, "with changes and series: print JSON");
    declared.positive("--min-change", options->min_change,
                      "with changes: smallest step of times and memory to report, in percent; 3 if not given");
  };
  return {"history", "Export the history, or find what changed in it", declare,
          [options] { return history(*options); }};
}

}  // namespace mwt
