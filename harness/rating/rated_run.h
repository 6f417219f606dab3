// One run of an algorithm on one instance, judged and rated: what it cost, what it returned, how good that is. Rows of
// records, JSON objects, text, benchmark counters and hunts take their figures from this value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/stop_reason.h"
#include "geometry/numbers/interval.h"
#include "geometry/point.h"
#include "harness/io/columns.h"
#include "harness/rating/optimum_claims.h"
#include "harness/run/execution.h"
#include "harness/run/status.h"

namespace mwt {

/// Numbers with names, in the order in which they came to be.
struct NamedNumbers : std::vector<std::pair<std::string, double>> {
  using std::vector<std::pair<std::string, double>>::vector;
};

/// Measures are empty unless the run came to have them.
struct RatedRun {
  RunStatus status = RunStatus::error;
  std::string checker;  ///< "ok", or the rule that the triangulation breaks
  std::string message;  ///< what failed
  std::optional<double> wall_time_s;
  std::optional<double> cpu_time_s;
  std::optional<std::uint64_t> iterations;
  std::optional<std::uint64_t> peak_rss_bytes;
  std::optional<double> weight_lower;
  std::optional<double> weight_upper;
  std::optional<double> certified_lower;  ///< the lower bound on the optimum that this run alone certifies
  std::optional<double> optimum_lower;    ///< this and what follows to `optimal`: filled in by rate()
  std::optional<double> optimum_upper;
  std::string optimality;
  std::optional<double> alpha_lower;
  std::optional<double> alpha_upper;
  std::string optimal;
  std::optional<bool> stopped_early;
  std::optional<double> perimeter_sum;
  std::optional<std::uint64_t> triangles;
  std::optional<std::uint64_t> edges;
  std::string triangulation_count;  ///< exact, decimal
  NamedNumbers phases;              ///< seconds
  NamedNumbers counters;
  std::optional<double> delaunay_time_s;
  std::optional<StopReason> stop_reason;
  std::optional<double> claimed_lower;        ///< a lower bound that the algorithm states and nobody certifies
  std::optional<std::uint64_t> instructions;  ///< this and the next three: what the processor counted
  std::optional<std::uint64_t> cycles;
  std::optional<std::uint64_t> cache_misses;
  std::optional<std::uint64_t> branch_misses;
  std::optional<std::uint64_t> callgrind_instructions;  ///< this and the next three: of another execution
  std::optional<std::uint64_t> callgrind_l1_misses;
  std::optional<std::uint64_t> callgrind_ll_misses;
  std::optional<std::uint64_t> callgrind_branch_misses;
};

/// What an execution of `algorithm` cost and returned: the checker's verdict, the certified weight, and the lower bound
/// on the optimum, if the solution has one. The status is ok, invalid_output (then there are only
/// costs and the number of triangles), or error if the solution's own
/// triangulation disproves its bound. No rating yet.
[[nodiscard]] RatedRun judged(const AlgorithmInfo& algorithm, Points points, const Execution& execution);

/// Fills in optimum, optimality, alpha and optimal of a run that is ok, given what is certified about the optimum;
/// other runs stay as they are. Nothing else computes an alpha. Precondition: the optimum, if any, does not contradict
/// the run's weight. A claimed lower bound gives no alpha: without an optimum, optimality is then "claimed"; one that
/// is above the optimum's upper end is disproved, and the run becomes an error.
void rate(RatedRun& run, const std::optional<Interval>& optimum);

/// Adds what a run that is ok certifies, its weight and its bound, under `id`; `whose` is for messages. Returns the
/// claims that are disproved now, perhaps the run's own.
std::vector<Disproof> add_run(OptimumClaims& claims, const std::string& id, const std::string& whose,
                              const RatedRun& run);

/// Makes the run whose claim is disproved an error, without a rating.
void reject(RatedRun& run, const Disproof& disproof);

/// Whether the run is marked: what it certified is disproved.
[[nodiscard]] bool is_disproved(const RatedRun& run);

/// Ends a run: its status and one line that states why.
void fail(RatedRun& run, RunStatus status, const std::string& message);

/// The optimum, if the run was rated by one.
template <class Record>
[[nodiscard]] std::optional<Interval> optimum_of(const Record& record) {
  if (!record.optimum_lower || !record.optimum_upper) return std::nullopt;
  return Interval{*record.optimum_lower, *record.optimum_upper};
}

/// The number of that name.
[[nodiscard]] std::optional<double> named_number(const NamedNumbers& numbers, std::string_view name);

/// "name=value name=value", values in their shortest form. Blanks in names become '_'.
[[nodiscard]] std::string to_text(const NamedNumbers& numbers);
/// Throws std::invalid_argument.
void read_text(const std::string& text, NamedNumbers& numbers);

[[nodiscard]] std::string to_text(RunStatus status);
void read_text(const std::string& text, RunStatus& status);
[[nodiscard]] std::string to_text(StopReason reason);
void read_text(const std::string& text, StopReason& reason);

/// The columns of a rated run, in the order of the records; `Record` is it, or derived from it.
template <class Record>
[[nodiscard]] std::vector<Column<Record>> rated_run_columns() {
  using R = RatedRun;
  return {
      column<Record>("status", &R::status),
      column<Record>("checker", &R::checker),
      column<Record>("message", &R::message),
      time_column<Record>("wall_time_s", &R::wall_time_s),
      time_column<Record>("cpu_time_s", &R::cpu_time_s),
      column<Record>("iterations", &R::iterations),
      column<Record>("peak_rss_bytes", &R::peak_rss_bytes),
      column<Record>("weight_lower", &R::weight_lower),
      column<Record>("weight_upper", &R::weight_upper),
      column<Record>("certified_lower", &R::certified_lower),
      column<Record>("optimum_lower", &R::optimum_lower),
      column<Record>("optimum_upper", &R::optimum_upper),
      column<Record>("optimality", &R::optimality),
      column<Record>("alpha_lower", &R::alpha_lower),
      column<Record>("alpha_upper", &R::alpha_upper),
      column<Record>("optimal", &R::optimal),
      column<Record>("stopped_early", &R::stopped_early),
      column<Record>("perimeter_sum", &R::perimeter_sum),
      column<Record>("triangles", &R::triangles),
      column<Record>("edges", &R::edges),
      column<Record>("triangulation_count", &R::triangulation_count),
      column<Record>("phases", &R::phases),
      column<Record>("counters", &R::counters),
      time_column<Record>("delaunay_time_s", &R::delaunay_time_s),
      column<Record>("stop_reason", &R::stop_reason),
      column<Record>("claimed_lower", &R::claimed_lower),
      column<Record>("instructions", &R::instructions),
      column<Record>("cycles", &R::cycles),
      column<Record>("cache_misses", &R::cache_misses),
      column<Record>("branch_misses", &R::branch_misses),
      column<Record>("callgrind_instructions", &R::callgrind_instructions),
      column<Record>("callgrind_l1_misses", &R::callgrind_l1_misses),
      column<Record>("callgrind_ll_misses", &R::callgrind_ll_misses),
      column<Record>("callgrind_branch_misses", &R::callgrind_branch_misses),
  };
}

}  // namespace mwt
