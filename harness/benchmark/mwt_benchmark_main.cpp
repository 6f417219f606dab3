// Google Benchmark's front door: every algorithm x family, all standard flags, nothing generated before its turn.
//
// Counters: over_yardstick = time / CGAL's Delaunay time on the same points; alpha_upper where an optimum is cheap.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

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
  Context context;
  context.parameters = cell.request.parameters;
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) {
    context.phases.clear();
    Solution solution = benchmark_cell.algorithm->function(cell.instance.set.points, context);
    benchmark::DoNotOptimize(solution.triangulation.triangles.data());
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  state.counters["over_yardstick"] = elapsed.count() / static_cast<double>(state.iterations()) / cell.yardstick_s;
  if (cell.alpha) state.counters["alpha_upper"] = cell.alpha->upper;
}

void register_all(const Catalogue& catalogue) {
  for (const BenchmarkCell& cell : benchmark_cells(catalogue)) {
    const auto timed = [&catalogue, cell](benchmark::State& state) { time_cell(state, catalogue, cell); };
    benchmark::RegisterBenchmark(cell.name().c_str(), timed)->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

}  // namespace mwt

int main(int argument_count, char** arguments) {
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  const mwt::Catalogue catalogue = mwt::Catalogue::built_in();
  mwt::register_all(catalogue);
  benchmark::AddCustomContext("git_commit", mwt::git_commit());
  benchmark::AddCustomContext("compiler_flags", mwt::compiler_flags());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
