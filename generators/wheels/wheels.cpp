#include "generators/wheels/wheels.h"

#include <algorithm>

#include "generators/arguments.h"
#include "generators/circle/circle.h"
#include "generators/distinct_points.h"
#include "generators/grid/grid.h"
#include "generators/random.h"

namespace mwt {

namespace {

std::vector<Point> wheels(Index n, std::uint64_t seed, const Parameters& parameters) {
  const auto size = integer_within("wheels", parameters, "size", 4, 1'000'000);
  return wheels_points(n, seed, static_cast<Index>(size), real_within("wheels", parameters, "jitter", 0, 1));
}

void append_wheel(std::vector<Point>& points, const Point& centre, Index size) {
  for (const Point& p : regular_polygon(size - 1)) points.push_back({centre.x + p.x, centre.y + p.y});
  points.push_back(centre);
}

}  // namespace

GeneratorInfo wheels_entry() {
  return {.name = "wheels",
          .summary = "many jittered wheels side by side",
          .source = "wheels disconnect the LMT-skeleton: Bose, Devroye and Evans, IJCGA 12 (2002)",
          .stresses = "exact solvers: many faces that no dynamic program solves",
          .law = "none known",
          .min_n = 4,
          .max_n = kMaxPoints,
          .parameters = {{"size", ParameterType::integer, "14", "points of a wheel, its centre included, at least 4"},
                         {"jitter", ParameterType::real, "0.001",
                          "side of the square that a point is moved in, 0 (exact wheels) to 1"}},
          .function = wheels};
}

std::vector<Point> wheels_points(Index n, std::uint64_t seed, Index size, double jitter) {
  constexpr double kSpacing = 3;
  RandomEngine engine = make_engine("wheels", seed);
  const Index count = std::max(Index{1}, n / size);
  const Index columns = ceiling_square_root(count);
  std::vector<Point> exact;
  exact.reserve(n);
  for (Index i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count;
    const Point centre = {kSpacing * (i % columns), kSpacing * (i / columns)};
    append_wheel(exact, centre, is_last ? n - static_cast<Index>(exact.size()) : size);
  }
  return draw_distinct_points("wheels", n, [&](Index i) -> Point {
    const Point move = uniform_in_square(engine);
    return {exact[i].x + jitter * (move.x - .5), exact[i].y + jitter * (move.y - .5)};
  });
}

}  // namespace mwt
