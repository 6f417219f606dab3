#include "generators/report_example/report_example.h"

namespace mwt {

GeneratorInfo report_example_entry() {
  return {.name = "report_example",
          .summary = "the ten points A .. J of the source report's worked examples",
          .source = "the source report, sections 5.1.3 and 5.2.3",
          .stresses = "claims C1 and C2: greedy's and hull insertion's listed triangles",
          .law = "optimum 70.9585925243; 586 triangulations; greedy and Delaunay reach it, insertion has alpha 1.21965",
          .min_n = 10,
          .max_n = 10,
          .fixed_n = 10,
          .seeded = false,
          .parameters = {},
          .function = [](Index, std::uint64_t, const Parameters&) { return report_example_points(); }};
}

std::vector<Point> report_example_points() {
  return {{0, 1}, {1, 1}, {-5, 0}, {-1, -1}, {-6, -3}, {-1, -5}, {2, -2}, {1, -3}, {3, -3}, {1, -6}};
}

}  // namespace mwt
