#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/io/output_file.h"
#include "harness/run/catalogue.h"
#include "harness/tracking/algorithms/algorithm_pair.h"
#include "harness/tracking/algorithms/algorithm_pair_text.h"
#include "harness/tracking/comparison/comparison.h"
#include "harness/tracking/comparison/comparison_text.h"
#include "harness/tracking/comparison/interleaved_builds.h"
#include "harness/tracking/comparison/settle.h"

namespace mwt {

namespace {

struct CompareArguments {
  std::vector<std::string> folders;
  std::optional<std::string> build_a;
  std::optional<std::string> build_b;
  std::optional<std::string> study;
  std::optional<std::string> algorithm_a;
  std::optional<std::string> algorithm_b;
  std::vector<std::string> algorithms;
  std::optional<std::string> folder;
  std::optional<std::string> verdict;
  int repetitions = 20;
  std::optional<double> budget_s;
  std::uint64_t seed = 1;
  std::optional<double> threshold;
  std::optional<std::string> measure;
  bool paired = false;
  bool force = false;
  bool json = false;
  bool markdown = false;
  bool every_cell = false;
};

CompareOptions compare_options(const CompareArguments& options) {
  CompareOptions result;
  if (options.threshold) result.threshold = *options.threshold / 100;
  result.time_measure = options.measure;
  if (options.measure && measure_named(*options.measure).aspect != Aspect::time)
    throw InputError("--measure " + *options.measure +
                     " is not a time; times are relative_time, wall_time_s, cpu_time_s");
  result.paired = options.paired;
  result.force = options.force;
  return result;
}

std::string json_of(const Comparison& comparison) { return comparison_json(comparison); }
std::string json_of(const Settled& settled) { return settled_json(settled); }

std::string text_of(const Comparison& comparison, const CompareArguments& options) {
  return options.markdown ? comparison_markdown(comparison, options.every_cell)
                          : comparison_text(comparison, options.every_cell);
}

std::string text_of(const Settled& settled, const CompareArguments& options) {
  return options.markdown ? settled_markdown(settled, options.every_cell) : settled_text(settled, options.every_cell);
}

template <class Result>
int print_verdict(const Result& result, const CompareArguments& options) {
  std::cout << (options.json ? json_of(result) : text_of(result, options));
  if (options.verdict) write_file_atomically(*options.verdict, json_of(result));
  return result.outcome() == Outcome::regression ? kExitNegative : kExitOk;
}

Comparison compare_folders(const CompareArguments& options) {
  if (options.folders.size() != 2) throw InputError("compare takes two folders: BASE NEW (or --build-a and --build-b)");
  return compare(read_results(options.folders[0]), read_results(options.folders[1]), compare_options(options));
}

/// Both builds, ready to be run in turn. Progress goes to standard error: standard output is for the verdict.
InterleavedBuilds make_builds(const CompareArguments& options, const Study& study, bool with_counts) {
  InterleavedOptions interleaved;
  interleaved.build_a = *options.build_a;
  interleaved.build_b = *options.build_b;
  interleaved.folder = options.folder.value_or("results/compare-" + study.name);
  interleaved.algorithms = options.algorithms;
  interleaved.seed = options.seed;
  interleaved.budget_s = options.budget_s;
  interleaved.with_counts = with_counts;
  interleaved.is_terminal = isatty(STDERR_FILENO) == 1;
  return {study, Catalogue::built_in(), interleaved, std::cerr};
}

int compare_builds(const CompareArguments& options) {
  InterleavedBuilds builds = make_builds(options, read_study(find_study_file(*options.study)), true);
  if (!builds.run(builds.cells(), options.repetitions)) return kExitInterrupted;
  CompareOptions how = compare_options(options);
  how.paired = true;
  return print_verdict(compare(read_results(builds.base_folder()), read_results(builds.new_folder()), how), options);
}

bool has_counts(const std::string& folder) {
  return std::ranges::any_of(read_results(folder).runs,
                             [](const RunRecord& run) { return run.callgrind_instructions.has_value(); });
}

/// Folders first; what they leave open is run by both builds in turn, and these results count.
int compare_and_settle(const CompareArguments& options) {
  Settled settled{compare_folders(options), std::nullopt, {}};
  std::set<TrackedCell> open = settled.folders.open_cells();
  if (open.empty()) return print_verdict(settled, options);
  // A base without counts may be of a build that does not know how to count.
  const bool with_counts = has_counts(options.folders[0]) && has_counts(options.folders[1]);
  InterleavedBuilds builds = make_builds(options, read_study(find_study_file(*options.study)), with_counts);
  const std::set<TrackedCell> known = builds.cells();
  std::set_difference(open.begin(), open.end(), known.begin(), known.end(),
                      std::inserter(settled.not_run, settled.not_run.end()));
  std::erase_if(open, [&](const TrackedCell& cell) { return !known.contains(cell); });
  if (!open.empty()) {
    settled.in_turn = settle(open, builds, options.repetitions, compare_options(options));
    if (!settled.in_turn) return kExitInterrupted;
  }
  return print_verdict(settled, options);
}

/// Two algorithms of one folder. What is for builds would do nothing here.
int compare_two_algorithms(const CompareArguments& options) {
  if (!options.algorithm_a || !options.algorithm_b) throw InputError("--algorithm-a and --algorithm-b belong together");
  if (options.folders.size() != 1) throw InputError("with --algorithm-a and --algorithm-b give one folder of results");
  const bool has_builds = options.build_a || options.build_b || options.study || options.folder || options.budget_s;
  if (has_builds || options.threshold || options.paired || options.force || options.every_cell)
    throw InputError(
        "--algorithm-a and --algorithm-b compare algorithms, not builds: of the other options they take --measure, "
        "--json, --markdown and --verdict");
  const AlgorithmPair pair = compare_algorithms(read_results(options.folders.front()),
                                                {*options.algorithm_a, *options.algorithm_b, options.measure});
  std::cout << (options.json       ? algorithm_pair_json(pair)
                : options.markdown ? algorithm_pair_markdown(pair)
                                   : algorithm_pair_text(pair));
  if (options.verdict) write_file_atomically(*options.verdict, algorithm_pair_json(pair));
  return kExitOk;
}

int run(const CompareArguments& options) {
  if (options.json && options.markdown) throw InputError("give --json or --markdown, not both");
  if (options.algorithm_a || options.algorithm_b) return compare_two_algorithms(options);
  if (!options.build_a && !options.build_b) return print_verdict(compare_folders(options), options);
  if (!options.build_a || !options.build_b) throw InputError("--build-a and --build-b belong together");
  if (!options.study) throw InputError("give --study: the study that the two builds run");
  return options.folders.empty() ? compare_builds(options) : compare_and_settle(options);
}

}  // namespace

Command compare_command() {
  const auto options = std::make_shared<CompareArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.optional_arguments("dir", options->folders, kFolder,
                                "BASE NEW: two folders of results; one folder with --algorithm-a and --algorithm-b");
    declared.option("--build-a", options->build_a, kFolder,
                    "folder of the base build; runs both builds in turn. With BASE NEW: only what these leave open");
    declared.option("--build-b", options->build_b, kFolder, "folder of the new build");
    declared.option("--study", options->study, study_kind(), "with builds: the study to run");
    declared.option("--algorithm-a", options->algorithm_a, algorithm_kind(),
                    "compare two algorithms of one folder, paired by instance: the first, with parameters if need be");
    declared.option("--algorithm-b", options->algorithm_b, algorithm_kind(), "the second");
    declared.repeated("--algorithm", options->algorithms, algorithm_kind(),
                      "with builds: run only this algorithm of the study; may be repeated");
    declared.option("--out", options->folder, kFolder,
                    "with builds: folder for the results; results/compare-STUDY if not given");
    declared.positive("--repetitions", options->repetitions,
                      "with builds: pairs of runs per cell; with BASE NEW up to three times as many for unclear cells");
    declared.positive("--budget", options->budget_s, "with builds: start no repetition after this many seconds");
    declared.option("--seed", options->seed, "with builds: seed of the random order");
    declared.positive("--threshold", options->threshold, "smallest difference that counts, in percent; 5 if not given");
    declared.option("--measure", options->measure, one_of("MEASURE", {"relative_time", "wall_time_s", "cpu_time_s"}),
                    "time to compare: relative_time, wall_time_s or cpu_time_s");
    declared.flag("--paired", options->paired, "the folders come from --build-a and --build-b");
    declared.flag("--force", options->force, "compare times of different machines and of identical binaries, too");
    declared.flag("--json", options->json, "print one JSON object");
    declared.flag("--markdown", options->markdown, "print Markdown");
    declared.option("--verdict", options->verdict, kFile, "also write the JSON object to this file");
    declared.flag("--all", options->every_cell, "list the times of every cell");
  };
  return {"compare", "Compare two results, two builds run in turn (exit 1 on a regression), or two algorithms", declare,
          [options] { return run(*options); }};
}

}  // namespace mwt
