// Google Benchmark's front door: every algorithm x family, all standard flags, nothing generated before its turn.
//
// Two flags of its own: --largest_n=10000000, up to how many points (a million unless told), and --threads=2 (one
// unless told), which algorithms that use threads may use. Counters: over_yardstick = median processor time (of several
// threads: wall time) / median of seven Delaunay triangulations of the same points by CGAL, measured in turns with the
// algorithm; stopped_early, 1 if something stopped the algorithm (the
// label says what), else 0; alpha_lower, alpha_upper where an optimum is cheap; phase_NAME_s, the algorithm's own
// stages in its last iteration.
#include <benchmark/benchmark.h>

#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/cpu_clock.h"
#include "harness/benchmark/prepared_cell.h"
#include "harness/build_info.h"

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

void time_cell(benchmark::State& state, const Catalogue& catalogue, const BenchmarkCell& benchmark_cell, int threads) {
  const PreparedCell& cell = prepared(catalogue, benchmark_cell);
  if (!cell.reason_to_skip.empty()) {
    state.SkipWithError(cell.reason_to_skip.c_str());
    return;
  }
  const Points points = cell.instance.set.points;
  TimeOverYardstick times;
  Context context;
  context.parameters = cell.request.parameters;
  context.threads = threads;
  const std::uint64_t every = 1 + state.max_iterations / TimeOverYardstick::kYardsticks;
  std::optional<StopReason> stop_reason;
  std::uint64_t iteration = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (iteration++ % every == 0) times.measure_yardstick(points);
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
  state.counters["over_yardstick"] = times.ratio(points);
  state.counters["stopped_early"] = stop_reason ? 1 : 0;
  if (stop_reason) state.SetLabel("stopped early: " + std::string(phrase_of(*stop_reason)));
  if (cell.alpha) {
    state.counters["alpha_lower"] = cell.alpha->lower;
    state.counters["alpha_upper"] = cell.alpha->upper;
  }
  for (const auto& [phase, seconds] : context.phases) state.counters["phase_" + phase + "_s"] += seconds;
}

// What mwt_benchmark understands besides Google Benchmark's own flags.
struct Flags {
  Index largest_n = 1'000'000;
  Index threads = 1;
};

// Takes --largest_n=N and --threads=T out of the arguments; nothing if one has no positive number.
std::optional<Flags> take_flags(int& argument_count, char** arguments) {
  Flags flags;
  int kept = 1;
  for (int i = 1; i < argument_count; ++i) {
    const std::string_view argument = arguments[i];
    Index* number = nullptr;
    for (const auto& [name, value] : {std::pair("--largest_n=", &flags.largest_n), {"--threads=", &flags.threads}}) {
      if (argument.starts_with(name)) number = value;
    }
    if (number == nullptr) {
      arguments[kept++] = arguments[i];
      continue;
    }
    const std::string_view text = argument.substr(argument.find('=') + 1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *number);
    if (error != std::errc() || end != text.data() + text.size() || *number == 0) return std::nullopt;
  }
  argument_count = kept;
  return flags;
}

void register_all(const Catalogue& catalogue, const Flags& flags) {
  const int threads = static_cast<int>(flags.threads);
  for (const BenchmarkCell& cell : benchmark_cells(catalogue, flags.largest_n)) {
    const auto timed = [&catalogue, cell, threads](benchmark::State& state) {
      time_cell(state, catalogue, cell, threads);
    };
    benchmark::RegisterBenchmark(cell.name().c_str(), timed)->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

}  // namespace mwt

int main(int argument_count, char** arguments) {
  const auto flags = mwt::take_flags(argument_count, arguments);
  if (!flags) {
    std::fputs("mwt_benchmark: --largest_n and --threads need a number, as in --largest_n=10000000\n", stderr);
    return 2;
  }
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  const mwt::Catalogue catalogue = mwt::Catalogue::built_in();
  mwt::register_all(catalogue, *flags);
  benchmark::AddCustomContext("git_commit", mwt::git_commit());
  benchmark::AddCustomContext("compiler_flags", mwt::compiler_flags());
  benchmark::AddCustomContext("threads", std::to_string(flags->threads));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
