// That a weight to the printed digits tells which triangulation it is, so that records of weights suffice for C1, C2,
// C9.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "generators/local_search_figure/local_search_figure.h"
#include "generators/report_example/report_example.h"
#include "geometry/delaunay.h"
#include "geometry/mesh/flip_triangulation.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

// All triangulations: flips lead from each to each.
std::vector<Triangulation> all_triangulations(Points points) {
  std::vector<Triangulation> found = {delaunay_triangulation(points)};
  std::set<std::vector<Triangle>> seen = {canonical_triangles(found.front())};
  for (std::size_t next = 0; next < found.size(); ++next) {
    const FlipTriangulation here(found[next]);
    for (Index e = 0; e < here.edge_count(); ++e) {
      if (here.is_boundary(e) || !is_flippable(points, here, e)) continue;
      FlipTriangulation neighbour = here;
      neighbour.flip(e);
      const Triangulation triangulation = neighbour.triangulation();
      if (seen.insert(canonical_triangles(triangulation)).second) found.push_back(triangulation);
    }
  }
  return found;
}

template <class Measure>
std::ptrdiff_t how_many_round_to(const std::vector<Triangulation>& all, double printed, int digits, Measure measure) {
  return std::count_if(all.begin(), all.end(), [&](const Triangulation& triangulation) {
    return std::abs(measure(triangulation) - printed) <= 0.5 * std::pow(10.0, -digits);
  });
}

TEST(WorkedExamples, OneTriangulationHasThePrintedWeight) {
  const std::vector<Point> points = report_example_points();
  const std::vector<Triangulation> all = all_triangulations(points);
  EXPECT_EQ(all.size(), 586U);
  const auto weigh = [&](const Triangulation& triangulation) { return weight(points, triangulation).middle(); };
  EXPECT_EQ(how_many_round_to(all, 70.9586, 4, weigh), 1);
  EXPECT_EQ(how_many_round_to(all, 86.5447479007, 10, weigh), 1);
}

TEST(WorkedExamples, OneTriangulationHasThePrintedPerimeters) {
  const std::vector<Point> points = local_search_figure_points();
  const std::vector<Triangulation> all = all_triangulations(points);
  const auto sum = [&](const Triangulation& triangulation) { return perimeter_sum(points, triangulation).middle(); };
  for (const double printed : {11.0751, 10.9347, 10.7929}) EXPECT_EQ(how_many_round_to(all, printed, 4, sum), 1);
}

}  // namespace
}  // namespace mwt
