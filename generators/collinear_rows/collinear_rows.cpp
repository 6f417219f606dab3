#include "generators/collinear_rows/collinear_rows.h"

#include "generators/arguments.h"

namespace mwt {

GeneratorInfo collinear_rows_entry() {
  return {.name = "collinear_rows",
          .summary = "rows of equally spaced points, all points of a row on one line",
          .source = "classical degenerate input",
          .stresses = "collinear hull points, and sweeps: all but a few triples of a row are collinear",
          .law = "optimum 2 (k - 1) + k gap + (k - 1) sqrt(1 + gap^2) for rows=2, n = 2k",
          .max_n = kMaxPoints,
          .seeded = false,
          .parameters = {{"rows", ParameterType::integer, "2", "number of rows, at least 2 and less than n"},
                         {"gap", ParameterType::real, "1", "distance of neighbouring rows in steps of a row, above 0"}},
          .function = [](Index n, std::uint64_t, const Parameters& parameters) {
            const auto rows = integer_within("collinear_rows", parameters, "rows", 2, 1'000'000);
            const double gap = real_within("collinear_rows", parameters, "gap", 1e-300, 1e290);
            require_size("collinear_rows", n, static_cast<std::uint64_t>(rows) + 1, kMaxPoints);
            return collinear_rows(n, static_cast<Index>(rows), gap);
          }};
}

std::vector<Point> collinear_rows(Index n, Index rows, double gap) {
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < n; ++i) points.push_back({static_cast<double>(i / rows), gap * (i % rows)});
  return points;
}

}  // namespace mwt
