// Google Benchmark's CSV with columns that fit every algorithm.
#pragma once

#include <memory>

namespace benchmark {
class BenchmarkReporter;
}

namespace mwt {

/// Reports as --benchmark_format=csv does. That has a column for every counter of the benchmark that comes first, and
/// ends the program at a counter that it lacks; but algorithms have different stages, and a skipped benchmark has no
/// counters at all. Here the columns are over_delaunay, stopped_early, alpha_lower and alpha_upper, empty where a
/// benchmark lacks them; all other counters are in the column `label`, as "name=value name=value".
[[nodiscard]] std::unique_ptr<benchmark::BenchmarkReporter> make_csv_reporter();

}  // namespace mwt
