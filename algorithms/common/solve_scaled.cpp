#include "algorithms/common/solve_scaled.h"

#include "algorithms/proof_trace.h"
#include "geometry/numbers/scaling.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

void scale_up(ProofTrace& proof, int e) {
  for (DualRegion& region : proof.regions) region.unit_exponent += e;
  proof.lower_bound = scaled_up({proof.lower_bound, proof.lower_bound}, e).lower;
}

}  // namespace

Solution solve_scaled(Points points, Context& context, const AlgorithmFunction& solve) {
  const int e = exact_scale(points);
  if (e == 0) return solve(points, context);
  Solution solution = solve(exactly_scaled(points), context);
  if (solution.optimum) {
    solution.optimum = {scaled_up(*solution.optimum, e).lower, weight(points, solution.triangulation).upper};
  }
  if (context.proof != nullptr) scale_up(*context.proof, e);
  return solution;
}

}  // namespace mwt
