#include "algorithms/exact/proof/cut_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/holes/cut_polygon.h"
#include "algorithms/exact/holes/loose_triangles.h"
#include "algorithms/exact/proof/outlined_region.h"
#include "algorithms/proof/dual_leaf.h"
#include "algorithms/proof/polygon_duals.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// A proof file takes dual values below this (verifier/FORMAT.md).
constexpr std::int64_t kMaxDual = std::int64_t{1} << 60;

constexpr std::size_t kMaxLooseTriangles = std::size_t{1} << 24;
constexpr int kMaxSweeps = 200;
constexpr int kMaxRounds = 8;

using Cost = std::int64_t;
using Halfedge = std::uint32_t;

// The sides of triangles that hold the point beside a cut's first piece, to its left, cross the ray from there in
// positive x-direction once more outwards.
class RayBesideCut {
 public:
  // From the cut's end `from`; `left_of_cut`: seen towards `to`.
  RayBesideCut(Points points, Index from, Index to, bool left_of_cut)
      : points_(points), from_(from), to_(to), left_of_cut_(left_of_cut) {
    const Point &a = points[from], &b = points[to];
    is_above_ = b.y != a.y ? b.y > a.y : (b.x > a.x) == left_of_cut;
  }

  // 1 outwards, for the triangle on the left of the side; -1 inwards; 0 if it does not cross the ray.
  [[nodiscard]] int crossing(Index first, Index second) const {
    const bool first_above = is_above(first), second_above = is_above(second);
    if (first_above == second_above) return 0;
    const int side = second_above ? side_of_start(first, second) : side_of_start(second, first);
    return side <= 0 ? 0 : second_above ? 1 : -1;
  }

 private:
  // The ray, for points that are not on it.
  [[nodiscard]] bool is_above(Index v) const {
    const double y = points_[v].y, own = points_[from_].y;
    return y != own ? y > own : !is_above_;
  }

  // Of the directed line through two points, the ray's start: 1 left, -1 right.
  [[nodiscard]] int side_of_start(Index low, Index high) const {
    const Point &p = points_[low], &q = points_[high];
    if (low != from_ && high != from_) return orientation(p, q, points_[from_]);
    const int side = orientation(p, q, points_[to_]);
    if (side != 0) return side;
    return (low == from_) == left_of_cut_ ? 1 : -1;  // along the cut
  }

  Points points_;
  Index from_, to_;
  bool left_of_cut_;
  bool is_above_;  // the start, points at the cut's end's height
};

class CutProof {
 public:
  CutProof(DualRegion& region, const LocalRegion& local, std::size_t components, const Deadline& deadline)
      : region_(region), local_(local), outlined_(region, local), components_(components), deadline_(deadline) {}

  bool run(std::span<const Edge> known) {
    const FaceRegion face = outlined_.as_face(components_);
    FaceRegion cuttable = face;
    if (!known.empty()) cuttable.candidates.assign(known.begin(), known.end());
    std::vector<Edge> cuts = shortest_cuts(local_.points, cuttable);
    if (cuts.size() + 1 != face.components) return false;
    polygon_ = cut_open(local_.points, face, std::move(cuts), deadline_);
    if (!polygon_ || !polygon_->program.is_feasible(polygon_->program.closing_cell())) return false;
    const double whole = polygon_->program.value(polygon_->program.closing_cell()).high;
    outlined_.choose_unit(whole + total_length(local_.points, polygon_->cuts));
    if (!set_costs()) return false;
    loose_.emplace(*polygon_);
    if (!loose_->find(kMaxLooseTriangles, deadline_)) return false;
    paid_by_.assign(loose_->size(), 0);
    for (int round = 0; round < kMaxRounds && !is_paid() && !has_passed(deadline_); ++round) {
      balance();
      for (std::size_t cut = 0; cut < unpaid_.size(); ++cut) charge(cut);
    }
    balance();  // charges made cuts cheaper as sides
    const Cost least = worst();
    const auto triangles = static_cast<Cost>(face.triangle_count());
    if (least < -(whole_ + paid_) / triangles) return false;  // proves nothing; and no product overflows
    const Cost bound = whole_ + paid_ + least * triangles;
    if (!set_duals()) return false;
    outlined_.prove(bound);
    return region_.lower_bound > 0;
  }

 private:
  [[nodiscard]] Index origin(Halfedge h) const { return origin_[h]; }

