#include "algorithms/exact/candidates/convex_position.h"

#include "algorithms/exact/search_stopped.h"
#include "geometry/predicates.h"

namespace mwt {

CandidateGraph convex_position_candidates(Points points, std::span<const Index> hull) {
  const std::size_t n = hull.size();
  if (n > kMaxConvexPolygon) throw SearchStopped(StopReason::size, "too many points in convex position");
  const auto corner = [&](std::size_t i) -> const Point& { return points[hull[i % n]]; };
  // Points along one side of the hull are connected to their neighbours only.
  const auto lie_on_one_side = [&](std::size_t i, std::size_t j) {
    return orientation(corner(i), corner(i + 1), corner(j)) == 0 ||
           orientation(corner(j), corner(j + 1), corner(i)) == 0;
  };
  std::vector<std::size_t> position(n);
  for (std::size_t i = 0; i < n; ++i) position[hull[i]] = i;
  CandidateGraph graph{points, {0}, {}, {}};
  for (std::size_t v = 0; v < n; ++v) {
    const std::size_t i = position[v];
    for (std::size_t step = 1; step < n; ++step) {
      const bool is_side = step == 1 || step == n - 1;
      if (!is_side && lie_on_one_side(i, i + step)) continue;
      graph.target.push_back(hull[(i + step) % n]);
      graph.certain.push_back(is_side ? 1 : 0);
    }
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
  }
  return graph;
}

}  // namespace mwt
