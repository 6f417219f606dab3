#include "algorithms/exact/cut_proof.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/walk_diagonals.h"
#include "algorithms/proof/dual_leaf.h"
#include "algorithms/proof/half_length.h"
#include "algorithms/proof/polygon_duals.h"
#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

// Checking a proof with more dual values would take too long.
constexpr std::size_t kMaxDuals = 20'000'000;

// What the region costs at least if nothing fits: more than any polygon's optimum.
constexpr std::int64_t kNeverFits = PolygonDuals::kNever;

class CutProof {
 public:
  CutProof(DualRegion& region, const LocalRegion& local, const Deadline& deadline)
      : region_(region), local_(local), deadline_(deadline) {
    for (const auto& [from, to] : region.open_edges) open_.push_back({region.places[from], region.places[to]});
    boundary_ = undirected_edges(local.boundary);
  }

  bool run() {
    choose_cuts();
    choose_unit();
    if (cuts_.size() * (open_.size() + 1) > kMaxDuals) return false;
    std::int64_t least = kNeverFits;
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (has_passed(deadline_)) return give_up();
      region_.tree.emplace_back().edge = cuts_[i];
      const auto bound = add_polygon_leaf(i);
      if (!bound) return give_up();
      least = std::min(least, *bound);
    }
    add_impossible_leaf();
    region_.lower_bound = std::max(0.0, next_down(std::ldexp(static_cast<double>(least), region_.unit_exponent)));
    return true;
  }

 private:
  using OpenEdge = std::uint32_t;  // position in open_

  bool give_up() {
    region_.tree.clear();
    return false;
  }

  // Turned by a quarter of a circle several times; which side of a line a point is on does not change.
  [[nodiscard]] Point turned(Index v) const {
    const Point& p = local_.points[v];
    switch (turns_) {
      case 0: return p;
      case 1: return {p.y, -p.x};
      case 2: return {-p.x, -p.y};
      default: return {-p.y, p.x};
    }
  }

  void choose_cuts() {
    DisjointSets components(local_.points.size());
    for (const Edge& edge : boundary_) components.unite(edge.a, edge.b);
    const std::size_t outer = components.find(0);  // the points are in lexicographic order
    std::optional<std::vector<OpenEdge>> fewest;
    for (const int turns : {0, 1, 2, 3}) {
      turns_ = turns;
      std::optional<Index> last;
      for (Index v = 0; v < local_.points.size(); ++v) {
        const bool is_inner = components.find(v) != outer;
        if (is_inner && (!last || lexicographically_less(turned(*last), turned(v)))) last = v;
      }
      std::vector<OpenEdge> cuts;
      for (OpenEdge e = 0; e < open_.size(); ++e) {
        const auto [a, b] = open_[e];
        if (a != *last && b != *last) continue;
        if (lexicographically_less(turned(*last), turned(a == *last ? b : a))) cuts.push_back(e);
      }
      if (fewest && fewest->size() <= cuts.size()) continue;
      fewest = std::move(cuts);
      best_turns_ = turns;
      from_ = *last;
    }
    turns_ = best_turns_;
    cuts_ = *std::move(fewest);
  }

  // The region as a polygon along cut i; what crosses it and the cuts before are no diagonals.
  std::optional<std::int64_t> add_polygon_leaf(std::size_t i) {
    const Edge cut = make_edge(open_[cuts_[i]].a, open_[cuts_[i]].b);
    std::vector<Edge> certain = boundary_;
    certain.push_back(cut);
    std::sort(certain.begin(), certain.end());
    std::vector<Edge> edges = certain;
    for (OpenEdge e = 0; e < open_.size(); ++e) {
      if (std::find(cuts_.begin(), cuts_.begin() + static_cast<std::ptrdiff_t>(i) + 1, e) !=
          cuts_.begin() + static_cast<std::ptrdiff_t>(i) + 1)
        continue;
      const auto& [a, b] = open_[e];
      if (!segments_cross(local_.points[a], local_.points[b], local_.points[cut.a], local_.points[cut.b]))
        edges.push_back(make_edge(a, b));
    }
    const CandidateGraph graph = make_candidate_graph(local_.points, edges, certain);
    const FaceWalker walker(graph);
    const Walk walk = walker.corners_of_face(cut);
    const auto diagonals = diagonals_of_walk(graph, walk);
    if (!diagonals) return {};
    std::vector<Index> corners;
    for (const Corner& corner : walk) corners.push_back(corner.vertex);
    return add_leaf_of(duals_.solve(local_.points, corners, *diagonals, region_.unit_exponent), cuts_[i]);
  }

  // For all polygons, so that no optimum has more than 57 bits.
  void choose_unit() {
    double longest = 0;
    for (const auto& [a, b] : open_) longest = std::max(longest, length(local_.points[a], local_.points[b]).high);
    const int diagonal_bits = std::ilogb(static_cast<double>(3 * local_.points.size())) + 1;
    region_.unit_exponent = std::ilogb(longest) + 1 - std::min(50, 56 - diagonal_bits);
  }

  std::int64_t add_leaf_of(const DualRegion& polygon, OpenEdge cut) {
    std::map<std::pair<Index, Index>, std::int64_t> dual_of;
    const DualNode& solved = polygon.tree.front();
    const std::vector<Index>& corners = polygon.places;
    for (std::size_t p = 0; p < corners.size(); ++p) {
      dual_of[{corners[p], corners[(p + 1) % corners.size()]}] = solved.side_duals[p];
    }
    for (std::size_t d = 0; d < polygon.open_edges.size(); ++d) {
      const Index a = corners[polygon.open_edges[d][0]], b = corners[polygon.open_edges[d][1]];
      dual_of[{a, b}] = solved.edge_duals[d];
      dual_of[{b, a}] = -solved.edge_duals[d];
    }
    // The polygon's sides cost nothing, but the cut costs as much on either side.
    const auto& [a, b] = open_[cut];
    const std::int64_t half =
        std::max<std::int64_t>(0, half_length(length(local_.points[a], local_.points[b]), region_.unit_exponent));
    dual_of[{a, b}] += half;
    dual_of[{b, a}] += half;
    add_leaf(region_, [&](Index from, Index to) {
      const auto found = dual_of.find({from, to});
      return found == dual_of.end() ? 0 : found->second;
    });
    return std::min(kNeverFits, solved.side_duals.back() + 2 * half);
  }

  // All cuts are out: around every triangle, the sides cross the ray from beyond `from_` as often one way as the other.
  void add_impossible_leaf() {
    add_leaf(region_, [&](Index from, Index to) {
      const Point a = turned(from), b = turned(to), u = turned(from_);
      if (from == from_ || to == from_) return std::int64_t{0};
      if (a.y <= u.y && u.y < b.y && orientation(a, b, u) > 0) return kNeverFits;
      if (b.y <= u.y && u.y < a.y && orientation(b, a, u) > 0) return -kNeverFits;
      return std::int64_t{0};
    });
  }

  DualRegion& region_;
  const LocalRegion& local_;
  const Deadline& deadline_;
  std::vector<Edge> open_;      // of the region, from first to second place
  std::vector<Edge> boundary_;  // undirected, each once
  int turns_ = 0, best_turns_ = 0;
  Index from_ = 0;
  std::vector<OpenEdge> cuts_;
  PolygonDuals duals_;
};

}  // namespace

bool add_cut_duals(DualRegion& region, const LocalRegion& local, const Deadline& deadline) {
  return CutProof(region, local, deadline).run();
}

}  // namespace mwt
