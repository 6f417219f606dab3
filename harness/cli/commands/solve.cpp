#include <fmt/core.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "algorithms/proof_trace.h"
#include "base/error.h"
#include "base/number_text.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/cli/json_output.h"
#include "harness/cli/solve_output.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/points/point_file.h"
#include "harness/io/proof_file.h"
#include "harness/io/svg.h"
#include "harness/io/text/text.h"
#include "harness/io/triangulation_file.h"
#include "harness/rating/optimum_cache.h"
#include "harness/rating/optimum_claims.h"
#include "harness/rating/optimum_search.h"
#include "harness/rating/quality.h"
#include "harness/rating/rated_run.h"
#include "harness/run/catalogue.h"
#include "harness/run/command/command.h"
#include "harness/run/execution.h"
#include "harness/run/max_workers.h"
#include "harness/run/start_triangulation.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

struct SolveArguments {
  std::string points;
  std::string algorithm;
  std::optional<std::string> commands;
  std::optional<std::string> columns;
  std::vector<std::string> parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<double> time_limit_s;
  bool with_optimum = false;
  bool no_cache = false;
  bool json = false;
  std::optional<std::string> triangles;
  std::optional<std::string> edges;
  std::optional<std::string> svg;
  std::optional<std::string> proof;
};

Request make_request(const SolveArguments& options, const AlgorithmInfo& algorithm, const Instance& instance,
                     const std::vector<Point>& input) {
  Request request;
  request.algorithm = &algorithm;
  const AlgorithmInfo& info = *request.algorithm;
  request.parameters = Parameters(info.name, info.parameters, parse_parameters(options.parameters));
  request.seed = options.seed;
  request.threads = options.threads;
  request.time_limit_s = options.time_limit_s;
  if (const auto file = start_file_of(info, request.parameters))
    request.start = read_triangulation(*file, instance.set, input);
  return request;
}

void warn(const std::string& warning) { std::cerr << "mwt: warning: " << warning << '\n'; }

// The optimum from the cache or the exact algorithms, each in a process of its own.
FoundOptimum search_optimum(const Instance& instance, std::vector<const AlgorithmInfo*> sources,
                            const RunLimits& limits, OptimumCache* cache, const KnownWeight& known) {
  FoundOptimum result;
  ProcessPool pool(1);
  seek_optimum(pool, {std::make_shared<const Instance>(instance), std::move(sources), limits, cache, known},
               [&](const FoundOptimum& found) { result = found; });
  while (!pool.is_empty()) pool.wait(std::chrono::milliseconds(200));
  return result;
}

std::optional<OptimumCache> open_cache(const SolveArguments& options) {
  if (options.no_cache) return std::nullopt;
  return OptimumCache(optimum_cache_folder(), warn);
}

FoundOptimum cached(const CachedOptimum& earlier, const AlgorithmInfo& solver) {
  FoundOptimum found;
  found.interval = earlier.interval;
  found.source = solver.name;
  found.is_cached = true;
  return found;
}

// What the cache has of the same solver; nothing if this solution disproves it, which removes it from the cache.
std::optional<CachedOptimum> cached_of(OptimumCache& cache, const Instance& instance, const OptimumKey& key,
                                       const Interval& weight) {
  std::optional<CachedOptimum> earlier = cache.find(key);
  if (!earlier || earlier->interval.lower <= weight.upper) return earlier;
  const OptimumClaim claim{"", cached_claimant(key.solver), earlier->interval};
  warn(Disproof{claim, "this solution", weight.upper}.text() + "; it is removed from the cache");
  static_cast<void>(cache.discard_disproved(instance.id, weight.upper));
  return std::nullopt;
}

