#include "algorithms/two_chains/corridor_duals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/proof/half_length.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

namespace {

// Of the optimum and of the longest edge, in units. Dual values that no optimum needs are cut at kNever.
constexpr int kBits = 56;
constexpr std::int64_t kNever = std::int64_t{1} << 58;

// The lattice path in doubles, for the size of the optimum.
int unit_exponent(Points points, std::span<const Index> p, std::span<const Index> q) {
  double longest = 0;
  std::vector<double> before(q.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const double edge = length(points[p[i]], points[q[j]]).high;
      longest = std::max(longest, edge);
      const double least = j > 0 ? std::min(before[j], before[j - 1]) : before[j];
      before[j] = edge + (i + j == 0 ? 0 : least);
    }
  }
  return std::ilogb(std::max(before.back(), longest)) + 1 - kBits;
}

}  // namespace

DualRegion corridor_duals(Points points, std::span<const Index> p, std::span<const Index> q) {
  DualRegion region;
  region.unit_exponent = unit_exponent(points, p, q);
  // Counter-clockwise: back along p, over the first bridge, along q, over the last bridge.
  region.places.assign(p.rbegin(), p.rend());
  region.places.insert(region.places.end(), q.begin(), q.end());
  region.walk_sizes = {static_cast<std::uint32_t>(region.places.size())};
  DualNode& leaf = region.tree.emplace_back();
  leaf.side_duals.assign(region.places.size(), 0);
  const std::size_t rows = p.size(), columns = q.size();
  std::vector<std::int64_t> dual(rows * columns);
  std::vector<std::int64_t> before(columns);  // of row i - 1, overwritten from left to right: with the whole edge
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const bool is_bridge = i + j == 0 || (i + 1 == rows && j + 1 == columns);
      const std::int64_t half =
          is_bridge ? 0
                    : std::max<std::int64_t>(0, half_length(length(points[p[i]], points[q[j]]), region.unit_exponent));
      std::int64_t least = i > 0 ? before[j] : 0;
      if (j > 0) least = i > 0 ? std::min(least, before[j - 1]) : before[j - 1];
      dual[i * columns + j] = std::min(kNever, half + least);
      before[j] = dual[i * columns + j] + half;
    }
  }
  for (std::size_t i = rows; i-- > 0;) {  // by ascending places
    for (std::size_t j = 0; j < columns; ++j) {
      const bool is_bridge = i + j == 0 || (i + 1 == rows && j + 1 == columns);
      if (is_bridge) continue;
      region.open_edges.push_back({static_cast<std::uint32_t>(rows - 1 - i), static_cast<std::uint32_t>(rows + j)});
      leaf.edge_duals.push_back(-dual[i * columns + j]);
    }
  }
  leaf.side_duals.back() = dual.back();
  const double optimum = std::ldexp(static_cast<double>(dual.back()), region.unit_exponent);
  region.lower_bound = std::max(0.0, next_down(optimum));
  return region;
}

}  // namespace mwt
