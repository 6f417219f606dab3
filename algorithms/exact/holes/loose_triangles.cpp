#include "algorithms/exact/holes/loose_triangles.h"

#include <algorithm>

#include "algorithms/exact/holes/triangle_emptiness.h"
#include "geometry/predicates.h"

namespace mwt {

LooseTriangles::LooseTriangles(const CutPolygon& polygon) : polygon_(polygon) {
  const CandidateGraph& graph = polygon.graph;
  origin_.resize(graph.target.size());
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) origin_[h] = v;
  }
  list_crossing(std::vector<bool>(graph.target.size(), true));
}

void LooseTriangles::list_crossing(const std::vector<bool>& is_alive) {
  crossing_.clear();
  for (std::uint32_t h = 0; h < polygon_.kind.size(); ++h) {
    const bool is_first = origin_[h] < polygon_.graph.target[h];
    if (is_first && is_alive[h] && polygon_.kind[h] == SideKind::crossing) crossing_.push_back(h);
  }
}

bool LooseTriangles::find(std::size_t limit, const Deadline& deadline) {
  std::vector<std::uint32_t> at_first(polygon_.graph.points.size(), kNoIndex);
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t h : crossing_) {
    add_triangles_of(h, at_first, touched);
    if (sides_.size() > limit || has_passed(deadline)) return false;
  }
  const TriangleEmptiness emptiness(polygon_.graph.points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i % 256 == 0 && has_passed(deadline)) return false;
    const auto& [a, b, c] = sides_[i];
    if (emptiness.is_empty(origin_[a], origin_[b], origin_[c])) sides_[kept++] = sides_[i];
  }
  sides_.resize(kept);
  file_triangles();
  list_straddling();
  return true;
}

bool LooseTriangles::may_be_sides(const Sides& sides) const {
  return std::all_of(sides.begin(), sides.end(),
                     [&](std::uint32_t side) { return polygon_.kind[side] != SideKind::outside; });
}

// Each loose triangle is found from its first crossing side in the order of crossing_.
void LooseTriangles::add_triangles_of(std::uint32_t halfedge, std::vector<std::uint32_t>& at_first,
                                      std::vector<std::uint32_t>& touched) {
  const CandidateGraph& graph = polygon_.graph;
  const Index a = origin_[halfedge], b = graph.target[halfedge];
  touched.clear();
  for (std::uint32_t h = graph.first[a]; h < graph.first[a + std::size_t{1}]; ++h) {
    at_first[graph.target[h]] = h;
    touched.push_back(graph.target[h]);
  }
  const auto is_earlier = [&](std::uint32_t side) {
    return polygon_.kind[side] == SideKind::crossing &&
           std::min(side, polygon_.twin[side]) < std::min(halfedge, polygon_.twin[halfedge]);
  };
  for (std::uint32_t bc = graph.first[b]; bc < graph.first[b + std::size_t{1}]; ++bc) {
    const Index c = graph.target[bc];
    const std::uint32_t ac = at_first[c];
    if (ac == kNoIndex || is_earlier(ac) || is_earlier(bc)) continue;
    const int turn = orientation(graph.points[a], graph.points[b], graph.points[c]);
    const Sides left{halfedge, bc, polygon_.twin[ac]};
    const Sides right{polygon_.twin[halfedge], ac, polygon_.twin[bc]};
    const auto& sides = turn > 0 ? left : right;
    if (turn != 0 && may_be_sides(sides)) sides_.push_back(sides);
  }
  for (const Index v : touched) at_first[v] = kNoIndex;
}

// By each of their crossing sides.
void LooseTriangles::file_triangles() {
  slot_.assign(polygon_.kind.size(), kNoIndex);
  std::uint32_t slots = 0;
  for (const std::uint32_t h : crossing_) {
    slot_[h] = slots++;
    slot_[polygon_.twin[h]] = slots++;
  }
  filed_ = file_in_rows<Number>(slots, [&](const auto& file) {
    for (Number t = 0; t < sides_.size(); ++t) {
      for (const std::uint32_t side : sides_[t]) {
        if (slot_[side] != kNoIndex) file(slot_[side], t);
      }
    }
  });
}

void LooseTriangles::list_straddling() {
  const CandidateGraph& graph = polygon_.graph;
  std::vector<std::vector<std::pair<std::uint32_t, Index>>> cuts_at(graph.points.size());  // cut * 2 + end, other end
  for (std::uint32_t cut = 0; cut < polygon_.cuts.size(); ++cut) {
    const auto [a, b] = polygon_.cuts[cut];
    cuts_at[a].emplace_back(2 * cut, b);
    cuts_at[b].emplace_back(2 * cut + 1, a);
  }
  ends_.assign(polygon_.cuts.size(), {});
  for (Number t = 0; t < sides_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index corner = origin_[sides_[t][i]];
      const Index next = graph.target[sides_[t][i]], last = origin_[sides_[t][(i + 2) % 3]];
      for (const auto& [end, other] : cuts_at[corner]) {
        const bool is_inside = orientation(graph.points[corner], graph.points[next], graph.points[other]) > 0 &&
                               orientation(graph.points[corner], graph.points[other], graph.points[last]) > 0;
        if (is_inside) ends_[end / 2][end % 2].push_back(t);
      }
    }
  }
}

std::vector<LooseTriangles::Number> LooseTriangles::keep_alive(const std::vector<bool>& is_alive) {
  std::vector<Number> kept;
  const std::size_t before = sides_.size();
  for (Number t = 0; t < sides_.size(); ++t) {
    const bool alive =
        std::all_of(sides_[t].begin(), sides_[t].end(), [&](std::uint32_t side) { return is_alive[side]; });
    if (!alive) continue;
    sides_[kept.size()] = sides_[t];
    kept.push_back(t);
  }
  if (kept.size() == before) return kept;
  sides_.resize(kept.size());
  list_crossing(is_alive);
  file_triangles();
  list_straddling();
  return kept;
}

}  // namespace mwt
