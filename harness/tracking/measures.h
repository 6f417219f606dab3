// What is compared and followed: times, memory, quality, failures.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

enum class Aspect { time, memory, quality, failures };

[[nodiscard]] std::string name_of(Aspect aspect);

/// A number that a run has; less is better in all of them.
struct Measure {
  std::string name;
  std::string unit;  ///< "s", "bytes" or empty
  Aspect aspect = Aspect::time;
  bool is_exact = false;  ///< the same in every repetition: any change is a change
  std::function<std::optional<double>(const RunRecord&)> of;
};

/// relative_time (time / that of the Delaunay time in the same run; CPU time if one thread was allowed, else wall
/// time), wall_time_s, cpu_time_s, peak_rss_bytes, alpha (its upper end, where the optimum is proved), weight (the
/// middle of its certified interval), failures (1 if it failed). Times, memory, alpha and weight exist for successful
/// runs only, alpha and weight not for those that were stopped early: these need not be repeatable. A CPU time of 0 is
/// none.
[[nodiscard]] std::span<const Measure> measures();

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
