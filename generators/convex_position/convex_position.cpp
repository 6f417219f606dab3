#include "generators/convex_position/convex_position.h"

#include "generators/circle/circle.h"
#include "generators/distinct_points.h"
#include "generators/random.h"
#include "generators/unit_circle.h"

namespace mwt {

GeneratorInfo convex_position_entry() {
  return {.name = "convex_position",
          .summary = "points at random angles on the unit circle, in convex position",
          .source = "a standard random model",
          .stresses = "the polygon programs on uneven polygons; greedy and Delaunay without interior points",
          .law = "optimum by polygon_dp",
          .max_n = kMaxConvexPosition,
          .parameters = {},
          .function = [](Index n, std::uint64_t seed, const Parameters&) { return convex_position_points(n, seed); }};
}

std::vector<Point> convex_position_points(Index n, std::uint64_t seed) {
  constexpr std::uint64_t kPlaces = std::uint64_t{1} << 26;
  static_assert(kPlaces <= kMaxRegularPolygon);
  RandomEngine engine = make_engine("convex_position", seed);
  return draw_distinct_points("convex_position", n,
                              [&](Index) { return unit_circle_point(uniform_below(engine, kPlaces), kPlaces); });
}

}  // namespace mwt
