#include "algorithms/greedy/greedy.h"

#include <array>
#include <vector>

#include "algorithms/greedy/candidate_queue.h"
#include "algorithms/greedy/certified_edges.h"
#include "algorithms/greedy/fixed_stars.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::uint32_t kFlippedMark = 4;                        // no longer the edge that was sorted at the start
constexpr std::array<std::uint32_t, 2> kWatchedMarks = {8, 16};  // the halfedge blocks an ear of its wedge
constexpr std::uint32_t kInnerMark = 32;                         // lies inside the region being restored
constexpr std::uint32_t kFaceMark = 64;                          // its face is being or has been solved
constexpr std::uint32_t kGreedyMarks =
    kFaceMark | kFixedMark | kFlippedMark | kWatchedMarks[0] | kWatchedMarks[1] | kInnerMark;

// The wedge between two fixed halfedges with one origin, counter-clockwise from `first` to `last`, nothing fixed
// between.
struct Wedge {
  Halfedge first;
  Halfedge last;
};

class GreedyBuilder {
 public:
  GreedyBuilder(PlanarMesh& mesh, Points points, const Context& context)
      : mesh_(mesh), points_(points), context_(context), heap_(points), stars_(mesh), sorted_(mesh, points) {}

  GreedyCounters run() {
    fix_certain_edges();
    for (MeshEdge e = 0; e < mesh_.edge_count() && !counters_.stopped_early; ++e) {
      if ((mesh_.marks(e) & (kFixedMark | kFaceMark)) == 0) solve_face(e);
    }
    return counters_;
  }

