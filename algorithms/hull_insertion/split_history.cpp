#include "algorithms/hull_insertion/split_history.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace mwt {

namespace {

bool is_polygon_part(const Triangle& corners) { return corners[2] == kNoIndex; }

}  // namespace

// A point, or a point moved by less than any distance away from another one.
struct SplitHistory::Place {
  const Point& at;
  const Point* away_from = nullptr;

  // Whether it lies left of the line from a to b, or on it.
  [[nodiscard]] bool is_left_or_on(const Point& a, const Point& b) const {
    const int turn = orientation(a, b, at);
    if (turn != 0 || away_from == nullptr) return turn >= 0;
    return orientation(a, b, *away_from) <= 0;
  }
};

SplitHistory::SplitHistory(Points points, const Triangle& triangle, std::size_t expected_points) : points_(points) {
  reserve(3 * expected_points);
  add_child(kNoIndex, triangle);
}

SplitHistory::SplitHistory(Points points, std::span<const Index> chain, std::span<const Triangle> triangles,
                           std::size_t expected_points)
    : points_(points) {
  reserve(2 * chain.size() + 3 * expected_points);
  add_child(kNoIndex, {chain.front(), chain.back(), kNoIndex});
  add_parts(0, chain, triangles);
}

void SplitHistory::reserve(std::size_t count) {
  regions_.reserve(count);
  paths_.reserve(count);
}

// Adds what lies below `region`, the part of the polygon between `chain` and its chord. Without recursion, for parts
// may be nested as deep as the polygon has vertices.
void SplitHistory::add_parts(Index region, std::span<const Index> chain, std::span<const Triangle> triangles) {
  struct Part {
    Index region;
    std::span<const Index> chain;
    std::span<const Triangle> triangles;
  };
  std::vector<Part> open = {{region, chain, triangles}};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    const Triangle& triangle = part.triangles.front();
    const auto apex = std::find(part.chain.begin(), part.chain.end(), triangle[1]);
    const auto middle = static_cast<std::size_t>(apex - part.chain.begin());
    const auto first = part.chain.first(middle + 1), last = part.chain.subspan(middle);
    const std::size_t first_count = first.size() - 2;  // triangles of a chain: its vertices less 2
    add_child(part.region, triangle);
    const auto child = static_cast<Index>(regions_.size());
    if (first.size() > 2) add_child(part.region, {first.front(), first.back(), kNoIndex});
    if (last.size() > 2) add_child(part.region, {last.front(), last.back(), kNoIndex});
    if (last.size() > 2) {
      open.push_back({first.size() > 2 ? child + 1 : child, last, part.triangles.subspan(1 + first_count)});
    }
    if (first.size() > 2) open.push_back({child, first, part.triangles.subspan(1, first_count)});
  }
}

void SplitHistory::add_child(Index parent, const Triangle& corners) {
  regions_.push_back({corners});
  const Index added = paths_.add(parent);
  if (parent == kNoIndex) return;
  if (regions_[parent].child_count++ == 0) regions_[parent].first_child = added;
}

bool SplitHistory::contains(Index region, const Place& place) const {
  const auto [a, b, c] = regions_[region].corners;
  if (is_polygon_part(regions_[region].corners)) return place.is_left_or_on(points_[b], points_[a]);
  return place.is_left_or_on(points_[a], points_[b]) && place.is_left_or_on(points_[b], points_[c]) &&
         place.is_left_or_on(points_[c], points_[a]);
}

// The triangle of the current list that holds `place`; any of them if it lies on a side.
Index SplitHistory::triangle_at(const Place& place) {
  const auto holds = [&](Index region) { return contains(region, place); };
  const auto child_that_holds = [&](Index region) {
    if (regions_[region].child_count == 0) return kNoIndex;
    Index child = regions_[region].first_child;
    const Index last = child + regions_[region].child_count - 1;
    while (child != last && !holds(child)) ++child;  // the children cover their parent: no need to test the last
    return child;
  };
  return paths_.find_deepest(holds, child_that_holds);
}

// Replaces a triangle by those between its sides and p. Returns the corner opposite the side on which p lies, or
// kNoIndex.
Index SplitHistory::split(Index region, Index p) {
  const Triangle triangle = regions_[region].corners;
  Index opposite = kNoIndex;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index from = triangle[i], to = triangle[(i + 1) % 3];
    if (orientation(points_[from], points_[to], points_[p]) > 0) {
      add_child(region, {from, to, p});
    } else {
      opposite = triangle[(i + 2) % 3];
    }
  }
  if (splits_ != nullptr) splits_->push_back({triangle, p, opposite});
  return opposite;
}

void SplitHistory::insert(Index p) {
  const Index opposite = split(triangle_at({points_[p]}), p);
  if (opposite == kNoIndex) return;
  ++edge_splits_;
  // The corner lies on this side of the edge, so a step away from it leads across.
  const Place across{points_[p], &points_[opposite]};
  if (!contains(0, across)) return;  // the edge lies on the boundary
  split(triangle_at(across), p);
  ++edge_splits_;
}

std::vector<Triangle> SplitHistory::triangles() const {
  std::vector<Triangle> list;
  std::vector<Index> open = {0};
  while (!open.empty()) {
    const Region& region = regions_[open.back()];
    open.pop_back();
    if (region.child_count == 0) list.push_back(region.corners);
    for (Index i = region.child_count; i-- > 0;) open.push_back(region.first_child + i);
  }
  return list;
}

std::size_t SplitHistory::depth() const {
  std::vector<Index> splits(regions_.size(), 0);
  for (std::size_t region = 0; region < regions_.size(); ++region) {  // parents come before their children
    const Index own = is_polygon_part(regions_[region].corners) ? 0 : 1;
    for (Index i = 0; i < regions_[region].child_count; ++i) {
      splits[regions_[region].first_child + i] = splits[region] + own;
    }
  }
  return *std::max_element(splits.begin(), splits.end());
}

}  // namespace mwt