  [[nodiscard]] Halfedge find(Index from, Index to) const {
    const auto begin = by_target_.begin() + polygon_->graph.first[from];
    const auto end = by_target_.begin() + polygon_->graph.first[from + std::size_t{1}];
    return std::lower_bound(begin, end, to, [&](Halfedge h, Index v) { return polygon_->graph.target[h] < v; })[0];
  }

  void sort_by_target() {
    const CandidateGraph& graph = polygon_->graph;
    origin_.resize(graph.target.size());
    by_target_.resize(graph.target.size());
    std::iota(by_target_.begin(), by_target_.end(), Halfedge{0});
    for (Index v = 0; v < graph.points.size(); ++v) {
      const std::uint32_t begin = graph.first[v], end = graph.first[v + std::size_t{1}];
      std::fill(origin_.begin() + begin, origin_.begin() + end, v);
      std::sort(by_target_.begin() + begin, by_target_.begin() + end,
                [&](Halfedge g, Halfedge h) { return graph.target[g] < graph.target[h]; });
    }
  }

  bool set_costs() {
    const IntervalProgram& program = polygon_->program;
    sort_by_target();
    const std::optional<std::vector<Cost>> chord_duals = solve_polygon();
    if (!chord_duals) return false;
    for (Halfedge h = 0; h < origin_.size(); ++h) {
      half_.push_back(polygon_->kind[h] == SideKind::boundary ? 0
                                                              : outlined_.half(origin(h), polygon_->graph.target[h]));
      const bool is_chord = polygon_->kind[h] == SideKind::chord;
      const Cost dual = is_chord ? (*chord_duals)[polygon_->cell[h]] : 0;
      cost_.push_back(half_[h] + (is_chord && !polygon_->is_lower[h] ? -dual : dual));
    }
    cost_[find(program.vertex(program.size() - 1), program.vertex(0))] = -whole_;
    for (const Edge& cut : polygon_->cuts) {
      cut_halfedge_.push_back(find(cut.a, cut.b));
      unpaid_.push_back(2 * half_[cut_halfedge_.back()]);
    }
    return true;
  }

