#include "harness/rating/optimum_claims.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/number_text.h"

namespace mwt {

std::string cached_claimant(const std::string& solver) { return solver + " (optimum cache)"; }

std::string Disproof::text() const {
  return fmt::format("{}: {} certified that no triangulation weighs less than {}, but {} weighs {}", kContradiction,
                     claim.claimant, number_text(claim.bounds.lower),
                     witness.empty() ? "its own" : "a checked one of " + witness, number_text(weight));
}

std::vector<Disproof> OptimumClaims::add_weight(const KnownWeight& known) {
  if (lightest_ && lightest_->weight <= known.weight) return {};
  lightest_ = known;
  std::vector<Disproof> disproofs;
  for (const OptimumClaim& claim : standing_) {
    if (claim.bounds.lower > known.weight) disproofs.push_back({claim, known.whose, known.weight});
  }
  std::erase_if(standing_, [&](const OptimumClaim& claim) { return claim.bounds.lower > known.weight; });
  return disproofs;
}

std::vector<Disproof> OptimumClaims::add_claim(const OptimumClaim& claim) {
  std::vector<Disproof> disproofs = add_weight({claim.claimant, claim.bounds.upper});
  if (claim.bounds.lower > lightest_->weight) {
    disproofs.push_back({claim, lightest_->whose, lightest_->weight});
  } else {
    standing_.push_back(claim);
  }
  return disproofs;
}

std::optional<Interval> OptimumClaims::bounds() const {
  if (standing_.empty()) return std::nullopt;
  const auto best =
      std::max_element(standing_.begin(), standing_.end(),
                       [](const OptimumClaim& a, const OptimumClaim& b) { return a.bounds.lower < b.bounds.lower; });
  return Interval{best->bounds.lower, lightest_->weight};
}

}  // namespace mwt
