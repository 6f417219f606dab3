#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/cli/commands/commands.h"
#include "harness/hunt/hunt.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"
#include "harness/run/catalogue.h"
#include "harness/run/max_workers.h"
#include "harness/run/start_triangulation.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

struct HuntArguments {
  std::string algorithm;
  std::optional<std::string> commands;
  std::optional<Index> n;
  std::vector<std::string> parameters;
  std::optional<double> budget_s;
  std::uint64_t evaluations = 0;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<std::string> solver;
  std::optional<std::string> output;
  bool resume = false;
};

const AlgorithmInfo& solver_of(const HuntArguments& options, const Catalogue& catalogue, Index n) {
  if (!options.solver) return solver_for_hunt(catalogue, n);
  const AlgorithmInfo& solver = catalogue.algorithm(*options.solver);
  if (solver.exactness != Exactness::exact) throw InputError("--solver " + solver.name + " is not exact");
  return solver;
}

HuntPlan plan_of(const HuntArguments& options, const AlgorithmInfo& algorithm, const Catalogue& catalogue) {
  if (!options.n || *options.n < 4) throw InputError("give --n, the number of points, at least 4");
  HuntPlan plan;
  plan.request.algorithm = &algorithm;
  plan.request.parameters = Parameters(algorithm.name, algorithm.parameters, parse_parameters(options.parameters));
  if (start_file_of(algorithm, plan.request.parameters)) {
    throw InputError("a hunt changes the points, so it cannot start from a given triangulation; choose a named start");
  }
  plan.n = *options.n;
  plan.solver = &solver_of(options, catalogue, plan.n);
  for (const AlgorithmInfo* info : {plan.request.algorithm, plan.solver}) {
    if (info->max_n != 0 && plan.n > info->max_n)
      throw InputError(fmt::format("{} takes at most {} points; give a smaller --n", info->name, info->max_n));
  }
  plan.seed = options.seed;
  plan.climbers = options.threads;
  return plan;
}

std::string output_of(const HuntArguments& options) {
  std::string path = options.output.value_or(fmt::format("hunted_{}_{}.txt", options.algorithm, options.n.value_or(0)));
  if (!path.ends_with(".txt") && !path.ends_with(".xy"))
    throw InputError(path + ": a hunt writes text with comments; give a name that ends in .txt or .xy");
  return path;
}

// Nothing that was there is overwritten unless it is this hunt's.
void require_fresh_or_resumed(const HuntArguments& options, const std::string& output, const std::string& state_file) {
  if (options.resume) return;
  for (const std::string& path : {output, state_file}) {
    if (std::filesystem::exists(path))
      throw InputError(path + " exists; --resume continues that hunt, -o NAME begins another one");
  }
}

// The points are worth more than the hunt: a solver is wrong on them.
[[noreturn]] void fail_with_points(const std::string& output, const HuntPlan& plan, const DisprovedOptimum& failure) {
  const std::string path = output + ".disproof.txt";
  std::string text = plan.identity() + "\n# " + failure.what() + '\n';
  for (const Point& p : failure.points()) text += number_text(p.x) + ' ' + number_text(p.y) + '\n';
  write_file_atomically(path, text);
  throw std::logic_error(std::string(failure.what()) + "; the points are in " + path);
}

void write_instance(const std::string& path, const HuntPlan& plan, const HuntResult& result) {
  std::string text = fmt::format("{}\n# alpha >= {} (certified) after {} evaluations\n", plan.identity(),
                                 number_text(result.worst.alpha), result.evaluations);
  for (const Point& p : result.worst.points) text += number_text(p.x) + ' ' + number_text(p.y) + '\n';
  write_file_atomically(path, text);
}

std::string described(const HuntResult& result) {
  return fmt::format("alpha >= {:.6f} after {} evaluations", result.worst.alpha, result.evaluations);
}

int run_hunt(const HuntArguments& options) {
  const Catalogue catalogue = Catalogue::built_in();
  const std::vector<StudyCommand> commands = read_commands(options.commands);
  const HuntPlan plan = plan_of(options, algorithm_named(options.algorithm, commands, catalogue), catalogue);
  const std::string output = output_of(options);
  const std::string state_file = output + ".state";
  require_fresh_or_resumed(options, output, state_file);
  HuntLimits limits;
  limits.budget_s = options.budget_s.value_or(limits.budget_s);
  if (options.evaluations > 0) limits.evaluations = options.evaluations;
  const auto begin = std::chrono::steady_clock::now();
  const auto has_improved = [&](const HuntResult& better) {
    write_instance(output, plan, better);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    std::cout << fixed(elapsed.count(), 0) << " s: " << described(better) << std::endl;
  };
  HuntResult result;
  try {
    result = hunt(plan, limits, state_file, has_improved);
  } catch (const DisprovedOptimum& failure) {
    fail_with_points(output, plan, failure);
  }
  if (result.worst.points.empty()) throw InputError(fmt::format("no instance of n={} could be rated", plan.n));
  write_instance(output, plan, result);
  std::cout << options.algorithm << " n=" << plan.n << ": " << described(result) << "; written to " << output << '\n';
  return result.interrupted ? kExitInterrupted : kExitOk;
}

}  // namespace

Command hunt_command() {
  const auto options = std::make_shared<HuntArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.required("--algorithm", options->algorithm, algorithm_kind(), "name of the algorithm");
    declared.option("--commands", options->commands, kFile,
                    "study file (TOML) whose commands --algorithm may name, too: programs of your own");
    declared.option("--n", options->n, "number of points, at least 4");
    declared.repeated("--param", options->parameters, ValueKind{"NAME=VALUE"},
                      "a parameter of the algorithm, k=v; may be repeated");
    declared.positive("--budget", options->budget_s, "seconds to search; 60 if not given");
    declared.option("--evaluations", options->evaluations,
                    "stop after so many evaluations per thread, which makes the result repeatable; 0: no limit");
    declared.option("--seed", options->seed, "seed of the search");
    declared.positive("--threads", options->threads, "parallel searches, each with its own random numbers",
                      kMaxWorkers);
    declared.option("--solver", options->solver, algorithm_kind(),
                    "exact algorithm for the optimum; the fastest for this n if not given");
    declared.option("-o,--output", options->output, kFile,
                    "point file (.txt, .xy) for the worst instance; the state of the hunt is written beside it");
    declared.flag("--resume", options->resume, "continue the hunt whose state is beside the output file");
  };
  return {"hunt", "Search for inputs on which an algorithm has a large alpha", declare,
          [options] { return run_hunt(*options); }};
}

}  // namespace mwt
