#include "generators/ellipse/ellipse.h"

#include "generators/arguments.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

GrowthLaw zigzag_growth(const std::string& algorithm, const std::string& aspect) {
  return {.algorithm = algorithm,
          .algorithm_parameters = {},
          .parameters = {{"aspect", aspect}},
          .lowest = .7,
          .highest = .95,
          .min_n = 256,
          .max_n = 4096};
}

}  // namespace

GeneratorInfo ellipse_entry() {
  return {
      .name = "ellipse",
      .summary = "points on an ellipse, in convex position: a regular polygon, flattened",
      .source = "classical; the zigzag as a local optimum of flips was found for this project",
      .stresses = "delaunay (the zigzag across the short axis), and flip for an aspect near 1",
      .law =
          "alpha of delaunay and of flip grows like n / log n (10.7 at n = 1024; 22.7 for an aspect near 1); optimum "
          "by polygon_dp",
      .max_n = kMaxEllipse,
      .seeded = false,
      .parameters = {{"aspect", ParameterType::real, "0.3", "short axis over long axis, 0.000001 to 1"}},
      .growth_laws = {zigzag_growth("delaunay", "0.3"), zigzag_growth("flip", "0.3"), zigzag_growth("flip", "0.999")},
      .function = [](Index n, std::uint64_t, const Parameters& parameters) {
        return ellipse_points(n, real_within("ellipse", parameters, "aspect", 1e-6, 1));
      }};
}

std::vector<Point> ellipse_points(Index n, double aspect) {
  std::vector<Point> points;
  points.reserve(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    const Point p = unit_circle_point(4 * i + 1, std::uint64_t{4} * n);
    points.push_back({p.x, aspect * p.y});
  }
  return points;
}

}  // namespace mwt
