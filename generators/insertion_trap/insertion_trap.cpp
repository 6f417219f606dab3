#include "generators/insertion_trap/insertion_trap.h"

#include "generators/unit_circle.h"

namespace mwt {

GeneratorInfo insertion_trap_entry() {
  return {.name = "insertion_trap",
          .summary = "a tiny polygon in a big triangle; the small triangle that shields it comes last",
          .source = "made for this project",
          .stresses = "hull_insertion (claims C6 and C8)",
          .law = "alpha of hull_insertion grows like n (2.29 at n = 16, 126 at 1024); optimum by exact",
          .min_n = 7,
          .max_n = kMaxInsertionTrap,
          .seeded = false,
          .parameters = {},
          .growth_laws = {{.algorithm = "hull_insertion",
                           .algorithm_parameters = {},
                           .parameters = {},
                           .lowest = .95,
                           .highest = 1.05,
                           .min_n = 128,
                           .max_n = 4096}},
          .function = [](Index n, std::uint64_t, const Parameters&) { return insertion_trap_points(n); }};
}

std::vector<Point> insertion_trap_points(Index n) {
  constexpr double kRadius = 0x1p-20;
  const std::uint64_t k = n - 6;
  std::vector<Point> points = {{0, 2}, {-2, -1}, {2, -1}};
  points.reserve(n);
  for (std::uint64_t i = 0; i < k; ++i) {
    const Point unit = unit_circle_point(4 * i + 1, 4 * k);
    points.push_back({kRadius * unit.x, kRadius * unit.y});
  }
  points.insert(points.end(), {{0, 4 * kRadius}, {-4 * kRadius, -2 * kRadius}, {4 * kRadius, -2 * kRadius}});
  return points;
}

}  // namespace mwt
