#include "generators/hull_bound_counterexample/hull_bound_counterexample.h"

namespace mwt {

GeneratorInfo hull_bound_counterexample_entry() {
  return {.name = "hull_bound_counterexample",
          .summary = "convex 12-gon and an inner point that makes the optimum lighter than the hull's own",
          .source = "found for this project against the source report's section 5.2.4",
          .stresses = "claim C7: w(T0) <= w(T*) is false here",
          .law = "lightest triangulation of the 12-gon 848.848; with the inner point at most 846.822",
          .min_n = 13,
          .max_n = 13,
          .fixed_n = 13,
          .seeded = false,
          .parameters = {},
          .function = [](Index, std::uint64_t, const Parameters&) { return hull_bound_counterexample_points(); }};
}

std::vector<Point> hull_bound_counterexample_points() {
  return {{4, 8},    {-2, 11},  {-13, 16}, {-30, 20}, {-63, 16}, {-96, -35}, {-45, -96},
          {17, -64}, {19, -30}, {15, -13}, {11, -2},  {8, 4},    {0, 0}};
}

}  // namespace mwt
