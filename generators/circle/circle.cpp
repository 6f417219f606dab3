#include "generators/circle/circle.h"

#include "generators/unit_circle.h"

namespace mwt {

GeneratorInfo circle_entry() {
  return {.name = "circle",
          .summary = "regular n-gon on the unit circle, in convex position",
          .source = "classical; Catalan numbers count its triangulations",
          .stresses = "claim C11, the polygon programs and near-ties: equal lengths up to the last bit",
          .law = "optimum by the polygon program; greedy stays within 1.04; C(n - 2) triangulations",
          .max_n = kMaxRegularPolygon,
          .seeded = false,
          .parameters = {},
          .function = [](Index n, std::uint64_t, const Parameters&) { return regular_polygon(n); }};
}

std::vector<Point> regular_polygon(Index n) {
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < n; ++i) points.push_back(unit_circle_point(i, n));
  return points;
}

}  // namespace mwt
