#include "algorithms/polygon_dp/preorder.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace mwt {

std::vector<Triangle> in_preorder(std::vector<Triangle> triangles, std::size_t size) {
  std::unordered_map<std::uint64_t, Index> apex;  // of the triangle on the inner side of a chord, by its ends
  const auto key = [](std::uint64_t i, std::uint64_t j) { return i << 32 | j; };
  apex.reserve(triangles.size());
  for (Triangle& t : triangles) {
    std::sort(t.begin(), t.end());
    apex[key(t[0], t[2])] = t[1];
  }
  triangles.clear();
  std::vector<std::pair<Index, Index>> open = {{0, static_cast<Index>(size - 1)}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const Index k = apex.at(key(i, j));
    triangles.push_back({i, k, j});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
  return triangles;
}

}  // namespace mwt
