#include "geometry/point.h"

#include <algorithm>
#include <numeric>

namespace mwt {

std::vector<Index> lexicographic_order(Points points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    if (points[a] == points[b]) return a < b;
    return lexicographically_less(points[a], points[b]);
  });
  return order;
}

}  // namespace mwt
