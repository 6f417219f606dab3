#include "generators/parabola/parabola.h"

#include "generators/arguments.h"

namespace mwt {

GeneratorInfo parabola_entry() {
  return {.name = "parabola",
          .summary = "consecutive integer points on the parabola y = x^2, in convex position",
          .source = "classical; the lift of collinear points",
          .stresses = "delaunay: a natural convex set on which its alpha grows",
          .law = "alpha of delaunay grows like n / log n (2.08 at n = 32, 31.9 at 1024); optimum by polygon_dp",
          .max_n = kMaxParabola,
          .seeded = false,
          .parameters = {},
          .growth_laws = {{.algorithm = "delaunay",
                           .algorithm_parameters = {},
                           .parameters = {},
                           .lowest = .75,
                           .highest = .95,
                           .min_n = 256,
                           .max_n = 4096}},
          .function = [](Index n, std::uint64_t, const Parameters&) { return parabola_points(n); }};
}

std::vector<Point> parabola_points(Index n) {
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < n; ++i) points.push_back({1.0 * i, 1.0 * i * i});
  return points;
}

}  // namespace mwt
