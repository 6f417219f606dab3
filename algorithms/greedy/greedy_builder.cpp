#include "algorithms/greedy/greedy_builder.h"

#include <algorithm>

#include "algorithms/greedy/bounds/certified_edges.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/faces.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/greedy/queue/candidate.h"
#include "algorithms/greedy/queue/edge_sorter.h"
#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

/// One use. Invariant between steps: the mesh is the constrained Delaunay triangulation of the points with the edges of
/// kFixedMark as constraints.
class GreedyBuilder {
 public:
  GreedyBuilder(PlanarMesh& mesh, const Context& context, std::size_t large_face)
      : mesh_(mesh),
        context_(context),
        order_(mesh.points(), mesh.labels()),
        sorted_(mesh, order_),
        queue_(order_),
        stars_(mesh),
        insertion_(mesh, stars_),
        faces_({mesh, order_, stars_, insertion_, context}, large_face) {}

  GreedyCounters run();

 private:
  void fix_certain_edges();
  void solve();
  [[nodiscard]] bool stopped_early() const { return counters_.stopped_early || faces_.stopped_early(); }
  void start_queue();
  void empty_queue();

  [[nodiscard]] bool is_candidate(MeshEdge e) const;
  [[nodiscard]] bool faces_acute_angle(Halfedge h) const;
  [[nodiscard]] bool closes_ear(Halfedge h) const;
  [[nodiscard]] bool is_settled(MeshEdge e) const;
  [[nodiscard]] bool comes_first(MeshEdge e) const;
  void push_if_candidate(MeshEdge e);
  void push_candidates_around(MeshEdge e);
  void push_edge(MeshEdge e);
  void take_from_queue();

  void fix(MeshEdge e);
  void look_for_ear(const Wedge& wedge);
  void look_at_triangle(Halfedge side);
  [[nodiscard]] bool is_unblocked_ear(const Wedge& wedge);
  void insert_ear(const Candidate& ear);

  PlanarMesh& mesh_;
  const Context& context_;
  EdgeOrder order_;
  EdgeSorter sorted_;
  CandidateQueue queue_;
  FixedStars stars_;
  EarInsertion insertion_;
  Faces faces_;
  GreedyCounters counters_;
  std::uint64_t steps_ = 0;
};

GreedyCounters GreedyBuilder::run() {
  fix_certain_edges();
  for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
    while ((mesh_.marks(e) & (kFixedMark | kFaceMark)) == 0 && !stopped_early()) {
      if (!faces_.reduce_face(e)) solve();
    }
  }
  counters_.stopped_early = stopped_early();
  counters_.ears += faces_.inserted_ears();
  counters_.flips = insertion_.flips();
  return counters_;
}

// Edges that need no comparison: the hull's, which are in every triangulation, and the certified ones.
void GreedyBuilder::fix_certain_edges() {
  std::size_t others = 0;
  for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
    if (mesh_.is_hull(e) || is_certainly_greedy(mesh_, e)) {
      mesh_.marks(e) |= kFixedMark;
    } else {
      ++others;
    }
  }
  faces_.reserve(others);
}

// Brings the edges at hand to greedy's triangulation, in the order of length.
void GreedyBuilder::solve() {
  start_queue();
  empty_queue();
}

void GreedyBuilder::start_queue() {
  const std::span<MeshEdge> face = faces_.edges();
  const auto others = std::partition(face.begin(), face.end(), [this](MeshEdge e) { return is_candidate(e); });
  const std::span<const MeshEdge> candidates(face.begin(), others);
  for (const MeshEdge inside : candidates) mesh_.marks(inside) |= kCandidateMark;
  sorted_.sort(candidates);
  for (const MeshEdge inside : face) {
    for (const Halfedge spoke : {2 * inside, 2 * inside + 1}) {
      const Halfedge right = mesh_.rotate_right(spoke);
      if (is_fixed(mesh_, right)) look_for_ear({right, stars_.left_of(spoke)});
    }
  }
}

void GreedyBuilder::empty_queue() {
  std::size_t next = 0;
  while (next < sorted_.size() || !queue_.empty()) {
    // An ear that is inserted may take thousands of flips.
    if (++steps_ % 64 == 0 && context_.deadline_passed()) {
      counters_.stopped_early = true;
      return;
    }
    if (next < sorted_.size() && is_settled(sorted_.edge(next))) {
      ++next;
    } else if (next < sorted_.size() && comes_first(sorted_.edge(next))) {
      fix(sorted_.edge(next++));
    } else {
      take_from_queue();
    }
  }
}

// Whether the angle opposite h in the triangle on its left is acute: its apex lies outside the disc with diameter h.
bool GreedyBuilder::faces_acute_angle(Halfedge h) const {
  return dot_sign(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.apex(h)), mesh_.point(mesh_.target(h))) > 0;
}

// Whether h is an ear that is a mesh edge already. Precondition: the angle opposite h is not acute.
bool GreedyBuilder::closes_ear(Halfedge h) const {
  return is_fixed(mesh_, mesh_.next(h)) && is_fixed(mesh_, mesh_.previous(h));
}

// Whether e can be the next edge of greedy, by lemma 1 of PROOFS.md: either there is no visible point in the closed
// disc around it, for which its two triangles suffice, or it is an ear. Precondition: e is not fixed.
bool GreedyBuilder::is_candidate(MeshEdge e) const {
  const Halfedge h = 2 * e;
  const bool left = faces_acute_angle(h), right = faces_acute_angle(h + 1);
  return (left && right) || (!left && closes_ear(h)) || (!right && closes_ear(h + 1));
}

