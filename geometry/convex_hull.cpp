#include "geometry/convex_hull.h"

#include <algorithm>
#include <numeric>

#include "geometry/predicates.h"

namespace mwt {

namespace {

// Extends a convex chain by p: corners that turn right are no longer on the boundary, straight ones stay.
void extend_chain(Points points, std::vector<Index>& chain, std::size_t fixed, Index p) {
  while (chain.size() > fixed + 1 &&
         orientation(points[chain[chain.size() - 2]], points[chain.back()], points[p]) < 0) {
    chain.pop_back();
  }
  chain.push_back(p);
}

}  // namespace

bool all_collinear(Points points) {
  if (points.size() < 3) return true;
  const Point& a = points[0];
  const auto b = std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != a; });
  if (b == points.end()) return true;
  return std::all_of(b, points.end(), [&](const Point& p) { return orientation(a, *b, p) == 0; });
}

std::vector<Index> monotone_chain(Points points) {
  const std::vector<Index> order = lexicographic_order(points);
  if (all_collinear(points)) return order;
  std::vector<Index> hull;
  for (const Index p : order) extend_chain(points, hull, 0, p);
  const std::size_t lower_end = hull.size() - 1;
  // The lower chain's points lie below the upper one, so each makes a right turn there and leaves it again.
  for (std::size_t i = order.size() - 1; i-- > 0;) extend_chain(points, hull, lower_end, order[i]);
  hull.pop_back();  // the start closes the cycle
  return hull;
}

std::vector<Index> graham_scan(Points points) {
  if (all_collinear(points)) return lexicographic_order(points);
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto smallest = std::min_element(
      order.begin(), order.end(), [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); });
  std::iter_swap(order.begin(), smallest);
  const Point& pivot = points[order.front()];

  // By angle around the pivot. The pivot is lexicographically smallest, so all others lie in a half-plane and, along
  // one ray, the lexicographic order is the order of distance.
  const auto by_angle = [&](Index a, Index b) {
    const int turn = orientation(pivot, points[a], points[b]);
    if (turn != 0) return turn > 0;
    return lexicographically_less(points[a], points[b]);
  };
  std::sort(order.begin() + 1, order.end(), by_angle);

  // On the last ray the boundary runs back towards the pivot: farthest point first.
  auto last_ray = order.end() - 1;
  while (last_ray != order.begin() + 1 && orientation(pivot, points[*(last_ray - 1)], points[order.back()]) == 0) {
    --last_ray;
  }
  std::reverse(last_ray, order.end());

  std::vector<Index> hull;
  for (const Index p : order) extend_chain(points, hull, 0, p);
  return hull;
}

}  // namespace mwt
