#include "algorithms/delaunay/delaunay.h"

#include "geometry/delaunay.h"

namespace mwt {

namespace {

Solution solve(Points points, Context&) {
  Solution solution;
  solution.triangulation = delaunay_triangulation(points);
  return solution;
}

}  // namespace

AlgorithmInfo delaunay_entry() {
  AlgorithmInfo info;
  info.name = "delaunay";
  info.summary = "Delaunay triangulation (CGAL)";
  info.source = "source report, section 6.4; B. Delaunay 1934";
  info.guarantee = "Theta(n) in the worst case (Kirkpatrick 1980)";
  info.time = "O(n log n) expected";
  info.space = "O(n)";
  info.max_n = 10'000'000;
  info.function = solve;
  return info;
}

}  // namespace mwt
