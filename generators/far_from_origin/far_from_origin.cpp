#include "generators/far_from_origin/far_from_origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

// Beyond it, a side of the unit square holds fewer than two doubles.
constexpr double kMaxOffset = 0x1p51;

std::vector<Point> far_from_origin(Index n, std::uint64_t seed, const Parameters& parameters) {
  const double offset = real_within("far_from_origin", parameters, "offset", -kMaxOffset, kMaxOffset);
  require_size("far_from_origin", n, 3, std::min<std::uint64_t>(max_far_from_origin(offset), kMaxPoints));
  return far_from_origin_points(n, seed, offset);
}

}  // namespace

GeneratorInfo far_from_origin_entry() {
  return {
      .name = "far_from_origin",
      .summary = "uniform points in a unit square far from the origin, their last bits rounded away",
      .source = "geographic coordinates in metres; classical input for predicates",
      .stresses = "cancellation in predicates and lengths; at large offsets a coarse lattice with ties",
      .law = "that of uniform while the offset is far below 2^52",
      .max_n = kMaxPoints,
      .parameters = {{"offset", ParameterType::real, "1e6",
                      "lower left corner of the square is (offset, offset), at most 2^51 from 0; large ones limit n"}},
      .function = far_from_origin};
}

std::uint64_t max_far_from_origin(double offset) {
  const double farthest = std::max(std::abs(offset), std::abs(offset + 1));
  const double spacing = farthest - std::nextafter(farthest, 0.0);
  const double per_side = std::min(1 / spacing, 0x1p31);
  return static_cast<std::uint64_t>(per_side) * static_cast<std::uint64_t>(per_side);
}

std::vector<Point> far_from_origin_points(Index n, std::uint64_t seed, double offset) {
  RandomEngine engine = make_engine("far_from_origin", seed);
  return draw_distinct_points("far_from_origin", n, [&](Index) -> Point {
    const Point p = uniform_in_square(engine);
    return {offset + p.x, offset + p.y};
  });
}

}  // namespace mwt