  // By cell of the polygon's program: the dual value of its side towards what it cuts off.
  std::optional<std::vector<Cost>> solve_polygon() {
    const IntervalProgram& program = polygon_->program;
    std::vector<Index> corners;
    std::vector<std::array<std::uint32_t, 2>> diagonals;
    std::vector<IntervalProgram::Cell> cells;
    for (IntervalProgram::Position from = 0; from < program.size(); ++from) {
      corners.push_back(program.vertex(from));
      const auto [begin, end] = program.row(from);
      for (IntervalProgram::Cell cell = begin; cell < end; ++cell) {
        const IntervalProgram::Position to = program.to(cell);
        if (to == from + 1 || cell == program.closing_cell() || !program.is_feasible(cell)) continue;
        diagonals.push_back({from, to});
        cells.push_back(cell);
      }
    }
    const auto solved = PolygonDuals().solve(local_.points, corners, diagonals, deadline_, region_.unit_exponent);
    if (!solved) return {};
    const DualNode& leaf = solved->tree.front();
    whole_ = leaf.side_duals.back();
    if (whole_ >= PolygonDuals::kNever) return {};
    std::vector<Cost> duals(program.cell_count(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) duals[cells[i]] = -leaf.edge_duals[i];
    return duals;
  }

  [[nodiscard]] Cost reduced_cost(LooseTriangles::Number triangle) const {
    const auto& [a, b, c] = loose_->sides(triangle);
    return cost_[a] + cost_[b] + cost_[c] - paid_by_[triangle];
  }

  [[nodiscard]] std::optional<Cost> min_of(std::span<const LooseTriangles::Number> triangles) const {
    if (triangles.empty()) return {};
    Cost least = std::numeric_limits<Cost>::max();
    for (const LooseTriangles::Number t : triangles) least = std::min(least, reduced_cost(t));
    return least;
  }

  // Edges with triangles on one side only are in no triangulation: that side pays for them.
  void balance() {
    for (int sweep = 0; sweep < kMaxSweeps && !has_passed(deadline_); ++sweep) {
      Cost largest = 0;
      for (const Halfedge h : loose_->crossing()) {
        const Halfedge twin = polygon_->twin[h];
        const std::optional<Cost> left = min_of(loose_->left_of(h)), right = min_of(loose_->left_of(twin));
        if (!left && !right) continue;
        const Cost change = !left    ? std::min<Cost>(0, *right)
                            : !right ? std::max<Cost>(0, -*left)
                                     : (*right - *left) / 2;
        cost_[h] += change;
        cost_[twin] -= change;
        largest = std::max(largest, std::abs(change));
      }
      if (largest <= 1) return;
    }
  }

  [[nodiscard]] bool is_paid() const {
    return std::all_of(unpaid_.begin(), unpaid_.end(), [](Cost rest) { return rest <= 1; });
  }

  void charge(std::size_t cut) {
    std::array<Cost, 2> offer{};
    for (const std::size_t end : {0U, 1U})
      offer[end] = std::max<Cost>(0, min_of(loose_->straddling(cut, end)).value_or(unpaid_[cut]));
    const Cost pay = std::min(unpaid_[cut], offer[0] + offer[1]);
    if (pay <= 0) return;
    const double part = static_cast<double>(offer[0]) / static_cast<double>(offer[0] + offer[1]);
    const Cost first = std::min(offer[0], static_cast<Cost>(part * static_cast<double>(pay)));
    const std::array<Cost, 2> shares{first, std::min(offer[1], pay - first)};
    for (const std::size_t end : {0U, 1U}) {
      for (const LooseTriangles::Number t : loose_->straddling(cut, end)) paid_by_[t] += shares[end];
      unpaid_[cut] -= shares[end];
      paid_ += shares[end];
      if (shares[end] > 0) charges_.push_back({cut, end, shares[end]});
    }
    const Halfedge h = cut_halfedge_[cut];
    cost_[h] = unpaid_[cut] / 2;
    cost_[polygon_->twin[h]] = unpaid_[cut] - cost_[h];
  }

  // Of all triangles; those of chords cost nothing or more.
  [[nodiscard]] Cost worst() const {
    Cost least = 0;
    for (LooseTriangles::Number t = 0; t < loose_->size(); ++t) least = std::min(least, reduced_cost(t));
    return least;
  }

  // The charges become rays from the left of the cuts, whose left sides then cost as much more. Whether all dual values
  // can be written.
  bool set_duals() {
    std::vector<Cost> ray_duals(origin_.size(), 0);
    for (const auto& [cut, end, share] : charges_) {
      const Halfedge h = cut_halfedge_[cut];
      cost_[h] += share;
      cost_[polygon_->twin[h]] = 2 * half_[h] - cost_[h];
      const Edge& edge = polygon_->cuts[cut];
      const RayBesideCut ray(local_.points, end == 0 ? edge.a : edge.b, end == 0 ? edge.b : edge.a, end == 0);
      for (Halfedge side = 0; side < origin_.size(); ++side)
        ray_duals[side] += share * ray.crossing(origin(side), polygon_->graph.target[side]);
    }
    bool is_in_range = true;
    add_leaf(region_, [&](Index from, Index to) {
      const Halfedge h = find(from, to);
      const Cost dual = half_[h] - cost_[h] + ray_duals[h];
      is_in_range = is_in_range && std::abs(dual) < kMaxDual;
      return dual;
    });
    return is_in_range;
  }

  struct Charge {
    std::size_t cut, end;
    Cost share;
  };

  DualRegion& region_;
  const LocalRegion& local_;
  OutlinedRegion outlined_;  // by local numbers, as everything here
  std::size_t components_;
  const Deadline& deadline_;
  std::optional<CutPolygon> polygon_;
  std::optional<LooseTriangles> loose_;
  std::vector<Halfedge> by_target_;     // those of each vertex, ascending by target
  std::vector<Index> origin_;           // by halfedge, as the following
  std::vector<Cost> half_;              // of the length; 0 on the boundary
  std::vector<Cost> cost_;              // half_ less the dual value, without rays
  Cost whole_ = 0;                      // the optimum of the polygon
  std::vector<Cost> paid_by_;           // by loose triangle
  std::vector<Halfedge> cut_halfedge_;  // by cut, from its smaller end
  std::vector<Cost> unpaid_;            // by cut: of its length
  std::vector<Charge> charges_;
  Cost paid_ = 0;
};

}  // namespace

bool add_cut_duals(DualRegion& region, const LocalRegion& local, std::size_t components, std::span<const Edge> known,
                   const Deadline& deadline) {
  return CutProof(region, local, components, deadline).run(known);
}

}  // namespace mwt