 private:
  // Edges that need no comparison: the hull's, which are in every triangulation, and the certified ones.
  void fix_certain_edges() {
    for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
      if (mesh_.is_hull(e) || is_certainly_greedy(mesh_, e)) mesh_.marks(e) |= kFixedMark;
    }
  }

  // Fixed edges cut the plane into faces that do not influence each other: the one with e inside is brought to its
  // greedy triangulation, while all it touches stays in the cache.
  void solve_face(MeshEdge e) {
    collect_face(e);
    sorted_.sort(face_);
    for (const MeshEdge inside : face_) {
      for (const Halfedge spoke : {2 * inside, 2 * inside + 1}) {
        const Halfedge right = mesh_.rotate_right(spoke);
        if (stars_.is_fixed(right)) look_for_ear({right, stars_.left_of(spoke)});
      }
    }
    fetched_ = 0;
    std::size_t next = 0;
    while (next < sorted_.size() || !heap_.empty()) {
      if (++steps_ % 4096 == 0 && context_.deadline_passed()) {
        counters_.stopped_early = true;
        return;
      }
      if (next < sorted_.size() && next >= fetched_) fetch_ahead(next);
      if (next < sorted_.size() && is_settled(sorted_.edge(next))) {
        ++next;
      } else if (next < sorted_.size() && comes_first(sorted_.edge(next))) {
        fix(sorted_.edge(next++));
      } else {
        take_from_heap();
      }
    }
  }

  // All edges that can be reached from e through triangles without crossing a fixed edge.
  void collect_face(MeshEdge e) {
    face_.assign(1, e);
    mesh_.marks(e) |= kFaceMark;
    for (std::size_t i = 0; i < face_.size(); ++i) {
      for (const Halfedge h : {2 * face_[i], 2 * face_[i] + 1}) {
        for (const Halfedge side : {mesh_.next(h), mesh_.previous(h)}) {
          std::uint32_t& marks = mesh_.marks(edge_of(side));
          if ((marks & (kFixedMark | kFaceMark)) != 0) continue;
          marks |= kFaceMark;
          face_.push_back(edge_of(side));
        }
      }
    }
  }

  // Edges come in the order of length, from everywhere: bring what the coming ones need into the cache, first their
  // records, later the records of their stars.
  void fetch_ahead(std::size_t next) {
    constexpr std::size_t kFar = 48, kMiddle = 32, kNear = 16;
    fetched_ = next + 1;
    if (next + kFar >= sorted_.size()) return;
    mesh_.prefetch(sorted_.edge(next + kFar));
    const MeshEdge middle = sorted_.edge(next + kMiddle);
    for (const Halfedge h : {2 * middle, 2 * middle + 1}) {
      mesh_.prefetch(edge_of(mesh_.next(h)));
      mesh_.prefetch(edge_of(mesh_.previous(h)));
      mesh_.prefetch_point(mesh_.origin(h));
    }
    const MeshEdge near = sorted_.edge(next + kNear);
    for (const Halfedge h : {2 * near, 2 * near + 1}) {
      const Halfedge left = mesh_.rotate_left(h), right = mesh_.rotate_right(h);
      mesh_.prefetch(edge_of(mesh_.rotate_left(left)));
      mesh_.prefetch(edge_of(mesh_.rotate_right(right)));
      mesh_.prefetch_point(mesh_.target(left));
    }
  }

  // Whether the edge sorted at the start is dealt with: taken already, or flipped away.
  [[nodiscard]] bool is_settled(MeshEdge e) const { return (mesh_.marks(e) & (kFixedMark | kFlippedMark)) != 0; }

  // Whether e precedes all candidates in the heap.
  [[nodiscard]] bool comes_first(MeshEdge e) const {
    if (heap_.empty()) return true;
    const double top = heap_.top().key.squared_length.high;
    const double here = mesh_.record(e).squared_length;
    constexpr double kFloatError = 1e-6;  // relative; floats below 1e-30 may be denormal
    if (here > 1e-30 && here < 1e30 && std::abs(here - top) > kFloatError * (here + top)) return here < top;
    return precedes(key_of(e), heap_.top().key, points_);
  }

  [[nodiscard]] EdgeKey key_of(MeshEdge e) const {
    const Edge edge = mesh_.labelled_edge(e);
    return edge_key(points_, edge.a, edge.b);
  }

  void take_from_heap() {
    const Candidate candidate = heap_.top();
    heap_.pop();
    if (!heap_.empty()) mesh_.prefetch(edge_of(heap_.top().place));
    if (candidate.kind == Candidate::Kind::ear) return insert_ear(candidate);
    const MeshEdge e = edge_of(candidate.place);
    const Edge edge = mesh_.labelled_edge(e);
    const bool is_still_there = edge.a == candidate.key.low && edge.b == candidate.key.high;
    if (is_still_there && (mesh_.marks(e) & kFixedMark) == 0) fix(e);
  }

  void fix(MeshEdge e) {
    mesh_.marks(e) |= kFixedMark;
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      stars_.add(h);
      look_for_ear({stars_.right_of(h), h});
      look_for_ear({h, stars_.left_of(h)});
    }
  }

  // Makes the wedge's third side a candidate if it is an ear that no shorter mesh edge crosses. What blocks it is
  // watched: once that edge is flipped away, the wedge is looked at again.
  void look_for_ear(const Wedge& wedge) {
    Halfedge spoke = mesh_.rotate_left(wedge.first);
    if (spoke == wedge.last || wedge.first == wedge.last) return;
    const Index c = mesh_.origin(wedge.first), a = mesh_.target(wedge.first), b = mesh_.target(wedge.last);
    const Point &apex = mesh_.point(c), &from = mesh_.point(a), &to = mesh_.point(b);
    if (orientation(apex, from, to) <= 0 || dot_sign(from, apex, to) > 0) return;
    const double dx = from.x - to.x, dy = from.y - to.y;
    // Shorter beyond the rounding of floats; below 1e-30 they may be denormal, so nothing counts as shorter there.
    const double surely_shorter = (dx * dx + dy * dy) * (1 - 1e-6);
    for (; spoke != wedge.last; spoke = mesh_.rotate_left(spoke)) {
      if (mesh_.record(edge_of(spoke)).squared_length < surely_shorter && surely_shorter > 1e-30) {
        mesh_.marks(edge_of(spoke)) |= kWatchedMarks[spoke & 1];
        return;
      }
      if (orientation(from, to, mesh_.point(mesh_.target(spoke))) >= 0) return;  // not empty: never an ear
    }
    heap_.push({edge_key(points_, mesh_.label(a), mesh_.label(b)), Candidate::Kind::ear, wedge.first});
  }

  void insert_ear(const Candidate& ear) {
    const Wedge wedge{ear.place, stars_.left_of(ear.place)};
    const Edge third = make_edge(mesh_.label(mesh_.target(wedge.first)), mesh_.label(mesh_.target(wedge.last)));
    if (third != Edge{ear.key.low, ear.key.high}) return;      // the wedge has been split since
    if (mesh_.rotate_left(wedge.first) == wedge.last) return;  // its triangle is complete already
    ++counters_.ears;
    const MeshEdge inserted = flip_out_spokes(wedge);
    restore_delaunay();
    for (const MeshEdge e : inner_) {
      mesh_.marks(e) &= ~kInnerMark;
      heap_.push({key_of(e), Candidate::Kind::edge, 2 * e});
    }
    inner_.clear();
    fix(inserted);
    look_again();
  }

  // Flips all edges out of the wedge, nearest first in the sense of Graham's scan; the last one to go becomes the third
  // side, which is returned; the others are collected in inner_.
  MeshEdge flip_out_spokes(const Wedge& wedge) {
    spokes_.assign(1, wedge.first);
    MeshEdge last_flipped = 0;
    Halfedge spoke = mesh_.rotate_left(wedge.first);
    while (true) {
      const Point& to = mesh_.point(mesh_.target(spoke));
      while (spokes_.size() > 1) {
        const Point& from = mesh_.point(mesh_.target(spokes_[spokes_.size() - 2]));
        if (orientation(from, to, mesh_.point(mesh_.target(spokes_.back()))) >= 0) break;
        last_flipped = edge_of(spokes_.back());
        spokes_.pop_back();
        flip(last_flipped);
        inner_.push_back(last_flipped);
      }
      if (spoke == wedge.last) break;
      spokes_.push_back(spoke);
      spoke = mesh_.rotate_left(spoke);
    }
    inner_.pop_back();
    return last_flipped;
  }

  // Lawson's flips on the edges in inner_, which are all that insertion can have disturbed.
  void restore_delaunay() {
    if (inner_.empty()) return;
    for (const MeshEdge e : inner_) mesh_.marks(e) |= kInnerMark;
    suspects_ = inner_;
    while (!suspects_.empty()) {
      const MeshEdge e = suspects_.back();
      suspects_.pop_back();
      const Halfedge h = 2 * e;
      const Point& p = mesh_.point(mesh_.apex(h + 1));
      if (in_circle(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.apex(h)), p) <= 0) {
        continue;
      }
      flip(e);
      for (const Halfedge side : {mesh_.next(h), mesh_.previous(h), mesh_.next(h + 1), mesh_.previous(h + 1)}) {
        if ((mesh_.marks(edge_of(side)) & kInnerMark) != 0) suspects_.push_back(edge_of(side));
      }
    }
  }

  void flip(MeshEdge e) {
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      if ((mesh_.marks(e) & kWatchedMarks[h & 1]) != 0) unblocked_.push_back(stars_.right_of(h));
    }
    const std::uint32_t lasting = mesh_.marks(e) & (kFaceMark | kInnerMark);
    mesh_.flip(e);
    mesh_.marks(e) = lasting | kFlippedMark;
    ++counters_.flips;
  }

  // Wedges that lost a blocking edge to a flip.
  void look_again() {
    for (const Halfedge first : unblocked_) look_for_ear({first, stars_.left_of(first)});
    unblocked_.clear();
  }

  PlanarMesh& mesh_;
  Points points_;  // in the caller's numbering
  const Context& context_;
  CandidateHeap heap_;
  FixedStars stars_;
  EdgeSorter sorted_;
  GreedyCounters counters_;
  std::uint64_t steps_ = 0;
  std::vector<MeshEdge> face_;
  std::size_t fetched_ = 0;
  std::vector<Halfedge> spokes_;
  std::vector<MeshEdge> inner_;
  std::vector<MeshEdge> suspects_;
  std::vector<Halfedge> unblocked_;  // first halfedges of wedges
};

}  // namespace

