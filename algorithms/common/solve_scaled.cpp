#include "algorithms/common/solve_scaled.h"

#include "geometry/numbers/scaling.h"
#include "geometry/weight.h"

namespace mwt {

Solution solve_scaled(Points points, Context& context, AlgorithmFunction solve) {
  const int e = exact_scale(points);
  if (e == 0) return solve(points, context);
  Solution solution = solve(exactly_scaled(points), context);
  if (solution.optimum) {
    solution.optimum = {scaled_up(*solution.optimum, e).lower, weight(points, solution.triangulation).upper};
  }
  return solution;
}

}  // namespace mwt
