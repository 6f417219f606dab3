// Who certified which bounds on the optimum of one instance, and which of these claims a triangulation disproves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/numbers/interval.h"

namespace mwt {

/// A certified lower bound on the weight of every triangulation, with the weight of the one that its solver returned.
struct OptimumClaim {
  std::string id;        ///< for the caller: a run, an instance, a source
  std::string claimant;  ///< for messages: "exact", "exact (optimum cache)"
  Interval bounds;       ///< the lower bound; the upper end of the weight of a checked triangulation
};

/// What every message about a disproved claim begins with, in records too.
inline constexpr const char* kContradiction = "CONTRADICTION";

/// "exact (optimum cache)": the claimant of what `solver` proved earlier.
[[nodiscard]] std::string cached_claimant(const std::string& solver);

/// A claim, and a checked triangulation that is lighter than it allows. The claimant is wrong, whoever found the
/// triangulation.
struct Disproof {
  OptimumClaim claim;
  std::string witness;  ///< whose triangulation it is, for messages; empty: the claimant's own
  double weight = 0;    ///< upper end of its weight: below claim.bounds.lower

  /// "CONTRADICTION: exact certified that no triangulation weighs less than 5.25, but a checked one of greedy weighs
  /// 5.01".
  [[nodiscard]] std::string text() const;
};

/// A checked triangulation: whose it is, for messages, and the upper end of its weight.
struct KnownWeight {
  std::string whose;
  double weight = 0;
};

/// All claims about one instance that no known triangulation disproves, and the lightest triangulation known.
/// The upper end of a claim counts as a triangulation like any other.
class OptimumClaims {
 public:
  /// Returns the claims that the triangulation disproves; they are gone then.
  std::vector<Disproof> add_weight(const KnownWeight& known);

  /// Returns the claims that are disproved now: earlier ones, or this one.
  std::vector<Disproof> add_claim(const OptimumClaim& claim);

  /// The best bounds that stand; nothing without a lower bound.
  [[nodiscard]] std::optional<Interval> bounds() const;

  [[nodiscard]] const std::vector<OptimumClaim>& standing() const { return standing_; }

  [[nodiscard]] const std::optional<KnownWeight>& lightest() const { return lightest_; }

 private:
  std::vector<OptimumClaim> standing_;
  std::optional<KnownWeight> lightest_;
};

}  // namespace mwt