GreedyCounters make_greedy(PlanarMesh& mesh, Points points, const Context& context) {
  const GreedyCounters counters = GreedyBuilder(mesh, points, context).run();
  mesh.clear_marks(kGreedyMarks);
  return counters;
}

Triangulation greedy_triangulation(Points points) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  make_greedy(mesh, points, Context{});
  return mesh.triangulation();
}

namespace {

Solution run_greedy(Points points, Context& context) {
  const auto delaunay = [&] {
    const ScopedPhase phase(context, "delaunay");
    return PlanarMesh::delaunay(points);
  };
  PlanarMesh mesh = delaunay();
  const ScopedPhase phase(context, "greedy");
  const GreedyCounters counters = make_greedy(mesh, points, context);
  Solution solution;
  solution.triangulation = mesh.triangulation();
  solution.counters = {{"ears", static_cast<double>(counters.ears)}, {"flips", static_cast<double>(counters.flips)}};
  solution.stopped_early = counters.stopped_early;
  return solution;
}

}  // namespace

AlgorithmInfo greedy_entry() {
  AlgorithmInfo info;
  info.name = "greedy";
  info.summary =
      "shortest edges first, each kept unless it crosses a kept one; from a constrained Delaunay triangulation";
  info.source =
      "C. A. Wang, Efficiently updating constrained Delaunay triangulations, BIT 33 (1993); C. Levcopoulos, D. "
      "Krznaric, The greedy triangulation can be computed from the Delaunay triangulation in linear time, "
      "Computational Geometry 14 (1999); faces of certified edges: this project, algorithms/greedy/README.md";
  info.guarantee =
      "Theta(sqrt n) in the worst case: C. Levcopoulos, An Omega(sqrt n) lower bound for the nonoptimality of the "
      "greedy triangulation, IPL 25 (1987); C. Levcopoulos, D. Krznaric, Quasi-greedy triangulations approximating "
      "the minimum weight triangulation, J. Algorithms 27 (1998)";
  info.time = "O(n log n) in practice; about 1.7 Delaunay triangulations on uniform points";
  info.space = "O(n), about 130 bytes per point";
  info.largest_n = 10'000'000;
  info.function = run_greedy;
  return info;
}

}  // namespace mwt