// Whether the edge sorted at the start is dealt with: taken already, or flipped away.
bool GreedyBuilder::is_settled(MeshEdge e) const { return (mesh_.marks(e) & (kFixedMark | kFlippedMark)) != 0; }

// Whether e precedes all candidates in the queue.
bool GreedyBuilder::comes_first(MeshEdge e) const {
  if (queue_.empty()) return true;
  const double top = queue_.top().key().squared_length.high;
  const double here = mesh_.record(e).squared_length;
  if (is_trusted_float(here) && std::abs(here - top) > kFloatMargin * (here + top)) return here < top;
  return order_.precedes(order_.key(mesh_.origin(2 * e), mesh_.target(2 * e)), queue_.top().key());
}

void GreedyBuilder::push_if_candidate(MeshEdge e) {
  if ((mesh_.marks(e) & (kFixedMark | kCandidateMark)) == 0 && is_candidate(e)) push_edge(e);
}

// After a change inside the triangles at e.
void GreedyBuilder::push_candidates_around(MeshEdge e) {
  push_if_candidate(e);
  for (const Halfedge h : {2 * e, 2 * e + 1}) {
    push_if_candidate(edge_of(mesh_.next(h)));
    push_if_candidate(edge_of(mesh_.previous(h)));
  }
}

void GreedyBuilder::push_edge(MeshEdge e) {
  mesh_.marks(e) |= kCandidateMark;
  queue_.push(Candidate::edge(mesh_, order_, e));
}

void GreedyBuilder::take_from_queue() {
  const Candidate candidate = queue_.top();
  queue_.pop();
  if (candidate.is_ear()) return insert_ear(candidate);
  const MeshEdge e = edge_of(candidate.place());
  const bool is_still_there = candidate.joins(mesh_.origin(2 * e), mesh_.target(2 * e));
  if (is_still_there && !is_fixed_edge(mesh_, e)) fix(e);
}

void GreedyBuilder::fix(MeshEdge e) {
  stars_.fix(e);
  for (const Halfedge h : {2 * e, 2 * e + 1}) {
    look_for_ear({stars_.right_of(h), h});
    look_for_ear({h, stars_.left_of(h)});
  }
}

// Makes the wedge's third side a candidate if it is an ear that no shorter mesh edge crosses.
void GreedyBuilder::look_for_ear(const Wedge& wedge) {
  if (wedge.first == wedge.last) return;
  if (mesh_.rotate_left(wedge.first) == wedge.last) return look_at_triangle(wedge.first);
  if (!is_unblocked_ear(wedge)) return;
  queue_.push(Candidate::ear(mesh_, order_, wedge.first, wedge.last));
}

// Of the triangle left of `side` that side and the one before it are fixed: the third is a candidate if it is an ear.
void GreedyBuilder::look_at_triangle(Halfedge side) {
  const Halfedge third = mesh_.next(side);
  if ((mesh_.marks(edge_of(third)) & (kFixedMark | kCandidateMark)) != 0) return;
  if (!faces_acute_angle(third)) push_edge(edge_of(third));
}

// What blocks an ear is watched: once that edge is flipped away, the wedge is looked at again.
bool GreedyBuilder::is_unblocked_ear(const Wedge& wedge) {
  const Point& apex = mesh_.point(mesh_.origin(wedge.first));
  const Point& from = mesh_.point(mesh_.target(wedge.first));
  const Point& to = mesh_.point(mesh_.target(wedge.last));
  if (orientation(apex, from, to) <= 0 || dot_sign(from, apex, to) > 0) return false;
  const double dx = from.x - to.x, dy = from.y - to.y;
  // Nothing counts as shorter than what is too short for floats.
  const double surely_shorter = (dx * dx + dy * dy) * (1 - kFloatMargin);
  for (Halfedge spoke = mesh_.rotate_left(wedge.first); spoke != wedge.last; spoke = mesh_.rotate_left(spoke)) {
    if (mesh_.record(edge_of(spoke)).squared_length < surely_shorter && surely_shorter > kMinTrustedFloat) {
      mesh_.marks(edge_of(spoke)) |= kWatchedMarks[spoke & 1];
      return false;
    }
    if (orientation(from, to, mesh_.point(mesh_.target(spoke))) >= 0) return false;  // not empty: never an ear
  }
  return true;
}

void GreedyBuilder::insert_ear(const Candidate& ear) {
  const Wedge wedge{ear.place(), stars_.left_of(ear.place())};
  const bool is_split = !ear.joins(mesh_.target(wedge.first), mesh_.target(wedge.last));
  if (is_split) return;
  if (mesh_.rotate_left(wedge.first) == wedge.last) {  // other insertions have made it a mesh edge
    const MeshEdge third = edge_of(mesh_.next(wedge.first));
    if (!is_fixed_edge(mesh_, third)) fix(third);
    return;
  }
  ++counters_.ears;
  const MeshEdge inserted = insertion_.insert(wedge);
  fix(inserted);
  for (const MeshEdge e : insertion_.inner()) push_candidates_around(e);
  push_candidates_around(inserted);
  for (const Halfedge first : insertion_.unblocked()) look_for_ear({first, stars_.left_of(first)});
}

}  // namespace

GreedyCounters build_greedy(PlanarMesh& mesh, const Context& context, std::size_t large_face) {
  return GreedyBuilder(mesh, context, large_face).run();
}

}  // namespace mwt
