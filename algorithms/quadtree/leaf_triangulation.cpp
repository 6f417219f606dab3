#include "algorithms/quadtree/leaf_triangulation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "geometry/numbers/double_double.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::size_t kSize = kMaxLeaf;

// A monotone path as the set of its vertices, bit i for the i-th point in lexicographic order.
using Path = std::uint32_t;

Path bit(std::size_t i) { return Path{1} << i; }

// The vertices between bits i and j of the path's ends, in constant time.
std::size_t next_on(Path path, std::size_t i) {
  return static_cast<std::size_t>(std::countr_zero(path >> (i + 1))) + i + 1;
}

// The points of a leaf in lexicographic order, and facts about them that the search uses often.
class Leaf {
 public:
  Leaf(Points points, std::span<const Index> chosen) : indices_(chosen.begin(), chosen.end()) {
    std::sort(indices_.begin(), indices_.end(),
              [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); });
    const std::size_t m = size();
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = i + 1; j < m; ++j) {
        lengths_[i][j] = length(points[indices_[i]], points[indices_[j]]);
        for (std::size_t k = j + 1; k < m; ++k) {
          turns_[i][j][k] = orientation(points[indices_[i]], points[indices_[j]], points[indices_[k]]);
        }
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return indices_.size(); }
  [[nodiscard]] const DoubleDouble& length_of(std::size_t i, std::size_t j) const { return lengths_[i][j]; }
  [[nodiscard]] Edge edge(std::size_t i, std::size_t j) const { return make_edge(indices_[i], indices_[j]); }

  // On which side of the line through i and k, i < k, point j lies: 1 above, -1 below, 0 on it.
  [[nodiscard]] int side(std::size_t i, std::size_t k, std::size_t j) const {
    if (j < i) return turns_[j][i][k];
    return j < k ? -turns_[i][j][k] : turns_[i][k][j];
  }

  // Whether i < j < k span a triangle without other points, boundary included.
  [[nodiscard]] bool is_empty_triangle(std::size_t i, std::size_t j, std::size_t k) const {
    const int turn = turns_[i][j][k];
    if (turn == 0) return false;
    for (std::size_t p = i + 1; p < k; ++p) {
      if (p == j) continue;
      const bool inside = side(i, j, p) * turn >= 0 && side(j, k, p) * turn >= 0 && side(i, k, p) * turn <= 0;
      if (inside) return false;
    }
    return true;
  }

  // The hull's chain below (which = -1) or above (1) all points, its collinear points included.
  [[nodiscard]] Path hull_chain(int which) const {
    std::vector<std::size_t> chain;
    for (std::size_t k = 0; k < size(); ++k) {
      while (chain.size() > 1 && turns_[chain[chain.size() - 2]][chain.back()][k] == which) chain.pop_back();
      chain.push_back(k);
    }
    Path path = 0;
    for (const std::size_t i : chain) path |= bit(i);
    return path;
  }

 private:
  std::vector<Index> indices_;
  std::array<std::array<DoubleDouble, kSize>, kSize> lengths_;
  std::array<std::array<std::array<int, kSize>, kSize>, kSize> turns_{};
};

// The least weight of what lies above each path, computed on first use.
class PathSearch {
 public:
  explicit PathSearch(const Leaf& leaf)
      : leaf_(leaf), upper_(leaf.hull_chain(1)), rest_(std::size_t{1} << leaf.size()) {
    rest_[upper_] = {DoubleDouble(), upper_, true};
  }

  std::vector<Edge> edges() {
    Path path = leaf_.hull_chain(-1);
    std::vector<Edge> result;
    append_edges(path, result);
    for (solve(path); path != upper_; path = rest_[path].next) append_edges(rest_[path].next, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

 private:
  struct Rest {
    DoubleDouble weight = std::numeric_limits<double>::infinity();
    Path next = 0;
    bool is_known = false;
  };

  void append_edges(Path path, std::vector<Edge>& edges) const {
    for (std::size_t i = 0, j = 0; i + 1 < leaf_.size(); i = j) {
      j = next_on(path, i);
      edges.push_back(leaf_.edge(i, j));
    }
  }

  DoubleDouble solve(Path path) {
    if (rest_[path].is_known) return rest_[path].weight;
    Rest best;
    for (std::size_t i = 0, j = 0; i + 1 < leaf_.size(); i = j) {
      j = next_on(path, i);
      try_corner(path, i, j, best);
      try_points_above(path, i, j, best);
    }
    best.is_known = true;
    rest_[path] = best;
    return best.weight;
  }

  // A triangle on two edges of the path, ij and the next: it turns left at j.
  void try_corner(Path path, std::size_t i, std::size_t j, Rest& best) {
    if (j + 1 >= leaf_.size()) return;
    const std::size_t k = next_on(path, j);
    if (leaf_.side(i, k, j) < 0 && leaf_.is_empty_triangle(i, j, k)) {
      take_if_better(path ^ bit(j), leaf_.length_of(i, k), best);
    }
  }

  // A triangle on edge ik of the path and a point above it.
  void try_points_above(Path path, std::size_t i, std::size_t k, Rest& best) {
    for (std::size_t j = i + 1; j < k; ++j) {
      if (leaf_.side(i, k, j) > 0 && leaf_.is_empty_triangle(i, j, k)) {
        take_if_better(path | bit(j), leaf_.length_of(i, j) + leaf_.length_of(j, k), best);
      }
    }
  }

  void take_if_better(Path next, const DoubleDouble& added, Rest& best) {
    const DoubleDouble weight = added + solve(next);
    if (weight < best.weight) best = {weight, next, false};
  }

  const Leaf& leaf_;
  Path upper_;
  std::vector<Rest> rest_;
};

}  // namespace

std::vector<Edge> minimum_weight_edges(Points points, std::span<const Index> chosen) {
  const Leaf leaf(points, chosen);
  return PathSearch(leaf).edges();
}

}  // namespace mwt
