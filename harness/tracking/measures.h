// What is compared and followed: times, memory, quality, failures.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

enum class Aspect { time, memory, quality, failures, counts };

[[nodiscard]] std::string name_of(Aspect aspect);

/// A number that a run has; less is better in all of them.
struct Measure {
  std::string name;
  std::string unit;  ///< "s", "bytes" or empty
  Aspect aspect = Aspect::time;
  bool is_exact = false;  ///< the same in every repetition: any change is a change; of counts: but for about 1 in 1,000
  std::function<std::optional<double>(const RunRecord&)> of;
};

/// relative_time (time / that of the Delaunay time in the same run; CPU time if one thread was allowed, else wall
/// time), wall_time_s, cpu_time_s, peak_rss_bytes, alpha (its upper end, where the optimum is proved), weight (the
/// middle of its certified interval), failures (1 if it failed); instructions, cycles, cache_misses, branch_misses as
/// the processor counts them; callgrind_instructions, callgrind_l1_misses, callgrind_ll_misses,
/// callgrind_branch_misses. Times, memory, alpha and weight exist for successful runs only, alpha and weight not for
/// those that were stopped early: these need not be repeatable. A CPU time of 0 is none.
[[nodiscard]] std::span<const Measure> measures();

/// The count by which programs are compared where both sides have it: callgrind_instructions, else instructions. The
/// misses are for the reader: of small instances they are few, and change with the places of things in memory.
inline constexpr const char* kComparedCounts[] = {"callgrind_instructions", "instructions"};

/// More is a change, as a part of the smaller count; less may be where functions of the system's libraries differ.
inline constexpr double kCountThreshold = 0.01;

/// Throws InputError listing the known names.
[[nodiscard]] const Measure& measure_named(const std::string& name);

/// The measure's median over the runs that have it (the mean for failures); nothing if none has.
struct TypicalValue {
  double value = 0;
  std::size_t runs = 0;  ///< that have it
};
[[nodiscard]] std::optional<TypicalValue> typical(const Measure& measure, const std::vector<const RunRecord*>& runs);

/// The measure of those runs that have it, in their order.
[[nodiscard]] std::vector<double> values_of(const Measure& measure, const std::vector<const RunRecord*>& runs);

}  // namespace mwt
