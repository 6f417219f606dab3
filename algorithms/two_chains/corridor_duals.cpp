#include "algorithms/two_chains/corridor_duals.h"

#include <algorithm>
#include <cmath>

#include "algorithms/proof/half_length.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

namespace {

// The longest edge has at most so many bits in front of the point, and the sum over a lattice path fits into 2^58.
constexpr int kUsualBits = 46, kPathBits = 57;

int unit_exponent(Points points, std::span<const Index> p, std::span<const Index> q) {
  double longest = 0;
  for (const Index a : p) {
    for (const Index b : q) longest = std::max(longest, length(points[a], points[b]).high);
  }
  const int path_bits = std::ilogb(static_cast<double>(p.size() + q.size())) + 1;
  return std::ilogb(longest) + 1 - std::min(kUsualBits, kPathBits - path_bits);
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
      dual[i * columns + j] = half + least;
      before[j] = 2 * half + least;
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
