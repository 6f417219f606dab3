#include "generators/wheel/wheel.h"

#include "generators/arguments.h"
#include "generators/circle/circle.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

std::vector<Point> wheel(Index n, std::uint64_t seed, const Parameters& parameters) {
  return wheel_points(n, seed, real_within("wheel", parameters, "jitter", 0, 1),
                      real_within("wheel", parameters, "growth", 0, 1));
}

}  // namespace

GeneratorInfo wheel_entry() {
  return {.name = "wheel",
          .summary = "regular (n - 1)-gon and its centre, slightly jittered",
          .source = "wheels disconnect the LMT-skeleton: Bose, Devroye and Evans, IJCGA 12 (2002)",
          .stresses =
              "exact solvers: from n = 14 the LMT-skeleton leaves the centre isolated; fractional triangle LPs; with "
              "growth, "
              "greedy algorithms that scan the centre's edges",
          .law = "none known",
          .min_n = 4,
          .max_n = kMaxRegularPolygon,
          .parameters = {{"jitter", ParameterType::real, "0.001",
                          "side of the square that a point is moved in, 0 (exact wheel) to 1"},
                         {"growth", ParameterType::real, "0",
                          "how much longer the last spoke is than the first, 0 to 1; above 0 no two spokes are equal"}},
          .function = wheel};
}

std::vector<Point> wheel_points(Index n, std::uint64_t seed, double jitter, double growth) {
  RandomEngine engine = make_engine("wheel", seed);
  std::vector<Point> exact = regular_polygon(n - 1);
  for (Index i = 0; i + 1 < n; ++i) {
    const double spoke = 1 + growth * i / (n - 1);
    exact[i] = {exact[i].x * spoke, exact[i].y * spoke};
  }
  exact.push_back({0, 0});
  return draw_distinct_points("wheel", n, [&](Index i) -> Point {
    const Point move = uniform_in_square(engine);
    return {exact[i].x + jitter * (move.x - .5), exact[i].y + jitter * (move.y - .5)};
  });
}

}  // namespace mwt
