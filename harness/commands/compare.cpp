#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "geometry/error.h"
#include "harness/catalogue.h"
#include "harness/commands/commands.h"
#include "harness/tracking/comparison.h"
#include "harness/tracking/comparison_text.h"
#include "harness/tracking/interleaved_builds.h"

namespace mwt {

namespace {

struct Options {
  std::vector<std::string> folders;
  std::optional<std::string> build_a;
  std::optional<std::string> build_b;
  std::optional<std::string> study;
  std::vector<std::string> algorithms;
  std::optional<std::string> folder;
  int repetitions = 20;
  std::uint64_t seed = 1;
  std::optional<double> threshold;
  std::optional<std::string> measure;
  bool paired = false;
  bool force = false;
  bool json = false;
  bool markdown = false;
  bool every_cell = false;
};

CompareOptions compare_options(const Options& options) {
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

std::string text_of(const Comparison& comparison, const Options& options) {
  if (options.json) return comparison_json(comparison);
  if (options.markdown) return comparison_markdown(comparison, options.every_cell);
  return comparison_text(comparison, options.every_cell);
}

int tell(const Comparison& comparison, const Options& options) {
  std::cout << text_of(comparison, options);
  return comparison.has_regression() ? kExitNegative : kExitOk;
}

Comparison compare_folders(const Options& options) {
  if (options.folders.size() != 2) throw InputError("compare takes two folders: BASE NEW (or --build-a and --build-b)");
  return compare(read_results(options.folders[0]), read_results(options.folders[1]), compare_options(options));
}

/// Nothing if interrupted. Progress goes to standard error: standard output is for the verdict.
std::optional<Comparison> compare_builds(const Options& options, const std::vector<std::string>& algorithms) {
  const Study study = read_study(find_study_file(*options.study));
  InterleavedOptions interleaved;
  interleaved.build_a = *options.build_a;
  interleaved.build_b = *options.build_b;
  interleaved.folder = options.folder.value_or("results/compare-" + study.name);
  interleaved.algorithms = algorithms;
  interleaved.repetitions = options.repetitions;
  interleaved.seed = options.seed;
  interleaved.is_terminal = isatty(STDERR_FILENO) == 1;
  if (!run_interleaved(study, Catalogue::built_in(), interleaved, std::cerr)) return std::nullopt;
  CompareOptions how = compare_options(options);
  how.paired = true;
  const std::filesystem::path folder(interleaved.folder);
  return compare(read_results((folder / "base").string()), read_results((folder / "new").string()), how);
}

/// Folders first; what they show to be slower is run again by both builds in turn, and only what is slower then, too,
/// counts.
int confirm(const Options& options) {
  const Comparison suspected = compare_folders(options);
  const std::vector<std::string> suspects = suspected.slower_algorithms();
  if (suspects.empty()) return tell(suspected, options);
  const std::optional<Comparison> confirmed = compare_builds(options, suspects);
  if (!confirmed) return kExitInterrupted;
  const bool regressed = suspected.has_exact_regression() || confirmed->has_regression();
  if (options.json) {
    std::cout << "{\"regression\": " << (regressed ? "true" : "false")
              << ",\n\"suspected\": " << text_of(suspected, options)
              << ",\n\"confirmed\": " << text_of(*confirmed, options) << "}\n";
  } else {
    std::cout << text_of(suspected, options) << "\nrun again by both builds in turn, to be sure of the times:\n\n"
              << text_of(*confirmed, options);
  }
  return regressed ? kExitNegative : kExitOk;
}

int run(const Options& options) {
  if (options.json && options.markdown) throw InputError("give --json or --markdown, not both");
  if (!options.build_a && !options.build_b) return tell(compare_folders(options), options);
  if (!options.build_a || !options.build_b) throw InputError("--build-a and --build-b belong together");
  if (!options.study) throw InputError("give --study: what the two builds are to run");
  if (!options.folders.empty()) return confirm(options);
  const std::optional<Comparison> comparison = compare_builds(options, options.algorithms);
  return comparison ? tell(*comparison, options) : kExitInterrupted;
}

}  // namespace

Command compare_command() {
  const auto options = std::make_shared<Options>();
  const auto declare = [options](CommandOptions& declared) {
    declared.optional_arguments("dir", options->folders, "BASE NEW: two folders of results");
    declared.option(
        "--build-a", options->build_a,
        "run two builds in turn; this one's folder is the base. With BASE NEW: only what looks slower there");
    declared.option("--build-b", options->build_b, "the new build's folder");
    declared.option("--study", options->study, "with builds: the study that they run");
    declared.repeated("--algorithm", options->algorithms, "with builds: only this one of the study's algorithms");
    declared.option("--out", options->folder,
                    "with builds: folder for the results; results/compare-STUDY if not given");
    declared.positive("--repetitions", options->repetitions, "with builds: pairs of runs of every cell");
    declared.option("--seed", options->seed, "with builds: of the random order");
    declared.positive("--threshold", options->threshold,
                      "smaller differences count for nothing, in percent; 5 if not given");
    declared.option("--measure", options->measure, "relative_time, wall_time_s or cpu_time_s");
    declared.flag("--paired", options->paired, "the folders come from --build-a and --build-b");
    declared.flag("--force", options->force, "compare times of different machines and of identical binaries, too");
    declared.flag("--json", options->json, "print one JSON object");
    declared.flag("--markdown", options->markdown, "print Markdown");
    declared.flag("--all", options->every_cell, "list the times of every cell");
  };
  return {"compare", "Compare two results, or two builds run in turn; exit 1 on a regression", declare,
          [options] { return run(*options); }};
}

}  // namespace mwt