// What is known besides what the solution itself certifies. If that is the optimum, nothing more is sought, and it goes
// into the cache; and an exact algorithm that did not prove it is not run again.
FoundOptimum optimum_beyond(const Catalogue& catalogue, const Instance& instance, const Request& request,
                            const RatedRun& run, const SolveArguments& options) {
  std::optional<OptimumCache> cache = open_cache(options);
  const AlgorithmInfo& solver = *request.algorithm;
  const OptimumKey key = optimum_key(instance.id, solver, request.parameters);
  const Interval weight{run.weight_lower.value(), run.weight_upper.value()};
  const auto earlier = cache ? cached_of(*cache, instance, key, weight) : std::nullopt;
  if (run.certified_lower) {
    const Interval own{*run.certified_lower, weight.upper};
    if (optimality_of(own) == Optimality::proved) {
      if (earlier && !overlap(earlier->interval, own)) return cached(*earlier, solver);  // rate_by_all() reports it
      if (cache && solver.exactness == Exactness::exact) cache->store(key, {own, run.wall_time_s.value()});
      return {};
    }
  }
  if (earlier) return cached(*earlier, solver);
  RunLimits limits;
  limits.time_s = options.time_limit_s.value_or(limits.time_s);
  const auto n = static_cast<Index>(instance.set.points.size());
  auto sources = optimum_sources_for(catalogue, {}, n, instance.hull_size == n);
  std::erase(sources, &solver);
  return search_optimum(instance, std::move(sources), limits, cache ? &*cache : nullptr,
                        {"this solution", weight.upper});
}

SolveOutput describe(const Request& request, const Instance& instance, RatedRun run) {
  SolveOutput output;
  output.algorithm = request.algorithm->name;
  output.parameters = request.parameters.all();
  output.seed = request.seed;
  output.threads = request.threads;
  output.n = instance.set.input_count;
  output.distinct = static_cast<Index>(instance.set.points.size());
  output.duplicates = instance.set.duplicates();
  output.hull_size = instance.hull_size;
  output.run = std::move(run);
  return output;
}

// Rates the run by what it certifies and what was found besides. Returns the claims that triangulations disprove:
// failures of this program.
std::vector<std::string> rate_by_all(RatedRun& run, const std::string& algorithm, const FoundOptimum& found) {
  std::vector<std::string> contradictions = found.contradictions;
  OptimumClaims claims;
  const auto add = [&](const std::vector<Disproof>& disproofs) {
    for (const Disproof& disproof : disproofs) contradictions.push_back(disproof.text());
  };
  if (found.interval) {
    const std::string source = found.is_cached ? cached_claimant(found.source) : found.source;
    add(claims.add_claim({"", source, *found.interval}));
  }
  if (is_disproved(run)) {
    contradictions.push_back(run.message);
    run.status = RunStatus::ok;  // the triangulation is valid all the same
    run.certified_lower.reset();
  }
  add(add_run(claims, "", algorithm, run));
  rate(run, claims.bounds());
  return contradictions;
}

std::vector<OutputOption> outputs_of(const SolveArguments& options) {
  std::vector<OutputOption> outputs;
  for (const auto& [name, file] : {std::pair("--triangles", options.triangles),
                                   {"--edges", options.edges},
                                   {"--svg", options.svg},
                                   {"--proof", options.proof}}) {
    if (file) outputs.push_back({name, *file});
  }
  return outputs;
}

void require_proof(const std::string& path, const AlgorithmInfo& algorithm) {
  if (is_standard_output(path)) throw InputError("--proof: proofs are binary; give a file, such as points.mwtproof");
  if (!algorithm.has_proofs)
    throw InputError(
        fmt::format("--proof: {} writes no proofs; exact is one of the algorithms that do", algorithm.name));
}

// Everything that can be wrong about them, before an hour of work is lost to it.
void require_usable_outputs(const SolveArguments& options, const Request& request) {
  const std::vector<OutputOption> outputs = outputs_of(options);
  std::vector<std::string> inputs = {options.points};
  if (const auto start = start_file_of(*request.algorithm, request.parameters)) inputs.push_back(*start);
  require_usable_outputs(outputs, inputs);
  for (const auto& table : {options.triangles, options.edges}) {
    if (table) require_table_name(*table);
  }
  if (options.svg) require_picture_name(*options.svg);
  if (options.proof) require_proof(*options.proof, *request.algorithm);
  const auto streamed = output_to_standard_output(outputs);
  if (streamed && options.json)
    throw InputError("--json and " + streamed->option + " both go to standard output; give " + streamed->option +
                     " a file");
}

void write_files(const SolveArguments& options, const Instance& instance, const std::vector<Point>& input,
                 const Triangulation& triangulation) {
  const Triangulation in_input{instance.set.input_count, to_input_indices(instance.set, triangulation.triangles)};
  if (options.triangles) write_triangles(*options.triangles, in_input.triangles);
  if (options.edges) write_edges(*options.edges, edges_of(in_input));
  if (options.svg) write_svg(*options.svg, input, in_input);
}

