// What callgrind counted: totals, and instructions by function.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace mwt {

struct CallgrindCounts {
  std::uint64_t instructions = 0;
  std::uint64_t l1_misses = 0;      ///< of instructions and data, in the simulated first-level caches
  std::uint64_t ll_misses = 0;      ///< likewise of the last level
  std::uint64_t branch_misses = 0;  ///< of the simulated prediction, of conditional and of indirect branches
};

/// Instructions of each function by itself, without those of the functions that it calls.
using FunctionCounts = std::map<std::string, std::uint64_t>;

struct CallgrindProfile {
  CallgrindCounts counts;
  FunctionCounts functions;
};

/// Of the text of a callgrind.out file with the events Ir and, where they were simulated, those of caches and branches.
/// Throws std::invalid_argument: it is none, or nothing was counted.
[[nodiscard]] CallgrindProfile parse_callgrind(const std::string& text);

/// "LmtKernel::find_pair" for "mwt::(anonymous namespace)::LmtKernel::find_pair(unsigned int) const": without the
/// project's namespaces, the arguments and what template arguments there are. Other names stay.
[[nodiscard]] std::string short_function_name(const std::string& name);

/// The function whose count changed most, in the direction of the sum of all.
struct ChangedFunction {
  std::string name;  ///< short
  std::uint64_t before = 0;
  std::uint64_t after = 0;

  /// "LmtKernel::find_pair +14.0%"; "(new)" or "(gone)" where one side does not have it: the compiler may have made it
  /// a part of another, or not.
  [[nodiscard]] std::string text() const;
};
[[nodiscard]] std::optional<ChangedFunction> most_changed(const FunctionCounts& before, const FunctionCounts& after);

/// As CSV: function, instructions; the largest first. Functions with less than a thousandth of the sum are one row,
/// "(other functions)".
[[nodiscard]] std::string to_csv(const FunctionCounts& functions);
/// Throws std::invalid_argument.
[[nodiscard]] FunctionCounts functions_of_csv(const std::string& text);

}  // namespace mwt
