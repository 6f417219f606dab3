#include "generators/roads/roads.h"

#include <array>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

constexpr std::size_t kLegs = 10;
constexpr double kLegLength = .1;

using Road = std::array<Point, kLegs + 1>;

Road random_road(RandomEngine& engine) {
  constexpr std::uint64_t kFullTurn = std::uint64_t{1} << 40;
  Road road = {uniform_in_square(engine)};
  std::uint64_t angle = uniform_below(engine, kFullTurn);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const Point direction = unit_circle_point(angle, kFullTurn);
    road[leg + 1] = {road[leg].x + kLegLength * direction.x, road[leg].y + kLegLength * direction.y};
    // An eighth of a turn to either side.
    angle = (angle + kFullTurn - kFullTurn / 8 + uniform_below(engine, kFullTurn / 4)) % kFullTurn;
  }
  return road;
}

Point random_place(const Road& road, RandomEngine& engine) {
  const auto leg = static_cast<std::size_t>(uniform_below(engine, kLegs));
  const double part = uniform_unit(engine);
  const Point &a = road[leg], &b = road[leg + 1];
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

}  // namespace

GeneratorInfo roads_entry() {
  return {.name = "roads",
          .summary = "points along random polylines",
          .source = "the look of TIGER and OpenStreetMap extracts, a common test for geometric software",
          .stresses = "nearly collinear runs next to empty regions: diamond tests, beta_skeleton of patches, quadtree",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"roads", ParameterType::integer, "20", "number of polylines, 1 to 1000000"}},
          .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
            const auto roads = integer_within("roads", parameters, "roads", 1, 1'000'000);
            return roads_points(n, seed, static_cast<Index>(roads));
          }};
}

std::vector<Point> roads_points(Index n, std::uint64_t seed, Index roads) {
  RandomEngine engine = make_engine("roads", seed);
  std::vector<Road> all;
  for (Index i = 0; i < roads; ++i) all.push_back(random_road(engine));
  return draw_distinct_points("roads", n,
                              [&](Index) { return random_place(all[uniform_below(engine, roads)], engine); });
}

}  // namespace mwt
