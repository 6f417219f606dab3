// A set of undirected edges between points 0 .. n - 1, as sorted lists of neighbours.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/point.h"

namespace mwt::verifier {

class EdgeSet {
 public:
  explicit EdgeSet(std::size_t points) : stars_(points) {}

  /// Ascending.
  [[nodiscard]] const std::vector<Index>& star(Index v) const { return stars_[v]; }
  [[nodiscard]] std::size_t point_count() const { return stars_.size(); }

  [[nodiscard]] bool contains(Index a, Index b) const {
    if (stars_[b].size() < stars_[a].size()) std::swap(a, b);
    return std::binary_search(stars_[a].begin(), stars_[a].end(), b);
  }

  /// Does nothing if the edge is there.
  void insert(Index a, Index b) {
    insert_at(a, b);
    insert_at(b, a);
  }

  /// Does nothing if the edge is not there.
  void erase(Index a, Index b) {
    erase_at(a, b);
    erase_at(b, a);
  }

  /// The points joined to both, ascending.
  void common_neighbours(Index a, Index b, std::vector<Index>& common) const {
    common.clear();
    std::set_intersection(stars_[a].begin(), stars_[a].end(), stars_[b].begin(), stars_[b].end(),
                          std::back_inserter(common));
  }

 private:
  void insert_at(Index a, Index b) {
    const auto place = std::lower_bound(stars_[a].begin(), stars_[a].end(), b);
    if (place == stars_[a].end() || *place != b) stars_[a].insert(place, b);
  }

  void erase_at(Index a, Index b) {
    const auto place = std::lower_bound(stars_[a].begin(), stars_[a].end(), b);
    if (place != stars_[a].end() && *place == b) stars_[a].erase(place);
  }

  std::vector<std::vector<Index>> stars_;
};

}  // namespace mwt::verifier