// Warns if the file proves less than the solver certifies: a part may have been too large for a proof.
void write_proof_file(const std::string& path, const Instance& instance, const ProofTrace& trace,
                      const Solution& solution) {
  if (!trace.is_complete || !solution.optimum)
    throw InputError("--proof: with these parameters the algorithm proves nothing");
  const Interval claim = write_proof(path, instance.set.points, trace, solution.triangulation, *solution.optimum);
  if (claim.lower < solution.optimum->lower * (1 - kProvedRelativeWidth))
    warn(fmt::format("{} proves only that the optimum is at least {}", path, number_text(claim.lower)));
}

// Standard output is for the file if one goes there.
void print(const SolveArguments& options, const SolveOutput& output) {
  std::ostream& out = output_to_standard_output(outputs_of(options)) ? std::cerr : std::cout;
  out << (options.json ? to_json(output) : readable_text(output));
}

int solve(const SolveArguments& options) {
  const Catalogue catalogue = Catalogue::built_in();
  const std::vector<StudyCommand> commands = read_commands(options.commands);
  const AlgorithmInfo& algorithm = algorithm_named(options.algorithm, commands, catalogue);
  const std::vector<Point> input = read_points(options.points, column_names(options.columns));
  const Instance instance = make_instance(input, source_name(options.points));
  Request request = make_request(options, algorithm, instance, input);
  ProofTrace trace;
  if (options.proof) request.proof = &trace;
  require_usable_outputs(options, request);
  const Execution execution = execute_once(request, instance.set.points);
  SolveOutput output = describe(request, instance, judged(*request.algorithm, instance.set.points, execution));
  RatedRun& run = output.run;
  if (run.status == RunStatus::invalid_output) {
    print(options, output);
    if (algorithm.runs_outside) throw CommandFailure(run.status, run.message);
    throw std::logic_error(output.algorithm + " returned no triangulation: " + run.message);
  }
  FoundOptimum found;
  if (options.with_optimum) found = optimum_beyond(catalogue, instance, request, run, options);
  for (const std::string& warning : found.warnings) warn(warning);
  output.optimum_cached = found.is_cached;
  const std::vector<std::string> contradictions = rate_by_all(run, output.algorithm, found);
  write_files(options, instance, input, execution.solution.triangulation);
  if (options.proof) write_proof_file(*options.proof, instance, trace, execution.solution);
  print(options, output);
  if (run.status == RunStatus::error && algorithm.runs_outside) throw CommandFailure(run.status, run.message);
  if (!contradictions.empty()) throw std::logic_error(joined(contradictions, "; "));
  return kExitOk;
}

void declare(CommandOptions& declared, SolveArguments& options) {
  declared.argument("points", options.points, kFile, "point file; - for stdin");
  declared.required("--algorithm", options.algorithm, algorithm_kind(), "name of an algorithm (mwt list algorithms)");
  declared.option("--commands", options.commands, kFile,
                  "study file (TOML) whose commands --algorithm may name, too: programs of your own");
  declared.repeated("--param", options.parameters, ValueKind{"NAME=VALUE"},
                    "a parameter of the algorithm, k=v; may be repeated");
  declare_columns(declared, options.columns);
  declared.option("--seed", options.seed, "seed of the pseudo-random numbers");
  declared.positive("--threads", options.threads, "threads that the algorithm may use", kMaxWorkers);
  declared.positive("--time-limit", options.time_limit_s, "return the best result found within this many seconds");
  declared.flag("--with-optimum", options.with_optimum, "also seek the proved optimum and compute alpha");
  declared.flag("--no-cache", options.no_cache, "seek that optimum anew; neither read nor write the optimum cache");
  declared.flag("--json", options.json, "print one JSON object");
  declared.option(
      "--triangles", options.triangles, kFile,
      "write the triangles (a,b,c per line; positions in the point file); with - for this or the next two, the "
      "summary goes to standard error");
  declared.option("--edges", options.edges, kFile, "write the edges (a,b per line)");
  declared.option("--svg", options.svg, kFile, "write a picture (.svg)");
  declared.option("--proof", options.proof, kFile, "write a proof of the optimum for mwt_verify (.mwtproof)");
}

}  // namespace

Command solve_command() {
  const auto options = std::make_shared<SolveArguments>();
  return {"solve", "Triangulate your own points with one algorithm and say how good the result is",
          [options](CommandOptions& declared) { declare(declared, *options); }, [options] { return solve(*options); }};
}

}  // namespace mwt
