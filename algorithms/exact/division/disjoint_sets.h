// Disjoint sets of numbers 0, 1, ...
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mwt {

/// The smallest member represents its set. Amortised logarithmic time per operation.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace mwt
