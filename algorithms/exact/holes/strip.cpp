#include "algorithms/exact/holes/strip.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

using Place = Strip::Place;

class StripBuilder {
 public:
  StripBuilder(Points points, const FaceRegion& region)
      : points_(points),
        boundary_(undirected_edges(region.in_places(region.boundary))),
        candidates_(region.in_places(region.candidates)) {}

  std::optional<Strip> run() {
    if (!choose_cut()) return {};
    walk_around_the_cut_face();
    if (!lay_out_chains() || !file_candidates()) return {};
    for (auto* places : {&strip_.outer.chord, &strip_.inner.chord, &strip_.across}) {
      for (auto& row : *places) std::sort(row.begin(), row.end());
    }
    return std::move(strip_);
  }

 private:
  // The shortest candidate between the components, from the outer one.
  bool choose_cut() {
    DisjointSets components(points_.size());
    for (const Edge& edge : boundary_) components.unite(edge.a, edge.b);
    const auto first = std::min_element(points_.begin(), points_.end(), lexicographically_less);
    const std::size_t outer = components.find(static_cast<std::size_t>(first - points_.begin()));
    std::optional<Edge> shortest;
    for (const Edge& edge : candidates_) {
      if (components.find(edge.a) == components.find(edge.b)) continue;
      if (!shortest || compare_edge_lengths(points_, edge, *shortest) < 0) shortest = edge;
    }
    if (!shortest) return false;
    cut_ = components.find(shortest->a) == outer ? *shortest : Edge{shortest->b, shortest->a};
    return true;
  }

  // Of the face as the cut leaves it, beginning at the cut's outer end and ending at its inner one.
  void walk_around_the_cut_face() {
    std::vector<Edge> certain = boundary_;
    certain.push_back(make_edge(cut_.a, cut_.b));
    std::vector<Edge> edges = candidates_;
    edges.insert(edges.end(), boundary_.begin(), boundary_.end());
    std::sort(certain.begin(), certain.end());
    graph_ = make_candidate_graph(points_, undirected_edges(std::move(edges)), certain);
    walker_.emplace(graph_);
    corners_ = walker_->corners_of_face(Edge{cut_.b, cut_.a});
    for (std::size_t i = 0; i < corners_.size(); ++i) position_.emplace(corners_[i].halfedge, static_cast<Place>(i));
  }

  // Outer places are positions 0 .. p in the walk, inner places q .. 0 positions p + 1 .. p + 1 + q.
  bool lay_out_chains() {
    const auto leaves_by_cut = [&](const Corner& corner) {
      return corner.vertex == cut_.a && graph_.target[corner.halfedge] == cut_.b;
    };
    const auto at_cut = std::find_if(corners_.begin(), corners_.end(), leaves_by_cut);
    if (at_cut == corners_.end()) return false;
    outer_ = static_cast<Place>(at_cut - corners_.begin());
    inner_ = static_cast<Place>(corners_.size()) - 2 - outer_;
    strip_.outer.chord.resize(static_cast<std::size_t>(outer_));
    strip_.inner.chord.resize(static_cast<std::size_t>(inner_));
    strip_.across.resize(static_cast<std::size_t>(outer_));
    for (Place a = 0; a < outer_; ++a) {
      strip_.outer.vertex.push_back(corners_[static_cast<std::size_t>(a)].vertex);
      strip_.outer.chord[static_cast<std::size_t>(a)].push_back(a + 1);
    }
    for (Place s = 0; s < std::max(inner_, 1); ++s) {
      strip_.inner.vertex.push_back(corners_[static_cast<std::size_t>(outer_ + 1 + inner_ - s)].vertex);
      if (inner_ > 0) strip_.inner.chord[static_cast<std::size_t>(s)].push_back(s + 1);
    }
    strip_.across[0].push_back(0);
    return outer_ > 0;
  }

  [[nodiscard]] bool is_outer(Place position) const { return position <= outer_; }
  [[nodiscard]] Place inner_place(Place position) const { return outer_ + 1 + inner_ - position; }

