#include "generators/with_duplicates/with_duplicates.h"

#include <algorithm>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

std::vector<Point> with_duplicates(Index n, std::uint64_t seed, const Parameters& parameters) {
  return points_with_duplicates(n, seed, real_within("with_duplicates", parameters, "share", 0, .999999));
}

}  // namespace

GeneratorInfo with_duplicates_entry() {
  return {.name = "with_duplicates",
          .summary = "uniform points of which a share is repeated",
          .source = "what real files look like",
          .stresses = "the removal of duplicates and results that refer to positions in the input",
          .law = "that of uniform on the distinct points",
          .max_n = kMaxPoints,
          .repeats_points = true,
          .parameters = {{"share", ParameterType::real, "0.2",
                          "share of the points that repeat others, 0 to .999999; 3 points stay distinct"}},
          .function = with_duplicates};
}

std::vector<Point> points_with_duplicates(Index n, std::uint64_t seed, double share) {
  RandomEngine engine = make_engine("with_duplicates", seed);
  const Index distinct = std::max(Index{3}, n - static_cast<Index>(share * n));
  std::vector<Point> points =
      draw_distinct_points("with_duplicates", distinct, [&](Index) { return uniform_in_square(engine); });
  points.reserve(n);
  while (points.size() < n) points.push_back(points[uniform_below(engine, distinct)]);
  shuffle(points, engine);
  return points;
}

}  // namespace mwt
