// The program mwt_benchmark: every algorithm x family under Google Benchmark, with all of its standard flags. Points
// are generated when a benchmark begins.
//
// Three flags of its own: --max_n=10000000, the largest number of points (default: a million); --threads=2, how many
// threads an algorithm may use (default: one); --version. Counters: over_delaunay = median processor time (of several
// threads: wall time) / median of seven Delaunay triangulations of the same points by CGAL, measured in turns with the
// algorithm; stopped_early, 1 if something stopped the algorithm (the label names it), else 0; alpha_lower,
// alpha_upper where an optimum is cheap; instructions, cycles, cache_misses, branch_misses of one execution more, where
// the machine counts them and one thread is allowed; phase_NAME_s, the algorithm's own stages in its last iteration (in
// CSV these are in the column `label`: see csv_reporter.h).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/cpu_clock.h"
#include "base/error.h"
#include "base/given_number.h"
#include "harness/benchmark/csv_reporter.h"
#include "harness/benchmark/prepared_cell.h"
#include "harness/io/exit_code.h"
#include "harness/io/standard_streams.h"
#include "harness/run/machine/build_info.h"
#include "harness/run/machine/event_counts.h"
#include "harness/run/max_workers.h"

namespace mwt {

namespace {

// Google Benchmark calls a benchmark several times until it has enough iterations; the last cell stays prepared.
const PreparedCell& prepared(const Catalogue& catalogue, const BenchmarkCell& cell) {
  static std::string name;
  static std::unique_ptr<PreparedCell> last;
  if (!last || name != cell.name()) {
    last.reset();  // two large instances need not fit at once
    last = std::make_unique<PreparedCell>(prepare(catalogue, cell));
    name = cell.name();
  }
  return *last;
}

// Of one more execution, so that counting is no part of the times; none where the machine counts nothing.
void add_event_counts(benchmark::State& state, const std::function<void()>& execute) {
  EventCounter counter;
  if (!counter.is_counting()) return;
  execute();
  const EventCounts counts = counter.stop();
  for (const auto& [name, count] : {std::pair("instructions", counts.instructions),
                                    {"cycles", counts.cycles},
                                    {"cache_misses", counts.cache_misses},
                                    {"branch_misses", counts.branch_misses}}) {
    if (count) state.counters[name] = static_cast<double>(*count);
  }
}

void time_cell(benchmark::State& state, const Catalogue& catalogue, const BenchmarkCell& benchmark_cell, int threads) {
  const PreparedCell& cell = prepared(catalogue, benchmark_cell);
  if (!cell.reason_to_skip.empty()) {
    state.SkipWithError(cell.reason_to_skip.c_str());
    return;
  }
  const Points points = cell.instance.set.points;
  TimeOverDelaunay times;
  Context context;
  context.parameters = cell.request.parameters;
  context.threads = threads;
  const std::uint64_t every = 1 + static_cast<std::uint64_t>(state.max_iterations) / TimeOverDelaunay::kDelaunayTimes;
  std::optional<StopReason> stop_reason;
  std::uint64_t iteration = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (iteration++ % every == 0) times.measure_delaunay_time(points);
    context.phases.clear();
    state.ResumeTiming();
    const double cpu_start = process_cpu_time_s();
    const auto wall_start = Context::Clock::now();
    Solution solution = benchmark_cell.algorithm->function(points, context);
    const std::chrono::duration<double> wall = Context::Clock::now() - wall_start;
    times.add(threads == 1 ? process_cpu_time_s() - cpu_start : wall.count());
    stop_reason = solution.stop_reason;
    benchmark::DoNotOptimize(solution.triangulation.triangles.data());
  }
  state.counters["over_delaunay"] = times.ratio(points);
  state.counters["stopped_early"] = stop_reason ? 1 : 0;
  if (stop_reason) state.SetLabel("stopped early: " + std::string(phrase_of(*stop_reason)));
  if (cell.run.alpha_upper) {
    state.counters["alpha_lower"] = *cell.run.alpha_lower;
    state.counters["alpha_upper"] = *cell.run.alpha_upper;
  }
  if (threads == 1) add_event_counts(state, [&] { (void)benchmark_cell.algorithm->function(points, context); });
  for (const auto& [phase, seconds] : context.phases) state.counters["phase_" + phase + "_s"] += seconds;
}

// What mwt_benchmark understands besides Google Benchmark's own flags.
struct Flags {
  Index max_n = 1'000'000;
  Index threads = 1;
};

// Takes --max_n=N and --threads=T out of the arguments. Throws InputError: one has no number of its range.
Flags take_flags(int& argument_count, char** arguments) {
  Flags flags;
  int kept = 1;
  for (int i = 1; i < argument_count; ++i) {
    const std::string_view argument = arguments[i];
    Index* number = nullptr;
    for (const auto& [name, value] : {std::pair("--max_n=", &flags.max_n), {"--threads=", &flags.threads}}) {
      if (argument.starts_with(name)) number = value;
    }
    if (number == nullptr) {
      arguments[kept++] = arguments[i];
      continue;
    }
    const std::string_view text = argument.substr(argument.find('=') + 1);
    *number = given_number<Index>(std::string(argument), text,
                                  {1, number == &flags.threads ? Index{kMaxWorkers} : kNoIndex - 1});
  }
  argument_count = kept;
  return flags;
}

// The value of a flag of Google Benchmark: the last one given, else the environment.
std::string value_of_flag(const std::string& name, int argument_count, char** arguments) {
  std::string variable = name;
  for (char& c : variable) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const char* in_environment = std::getenv(variable.c_str());
  std::string value = in_environment == nullptr ? "" : in_environment;
  const std::string start = "--" + name + '=';
  for (const std::string_view argument : std::span(arguments, static_cast<std::size_t>(argument_count))) {
    if (argument.starts_with(start)) value = argument.substr(start.size());
  }
  return value;
}

void register_all(const Catalogue& catalogue, const Flags& flags) {
  const int threads = static_cast<int>(flags.threads);
  for (const BenchmarkCell& cell : benchmark_cells(catalogue, flags.max_n)) {
    const auto timed = [&catalogue, cell, threads](benchmark::State& state) {
      time_cell(state, catalogue, cell, threads);
    };
    benchmark::RegisterBenchmark(cell.name().c_str(), timed)->Unit(benchmark::kMillisecond);
  }
}

bool wants_version(std::span<char*> arguments) {
  return std::ranges::any_of(arguments, [](const std::string_view argument) { return argument == "--version"; });
}

int run_benchmarks(int argument_count, char** arguments) {
  if (wants_version({arguments, static_cast<std::size_t>(argument_count)})) {
    std::printf("mwt_benchmark %s\n", version().c_str());
    return kExitOk;
  }
  const Flags flags = take_flags(argument_count, arguments);
  const bool prints_csv = value_of_flag("benchmark_format", argument_count, arguments) == "csv";
  const bool has_file = !value_of_flag("benchmark_out", argument_count, arguments).empty();
  const bool writes_csv = has_file && value_of_flag("benchmark_out_format", argument_count, arguments) == "csv";
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return kExitUserMistake;
  const Catalogue catalogue = Catalogue::built_in();
  register_all(catalogue, flags);
  benchmark::AddCustomContext("version", version());
  benchmark::AddCustomContext("git_commit", git_commit());
  benchmark::AddCustomContext("compiler_flags", compiler_flags());
  benchmark::AddCustomContext("threads", std::to_string(flags.threads));
  const auto display = prints_csv ? make_csv_reporter() : nullptr;
  const auto file = writes_csv ? make_csv_reporter() : nullptr;
  benchmark::RunSpecifiedBenchmarks(display.get(), file.get());
  benchmark::Shutdown();
  return kExitOk;
}

}  // namespace

}  // namespace mwt

int main(int argument_count, char** arguments) {
  mwt::open_closed_standard_streams();
  try {
    return mwt::run_benchmarks(argument_count, arguments);
  } catch (const mwt::InputError& mistake) {
    std::fprintf(stderr, "mwt_benchmark: %s\n", mistake.what());
    return mwt::kExitUserMistake;
  }
}
