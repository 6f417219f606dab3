// Holds the growth laws that families state against what a study measured.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/records/records.h"
#include "harness/run/catalogue.h"
#include "harness/statistics/bootstrap.h"

namespace mwt {

enum class Agreement {
  agrees,         ///< the exponent, or every alpha, lies in the law's interval
  disagrees,      ///< the exponent's interval misses the law's, or some alpha certainly lies outside
  undecided,      ///< neither
  too_few_sizes,  ///< a power law needs three sizes in the law's range, the largest at least 4 times the smallest
};
[[nodiscard]] std::string_view name_of(Agreement agreement);

/// One law and what was measured in the study.
struct LawFinding {
  const GeneratorInfo* family = nullptr;
  const GrowthLaw* law = nullptr;
  std::size_t sizes = 0;  ///< different n with a usable alpha
  Index min_n = 0;
  Index max_n = 0;

  /// Of a power law: the fitted exponent. Its interval is the bootstrap's where sizes were measured on several
  /// instances, else the range of the slopes from each size to the next. Of a range: its middle, smallest and largest
  /// alpha.
  Estimate measured;
  Agreement agreement = Agreement::too_few_sizes;
};

/// The laws of all families of which the study has at least one usable alpha, in the catalogue's order. An alpha counts
/// if it is certified to 1 percent; one per instance (its first run that is ok).
/// Laws whose algorithm the catalogue lacks throw InputError.
[[nodiscard]] std::vector<LawFinding> test_growth_laws(const std::vector<RunRecord>& runs, const Catalogue& catalogue);

/// One line per law: family, algorithm, sizes, what the law states, what was measured, whether both agree. Empty
/// without findings.
[[nodiscard]] std::string growth_law_table(const std::vector<LawFinding>& findings);

}  // namespace mwt