  bool file_candidates() {
    for (Place from = 0; from < static_cast<Place>(corners_.size()); ++from) {
      const Corner& corner = corners_[static_cast<std::size_t>(from)];
      for (std::uint32_t i = 0; i < corner.candidates; ++i) {
        const Index target = candidate_of(graph_, corner, i);
        const auto found = position_.find(walker_->corner_towards(target, corner.vertex).halfedge);
        if (found == position_.end()) return false;
        const bool is_first_end = from < found->second;
        if (is_first_end && !file(from, found->second)) return false;
      }
    }
    return true;
  }

  // A candidate between two positions of the walk, from < to. One that crosses the cut leads on into a neighbouring
  // copy.
  bool file(Place from, Place to) {
    const Index v = corners_[static_cast<std::size_t>(from)].vertex, w = corners_[static_cast<std::size_t>(to)].vertex;
    const bool crosses = segments_cross(points_[v], points_[w], points_[cut_.a], points_[cut_.b]);
    if (is_outer(to)) {
      if (crosses) {
        add(strip_.outer, to, from + outer_);
      } else {
        add(strip_.outer, from, to);
      }
    } else if (!is_outer(from)) {
      if (crosses) {
        add(strip_.inner, inner_place(from), inner_place(to) + inner_);
      } else {
        add(strip_.inner, inner_place(to), inner_place(from));
      }
    } else {
      // Seen from the outer end, the cut is crossed at the copy's end or at its beginning.
      const Place turns = crosses ? orientation(points_[cut_.a], points_[cut_.b], points_[v]) : 0;
      if (crosses && turns == 0) return false;
      add_across(from, inner_place(to) + turns * inner_);
    }
    return true;
  }

  void add(Strip::Chain& chain, Place from, Place to) {
    const Place shift = from < chain.period() ? 0 : chain.period();
    if (to - from > 0 && to - from < chain.period())
      chain.chord[static_cast<std::size_t>(from - shift)].push_back(to - shift);
  }

  void add_across(Place outer, Place inner) {
    if (outer == outer_) {
      outer = 0;
      inner -= inner_;
    }
    strip_.across[static_cast<std::size_t>(outer)].push_back(inner);
  }

  Points points_;
  std::vector<Edge> boundary_;    // undirected, each once
  std::vector<Edge> candidates_;  // a < b
  Edge cut_;                      // from the outer component to the inner one
  CandidateGraph graph_;
  std::optional<FaceWalker> walker_;
  Walk corners_;
  std::unordered_map<std::uint32_t, Place> position_;  // of the corner that begins with this halfedge
  Place outer_ = 0;
  Place inner_ = 0;
  Strip strip_;
};

}  // namespace

std::optional<Strip> make_strip(Points points, const FaceRegion& region) { return StripBuilder(points, region).run(); }

std::vector<CrossEdge> unavoidable_edges(Points points, const Strip& strip) {
  const std::vector<Index>& inner = strip.inner.vertex;
  std::optional<std::vector<CrossEdge>> fewest;
  for (const auto is_before : {lexicographically_less, colexicographically_less}) {
    const auto by_order = [&](Index a, Index b) { return is_before(points[a], points[b]); };
    const auto [least, most] = std::minmax_element(inner.begin(), inner.end(), by_order);
    for (const bool later : {false, true}) {
      const Index u = later ? *most : *least;
      std::vector<CrossEdge> edges;
      for (Place a = 0; a < strip.outer.period(); ++a) {
        const Index v = strip.outer.vertex_at(a);
        if (later ? by_order(v, u) : by_order(u, v)) continue;
        for (const Place s : strip.across[static_cast<std::size_t>(a)]) {
          if (strip.inner.vertex_at(s) == u) edges.push_back({a, s});
        }
      }
      if (!fewest || edges.size() < fewest->size()) fewest = std::move(edges);
    }
  }
  return *fewest;
}

}  // namespace mwt
