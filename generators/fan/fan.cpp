#include "generators/fan/fan.h"

#include "generators/arguments.h"

namespace mwt {

GeneratorInfo fan_entry() {
  return {.name = "fan",
          .summary = "n - 1 collinear points and one apex: exactly one triangulation",
          .source = "classical degenerate input",
          .stresses = "collinear hull points and counts; every correct algorithm has alpha 1",
          .law = "optimum (n - 2) + sum over i = 0 .. n - 2 of sqrt((i - floor(n / 2))^2 + 1); one triangulation",
          .max_n = kMaxPoints,
          .seeded = false,
          .parameters = {},
          .function = [](Index n, std::uint64_t, const Parameters&) { return fan_points(n); }};
}

std::vector<Point> fan_points(Index n) {
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i + 1 < n; ++i) points.push_back({static_cast<double>(i), 0});
  points.push_back({static_cast<double>(n / 2), 1});
  return points;
}

}  // namespace mwt
