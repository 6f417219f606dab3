#include "algorithms/two_chains/chain_pair.h"

#include <algorithm>

#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

std::vector<Point> points_at(Points points, std::span<const Index> indices) {
  std::vector<Point> selected;
  selected.reserve(indices.size());
  for (const Index i : indices) selected.push_back(points[i]);
  return selected;
}

// The boundary of the points' own hull, counter-clockwise; along the line if they are collinear.
std::vector<Index> own_hull(Points points, std::span<const Index> indices) {
  std::vector<Index> cycle = convex_hull(points_at(points, indices));
  for (Index& i : cycle) i = indices[i];
  return cycle;
}

bool is_in_convex_position(Points points, std::span<const Index> indices) {
  return own_hull(points, indices).size() == indices.size();
}

// The smallest count in first .. last for which `holds` does, last + 1 if none; it must not become false again.
template <class Predicate>
std::size_t min_with(std::size_t first, std::size_t last, const Predicate& holds) {
  std::size_t end = last + 1;
  while (first < end) {
    const std::size_t middle = first + (end - first) / 2;
    if (holds(middle)) {
      end = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

class ChainPairSearch {
 public:
  ChainPairSearch(Points points, const Deadline& deadline) : points_(points), deadline_(deadline) {}

  std::optional<ChainPair> run() const {
    const std::vector<Index> hull = convex_hull(points_);
    if (hull.size() != 4 || points_.size() == 4) return std::nullopt;
    std::optional<ChainPair> pair = with_bridge(hull[0], hull[1], hull[2], hull[3]);
    return pair ? pair : with_bridge(hull[1], hull[2], hull[3], hull[0]);
  }

 private:
  // The bridges are start - end and other_start - other_end. Seen from `start`, the points of the second chain come
  // before those of the first in counter-clockwise order, by property (3) for the edge of the first that begins there.
  // Parts of sets in convex position are in convex position, so that the sizes that are possible form a range.
  [[nodiscard]] std::optional<ChainPair> with_bridge(Index start, Index end, Index other_start, Index other_end) const {
    const std::vector<Index> order = around(start, end);
    const std::span<const Index> all = order;
    const auto first_of = [&](std::size_t second_size) {
      std::vector<Index> first(all.begin() + static_cast<std::ptrdiff_t>(second_size), all.end());
      first.push_back(start);
      return first;
    };
    const std::size_t smallest =
        min_with(2, all.size() - 1, [&](std::size_t size) { return is_in_convex_position(points_, first_of(size)); });
    const std::size_t beyond =
        min_with(2, all.size() - 1, [&](std::size_t size) { return !is_in_convex_position(points_, all.first(size)); });
    for (std::size_t size = smallest; size < beyond && !has_passed(deadline_); ++size) {
      ChainPair pair{chain_from(start, first_of(size)), chain_from(other_start, all.first(size))};
      const bool has_ends = pair.first.front() == start && pair.first.back() == other_end &&
                            pair.second.front() == other_start && pair.second.back() == end;
      if (has_ends && faces(pair.first, pair.second) && faces(pair.second, pair.first)) return pair;
    }
    return std::nullopt;
  }

  // All other points, counter-clockwise around `start` from `end` on.
  [[nodiscard]] std::vector<Index> around(Index start, Index end) const {
    std::vector<Index> order;
    order.reserve(points_.size() - 1);
    for (Index i = 0; i < points_.size(); ++i) {
      if (i != start) order.push_back(i);
    }
    const Point& pivot = points_[start];
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      if (a == end || b == end) return a == end && b != end;
      const int turn = orientation(pivot, points_[a], points_[b]);
      return turn != 0 ? turn > 0 : compare_length(pivot, points_[a], pivot, points_[b]) < 0;
    });
    return order;
  }

  // The points, which are in convex position, counter-clockwise from `start` on if it is one of them.
  [[nodiscard]] std::vector<Index> chain_from(Index start, std::span<const Index> indices) const {
    std::vector<Index> chain = own_hull(points_, indices);
    if (all_collinear(points_at(points_, indices))) {
      if (chain.front() != start) std::reverse(chain.begin(), chain.end());
      return chain;
    }
    const auto first = std::find(chain.begin(), chain.end(), start);
    if (first != chain.end()) std::rotate(chain.begin(), first, chain.end());
    return chain;
  }

  // Property (3) for the edges of `chain`; false as well if the deadline passes first.
  [[nodiscard]] bool faces(const std::vector<Index>& chain, const std::vector<Index>& others) const {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (has_passed(deadline_)) return false;
      const Point &a = points_[chain[i]], &b = points_[chain[i + 1]];
      for (const Index other : others) {
        if (orientation(a, b, points_[other]) >= 0) return false;
      }
    }
    return true;
  }

  Points points_;
  Deadline deadline_;
};

}  // namespace

std::optional<ChainPair> find_chain_pair(Points points, const Deadline& deadline) {
  return ChainPairSearch(points, deadline).run();
}

}  // namespace mwt
