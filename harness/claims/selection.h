// Picking the rows that a claim is judged by, and reading figures from them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/claims/claim.h"
#include "harness/statistics/power_law.h"

namespace mwt {

using RunTest = std::function<bool(const RunRecord&)>;

/// The first repetitions, in the order of the records, that ended `ok`, were not cut short by the deadline, and pass
/// the test.
[[nodiscard]] Runs finished_runs(const StudyRecords& records, const RunTest& test);

/// Of these, those with a certified alpha against a proved optimum.
[[nodiscard]] Runs rated_runs(const StudyRecords& records, const RunTest& test);

/// Groups in the order of their keys.
using RunGroups = std::map<std::string, Runs>;
[[nodiscard]] RunGroups by_family(const Runs& runs);
[[nodiscard]] RunGroups by_algorithm(const Runs& runs);

/// By family, points from files left out: their sizes are no series in which anything could grow.
[[nodiscard]] RunGroups by_growing_family(const Runs& runs);

/// Uniform, normal, clustered, and points from files (TSPLIB): what a user's points may look like.
[[nodiscard]] bool is_typical(const RunRecord& run);

/// Whether the triangulation is greedy's: of the source report's literal version or of the fast one, which agree.
[[nodiscard]] bool is_greedy(const RunRecord& run);

/// The upper ends of alpha. Precondition: rated runs.
[[nodiscard]] std::vector<double> alphas(const Runs& runs);

[[nodiscard]] double mean(const std::vector<double>& values);

/// The value of `name=value` in a field of blank-separated parameters.
[[nodiscard]] std::optional<std::string> named_value(std::string_view field, std::string_view name);

/// The run with the largest alpha. Precondition: rated runs, not empty.
[[nodiscard]] const RunRecord& worst(const Runs& runs);

/// Fits `value` as a power of n over the runs that have a positive one. Nothing with fewer than `min_sizes` sizes.
using RunValue = std::function<std::optional<double>(const RunRecord&)>;
[[nodiscard]] std::optional<PowerLaw> growth_of(const Runs& runs, const RunValue& value, std::size_t min_sizes = 3);

/// "0.23 (0.22 to 0.24)", or the value alone where the noise is unknown.
[[nodiscard]] std::string exponent_text(const PowerLaw& law);

/// With so many significant digits, never in scientific notation for what tables hold: 0.000612, 17.6, 100000.
[[nodiscard]] std::string significant(double value, int digits);

/// "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "n = 10 to 100,000", or "n = 10". Precondition: not empty.
[[nodiscard]] std::string size_range(const Runs& runs);

}  // namespace mwt
