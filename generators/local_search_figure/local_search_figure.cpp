#include "generators/local_search_figure/local_search_figure.h"

namespace mwt {

GeneratorInfo local_search_figure_entry() {
  return {.name = "local_search_figure",
          .summary = "ten points recovered from the triangle perimeters of the source report's local search example",
          .source = "the source report, section 5.3.1; coordinates recovered from its 15 printed perimeters",
          .stresses = "claim C9: flips 0-8 -> 2-5 and 5-8 -> 2-3, perimeter sums 11.0751, 10.9347, 10.7929",
          .law = "none known",
          .min_n = 10,
          .max_n = 10,
          .fixed_n = 10,
          .seeded = false,
          .parameters = {},
          .function = [](Index, std::uint64_t, const Parameters&) { return local_search_figure_points(); }};
}

std::vector<Point> local_search_figure_points() {
  return {{.232231, .378795}, {.072356, .793954}, {.772162, .159266}, {.582166, 0},       {.792049, .14673},
          {.321352, .034372}, {.300721, .685299}, {0, .550305},       {.640103, .027961}, {.512016, .636257}};
}

}  // namespace mwt
