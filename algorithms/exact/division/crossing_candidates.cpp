#include "algorithms/exact/division/crossing_candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

#include "algorithms/exact/candidates/kd_order.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr Index kGroup = 8;  // consecutive vertices with their certain edges make a leaf of the tree

Box empty_box() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {kInfinity, kInfinity, -kInfinity, -kInfinity};
}

void include(Box& box, const Point& p) {
  box = {std::min(box.min_x, p.x), std::min(box.min_y, p.y), std::max(box.max_x, p.x), std::max(box.max_y, p.y)};
}

Box union_of(const Box& a, const Box& b) {
  return {std::min(a.min_x, b.min_x), std::min(a.min_y, b.min_y), std::max(a.max_x, b.max_x),
          std::max(a.max_y, b.max_y)};
}

bool meet(const Box& a, const Box& b) {
  return a.min_x <= b.max_x && b.min_x <= a.max_x && a.min_y <= b.max_y && b.min_y <= a.max_y;
}

Box box_of(const Point& p, const Point& q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

// Whether the whole box lies strictly on one side of the line through p and q.
bool lies_beside(const Box& box, const Point& p, const Point& q) {
  const Point corners[] = {
      {box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}};
  const int side = orientation(p, q, corners[0]);
  return side != 0 && std::all_of(std::begin(corners) + 1, std::end(corners),
                                  [&](const Point& corner) { return orientation(p, q, corner) == side; });
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const CandidateGraph& graph)
      : graph_(graph), groups_((static_cast<Index>(graph.points.size()) + kGroup - 1) / kGroup) {
    collect_certain_edges();
    leaves_ = std::bit_ceil(groups_);
    boxes_.assign(2 * std::size_t{leaves_}, empty_box());
    tbb::parallel_for(Index{0}, groups_, [&](Index group) { boxes_[leaves_ + group] = box_of_group(group); });
    for (std::size_t node = leaves_ - 1; node >= 1; --node) {
      boxes_[node] = union_of(boxes_[2 * node], boxes_[2 * node + 1]);
    }
  }

  // A certain edge that edge uv crosses, or a point, as an edge to itself, that it passes through.
  [[nodiscard]] std::optional<Edge> find_crossed(Index u, Index v) const {
    const Point& p = graph_.points[u];
    const Point& q = graph_.points[v];
    const Box box = box_of(p, q);
    std::uint32_t stack[64] = {1};  // a path in the tree and its siblings
    std::size_t height = 1;
    while (height > 0) {
      const std::uint32_t node = stack[--height];
      if (!meet(box, boxes_[node]) || (node < leaves_ && lies_beside(boxes_[node], p, q))) continue;
      if (node >= leaves_) {
        if (const auto crossed = find_crossed_in_group(node - leaves_, u, v, box)) return crossed;
      } else {
        stack[height++] = 2 * node + 1;
        stack[height++] = 2 * node;
      }
    }
    return {};
  }

 private:
  [[nodiscard]] Index end_of(Index group) const {
    return std::min((group + 1) * kGroup, static_cast<Index>(graph_.points.size()));
  }

  void collect_certain_edges() {
    first_.push_back(0);
    for (Index a = 0; a < graph_.points.size(); ++a) {
      for (std::uint32_t i = graph_.first[a]; i < graph_.first[a + std::size_t{1}]; ++i) {
        if (graph_.certain[i] != 0 && a < graph_.target[i]) later_end_.push_back(graph_.target[i]);
      }
      first_.push_back(static_cast<std::uint32_t>(later_end_.size()));
    }
  }

  [[nodiscard]] std::span<const Index> later_ends(Index a) const {
    return std::span(later_end_).subspan(first_[a], first_[a + std::size_t{1}] - first_[a]);
  }

  // Of its points and the certain edges from them to later ones.
  [[nodiscard]] Box box_of_group(Index group) const {
    Box box = empty_box();
    for (Index a = group * kGroup; a < end_of(group); ++a) {
      include(box, graph_.points[a]);
      for (const Index b : later_ends(a)) include(box, graph_.points[b]);
    }
    return box;
  }

  [[nodiscard]] std::optional<Edge> find_crossed_in_group(Index group, Index u, Index v, const Box& box) const {
    const Point& p = graph_.points[u];
    const Point& q = graph_.points[v];
    for (Index a = group * kGroup; a < end_of(group); ++a) {
      const Point& r = graph_.points[a];
      if (a == u || a == v) continue;
      if (meet(box, box_of(r, r)) && in_segment_interior(r, p, q)) return Edge{a, a};
      for (const Index b : later_ends(a)) {
        if (b == u || b == v) continue;
        const Point& s = graph_.points[b];
        if (meet(box, box_of(r, s)) && segments_cross(p, q, r, s)) return Edge{a, b};
      }
    }
    return {};
  }

  const CandidateGraph& graph_;
  std::uint32_t groups_;
  std::uint32_t leaves_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<Index> later_end_;  // of the certain edges from their earlier ends
  std::vector<Box> boxes_;        // by node: node i has children 2i and 2i + 1
};

// Removes the values at these positions, which ascend.
template <class Value>
void close_gaps(std::vector<Value>& values, const std::vector<std::uint32_t>& positions) {
  if (positions.empty()) return;
  auto end = values.begin() + positions.front();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto from = values.begin() + positions[i] + 1;
    const auto to = i + 1 < positions.size() ? values.begin() + positions[i + 1] : values.end();
    end = std::move(from, to, end);
  }
  values.erase(end, values.end());
}

}  // namespace

std::optional<std::vector<Edge>> find_crossing_candidates(const CandidateGraph& graph, std::span<const Edge> suspects,
                                                          const Deadline& deadline, std::vector<Edge>* crossed) {
  constexpr std::size_t kSuspectsPerDeadlineCheck = 64;
  std::vector<Edge> crossing;
  if (suspects.empty()) return crossing;
  const CrossingSearch search(graph);
  std::vector<std::optional<Edge>> found(suspects.size());
  std::atomic<bool> is_late = false;
  tbb::parallel_for(std::size_t{0}, suspects.size(), [&](std::size_t i) {
    if (i % kSuspectsPerDeadlineCheck == 0 && has_passed(deadline)) is_late = true;
    if (!is_late) found[i] = search.find_crossed(suspects[i].a, suspects[i].b);
  });
  if (is_late) return {};
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    if (!found[i]) continue;
    crossing.push_back(suspects[i]);
    if (crossed != nullptr) crossed->push_back(*found[i]);
  }
  return crossing;
}

void remove_edges(CandidateGraph& graph, std::span<const Edge> edges) {
  std::vector<std::uint32_t> removed;  // halfedges
  const auto note = [&](Index from, Index to) {
    const auto star = graph.star(from);
    const auto place = std::find(star.begin(), star.end(), to);
    if (place != star.end()) removed.push_back(graph.first[from] + static_cast<std::uint32_t>(place - star.begin()));
  };
  for (const Edge& edge : edges) {
    note(edge.a, edge.b);
    note(edge.b, edge.a);
  }
  std::sort(removed.begin(), removed.end());
  close_gaps(graph.target, removed);
  close_gaps(graph.certain, removed);
  std::size_t before = 0;
  for (std::uint32_t& first : graph.first) {
    while (before < removed.size() && removed[before] < first) ++before;
    first -= static_cast<std::uint32_t>(before);
  }
}

}  // namespace mwt
