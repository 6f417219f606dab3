// Runs one algorithm on one instance and measures it. Everything that reports a time goes through here: the command
// line, the workers of a study, the benchmarks.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/point_set.h"
#include "harness/run/machine/event_counts.h"

namespace mwt {

/// Points as algorithms get them, with what every record has of them.
struct Instance {
  PointSet set;
  std::string id;       ///< content hash
  Index hull_size = 0;  ///< h, collinear boundary points included
};

/// Throws InputError as make_point_set().
[[nodiscard]] Instance make_instance(const std::vector<Point>& input, const std::string& source);

/// What to run and how.
struct Request {
  const AlgorithmInfo* algorithm = nullptr;
  Parameters parameters;  ///< complete
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<double> time_limit_s;  ///< soft: becomes the algorithm's deadline, counted from its start
  std::optional<Triangulation> start;  ///< checked
  ProofTrace* proof = nullptr;         ///< optional: filled by solvers that can prove what they return
  StepTrace* steps = nullptr;          ///< optional: filled by algorithms that note what they do, step by step
  std::function<void(const std::string& stage, double done)> progress;
  const std::atomic<bool>* interrupt = nullptr;  ///< optional: once true, Interrupted is thrown soon
};

/// A solution and what it cost: the algorithm alone, no reading, no checking.
struct Execution {
  Solution solution;
  std::vector<std::pair<std::string, double>> phases;  ///< seconds, of the last execution
  double wall_time_s = 0;
  double cpu_time_s = 0;  ///< of the whole process: all threads
  std::uint64_t peak_rss_bytes = 0;
  std::uint64_t iterations = 1;  ///< executions by which the times were taken
  EventCounts counts;            ///< of the first execution; none with several threads
};

/// The solution alone, with nothing measured; may be called from any thread. Throws what the algorithm throws,
/// and Interrupted (algorithms/interrupted.h).
[[nodiscard]] Execution solve_unmeasured(const Request& request, Points points);

/// One execution. Throws what the algorithm throws; in particular NotApplicable. The algorithm may make tables of up to
/// nine tenths of available_memory_bytes() (machine/available_memory.h) as it is before.
[[nodiscard]] Execution execute_once(const Request& request, Points points);

/// As many executions as it takes to time one: exactly one if that uses `min_time_s` of CPU time, else as
/// time_repeatedly() does. For repeated ones the times include releasing the previous solution. The first execution is
/// where events are counted, and callgrind counts if the program runs under it (callgrind/marks.h).
[[nodiscard]] Execution execute_repeatedly(const Request& request, Points points, double min_time_s);

}  // namespace mwt
