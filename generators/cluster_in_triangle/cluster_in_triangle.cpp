#include "generators/cluster_in_triangle/cluster_in_triangle.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

GeneratorInfo cluster_in_triangle_entry() {
  return {.name = "cluster_in_triangle",
          .summary = "uniform points in a tiny square inside a big triangle",
          .source = "made for this project",
          .stresses = "hull_insertion (claim C6): sparse hull, dense inside",
          .law = "alpha of hull_insertion grows like sqrt n (1.53 at n = 16, 24 at 4096); optimum by exact",
          .min_n = 4,
          .max_n = kMaxPoints,
          .parameters = {{"side", ParameterType::real, "0.0001", "side of the square of the cluster, 1e-12 to 1"}},
          .growth_laws = {{.algorithm = "hull_insertion",
                           .algorithm_parameters = {},
                           .parameters = {},
                           .lowest = .45,
                           .highest = .6,
                           .min_n = 256,
                           .max_n = 4096}},
          .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
            const double side = real_within("cluster_in_triangle", parameters, "side", 1e-12, 1);
            return cluster_in_triangle_points(n, seed, side);
          }};
}

std::vector<Point> cluster_in_triangle_points(Index n, std::uint64_t seed, double side) {
  constexpr Point kTriangle[] = {{0, 2}, {-2, -1}, {2, -1}};
  RandomEngine engine = make_engine("cluster_in_triangle", seed);
  return draw_distinct_points("cluster_in_triangle", n, [&](Index i) -> Point {
    if (i < 3) return kTriangle[i];
    const Point unit = uniform_in_square(engine);
    return {side * (unit.x - .5), side * (unit.y - .5)};
  });
}

}  // namespace mwt
