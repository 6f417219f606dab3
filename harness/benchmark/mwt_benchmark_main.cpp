// Google Benchmark's front door: every algorithm x family, all standard flags, nothing generated before its turn.
//
// One flag of its own, --largest_n=10000000: up to how many points (a million unless told).
// Counters: over_yardstick = median processor time / median of seven Delaunay triangulations of the same points by
// CGAL, measured in turns with the algorithm; alpha_lower, alpha_upper where an optimum is cheap; phase_NAME_s, the
// algorithm's own stages in its last iteration.
#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>

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

void time_cell(benchmark::State& state, const Catalogue& catalogue, const BenchmarkCell& benchmark_cell) {
  const PreparedCell& cell = prepared(catalogue, benchmark_cell);
  if (!cell.reason_to_skip.empty()) {
    state.SkipWithError(cell.reason_to_skip.c_str());
    return;
  }
  const Points points = cell.instance.set.points;
  TimeOverYardstick times;
  Context context;
  context.parameters = cell.request.parameters;
  const std::uint64_t every = 1 + state.max_iterations / TimeOverYardstick::kYardsticks;
  std::uint64_t iteration = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (iteration++ % every == 0) times.measure_yardstick(points);
    context.phases.clear();
    state.ResumeTiming();
    const double start = process_cpu_time_s();
    Solution solution = benchmark_cell.algorithm->function(points, context);
    times.add(process_cpu_time_s() - start);
    benchmark::DoNotOptimize(solution.triangulation.triangles.data());
  }
  state.counters["over_yardstick"] = times.ratio(points);
  if (cell.alpha) {
    state.counters["alpha_lower"] = cell.alpha->lower;
    state.counters["alpha_upper"] = cell.alpha->upper;
  }
  for (const auto& [phase, seconds] : context.phases) state.counters["phase_" + phase + "_s"] += seconds;
}

void register_all(const Catalogue& catalogue, Index largest_n) {
  for (const BenchmarkCell& cell : benchmark_cells(catalogue, largest_n)) {
    const auto timed = [&catalogue, cell](benchmark::State& state) { time_cell(state, catalogue, cell); };
    benchmark::RegisterBenchmark(cell.name().c_str(), timed)->Unit(benchmark::kMillisecond);
  }
}

// Takes --largest_n=N out of the arguments; nothing if N is no number.
std::optional<Index> take_largest_n(int& argument_count, char** arguments) {
  constexpr Index kUnlessTold = 1'000'000;
  constexpr std::string_view kFlag = "--largest_n=";
  Index largest_n = kUnlessTold;
  int kept = 1;
  for (int i = 1; i < argument_count; ++i) {
    const std::string_view argument = arguments[i];
    if (!argument.starts_with(kFlag)) {
      arguments[kept++] = arguments[i];
      continue;
    }
    const std::string_view text = argument.substr(kFlag.size());
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), largest_n);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  }
  argument_count = kept;
  return largest_n;
}

}  // namespace

}  // namespace mwt

int main(int argument_count, char** arguments) {
  const std::optional<mwt::Index> largest_n = mwt::take_largest_n(argument_count, arguments);
  if (!largest_n) {
    std::fputs("mwt_benchmark: --largest_n needs a number of points, as in --largest_n=10000000\n", stderr);
    return 2;
  }
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  const mwt::Catalogue catalogue = mwt::Catalogue::built_in();
  mwt::register_all(catalogue, *largest_n);
  benchmark::AddCustomContext("git_commit", mwt::git_commit());
  benchmark::AddCustomContext("compiler_flags", mwt::compiler_flags());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
