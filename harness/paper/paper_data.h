// What the tables and figures for a paper are made from: algorithms side by side on the same instances.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/report.h"

namespace mwt {

/// What the user chooses; an empty list leaves the choice to the study. Families and algorithms are named by their
/// labels (as summary.csv has them), or by the name of an entry for all of its variants.
struct PaperSelection {
  std::vector<std::string> families;
  std::vector<Index> sizes;
  std::vector<std::string> algorithms;
};

/// What is compared. The gap is alpha - 1 of the certified interval's upper end, 0 where the run is proved optimal.
enum class PaperMeasure { gap, time };
[[nodiscard]] std::string name_of(PaperMeasure measure);

struct PaperInstance {
  std::string instance_id;
  std::string family;  ///< label
  Index n = 0;
  std::uint64_t seed = 0;
  bool has_optimum = false;  ///< a proved one
};

/// One algorithm on one instance: medians over its repetitions. A failed repetition makes all of it a failure.
struct PaperOutcome {
  bool is_run = false;      ///< the study ran it, and it was applicable
  std::string status;       ///< "ok", or that of the first failed repetition; empty if it was not run
  bool is_optimal = false;  ///< every repetition is proved optimal
  bool is_early = false;    ///< some repetition stopped early
  double alpha_lower = 0;   ///< with `ok` and a proved optimum
  double alpha_upper = 0;
  std::optional<double> time_s;
};

/// The chosen part of a study. Algorithms in the order of the report; instances in that of their first run.
struct PaperData {
  std::string study;
  std::vector<std::string> algorithms;  ///< labels
  std::vector<std::string> left_out;    ///< labels that the study has, too
  std::vector<PaperInstance> instances;
  std::vector<std::vector<PaperOutcome>> outcomes;  ///< by algorithm, then by instance

  /// The instances on which all chosen algorithms were run; for the gap only those with a proved optimum. These alone
  /// are compared, so that no algorithm has easier ones than another.
  [[nodiscard]] std::vector<std::size_t> common(PaperMeasure measure) const;

  /// Those of them of one family, in the order of common().
  [[nodiscard]] std::vector<std::size_t> common(PaperMeasure measure, const std::string& family) const;

  /// Infinite for a failure. Precondition: the instance is one of common(measure).
  [[nodiscard]] double value(PaperMeasure measure, std::size_t algorithm, std::size_t instance) const;
  [[nodiscard]] std::vector<double> values(PaperMeasure measure, std::size_t algorithm,
                                           const std::vector<std::size_t>& instances) const;

  /// By how much the second is worse than the first: above 0 where the first is better, 0 where the certified intervals
  /// of their alphas overlap. For times the difference of the logarithms. Infinite where one of both failed, 0 where
  /// both did.
  [[nodiscard]] double difference(PaperMeasure measure, std::size_t first, std::size_t second,
                                  std::size_t instance) const;
};

inline constexpr double kPaperFailure = std::numeric_limits<double>::infinity();

/// Without a choice of algorithms: those, most often run first, that make the number of algorithms times the number of
/// instances common to all of them largest, at most 10. Throws InputError: the study has no such family, size or
/// algorithm, or nothing is left to compare.
[[nodiscard]] PaperData select_for_paper(const ReportData& report, const PaperSelection& selection);

}  // namespace mwt
