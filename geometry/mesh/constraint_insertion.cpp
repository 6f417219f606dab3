#include "geometry/mesh/constraint_insertion.h"

#include <deque>
#include <optional>
#include <stdexcept>

#include "geometry/mesh/in_circle.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::uint32_t kConstraintMark = 2;

class ConstraintInsertion {
 public:
  explicit ConstraintInsertion(PlanarMesh& mesh)
      : mesh_(mesh), vertices_(mesh.point_count()), spokes_(vertices_.size()) {
    for (Index v = 0; v < vertices_.size(); ++v) vertices_[mesh.label(v)] = v;
    for (Halfedge h = 0; h < 2 * mesh.edge_count(); ++h) spokes_[mesh.origin(h)] = h;
  }

  void insert(const Edge& labels) {
    const Index a = vertices_[labels.a], b = vertices_[labels.b];
    if (const auto there = find(a, b)) {
      mesh_.marks(edge_of(*there)) |= kConstraintMark;
      return;
    }
    collect_crossed(a, b);
    const MeshEdge inserted = flip_out_crossed(a, b);
    mesh_.marks(inserted) |= kConstraintMark;
    restore_delaunay();
  }

 private:
  [[nodiscard]] int side(Index a, Index b, Index v) const {
    return orientation(mesh_.point(a), mesh_.point(b), mesh_.point(v));
  }

  // The halfedge from a to b, if there is one.
  [[nodiscard]] std::optional<Halfedge> find(Index a, Index b) const {
    Halfedge h = spokes_[a];
    do {
      if (mesh_.target(h) == b) return h;
      h = mesh_.rotate_left(h);
    } while (h != spokes_[a]);
    return {};
  }

  // The edge across from a in the triangle at a that segment ab enters; its half on the side of a.
  [[nodiscard]] Halfedge first_crossed(Index a, Index b) const {
    Halfedge h = spokes_[a];
    do {
      const bool is_outer = (h & 1) == 1 && mesh_.is_hull(edge_of(h));
      const Halfedge across = mesh_.next(h);
      if (!is_outer && side(a, b, mesh_.origin(across)) < 0 && side(a, b, mesh_.target(across)) > 0) {
        // b lies in the wedge and not behind a.
        if (side(mesh_.origin(across), mesh_.target(across), b) < 0) return across;
      }
      h = mesh_.rotate_left(h);
    } while (h != spokes_[a]);
    throw std::logic_error("insert_constraints: a constraint passes through a point");
  }

  void collect_crossed(Index a, Index b) {
    crossed_.clear();
    Halfedge inner = first_crossed(a, b);
    while (true) {
      if ((mesh_.marks(edge_of(inner)) & kConstraintMark) != 0) {
        throw std::logic_error("insert_constraints: two constraints cross");
      }
      crossed_.push_back(edge_of(inner));
      const Halfedge outer = twin(inner);
      const Index apex = mesh_.apex(outer);
      if (apex == b) return;
      const int turn = side(a, b, apex);
      if (turn == 0) throw std::logic_error("insert_constraints: a constraint passes through a point");
      // `outer` goes from the left of ab to its right, its next one from the right to the apex.
      inner = turn > 0 ? mesh_.next(outer) : mesh_.previous(outer);
    }
  }

  // Flips the crossed edges until none is left; one of them becomes ab, the others are suspects.
  MeshEdge flip_out_crossed(Index a, Index b) {
    MeshEdge inserted = 0;
    while (!crossed_.empty()) {
      const MeshEdge e = crossed_.front();
      crossed_.pop_front();
      if (!mesh_.is_flippable(e)) {
        crossed_.push_back(e);
        continue;
      }
      flip(e);
      const Index u = mesh_.origin(2 * e), v = mesh_.target(2 * e);
      const bool is_inserted = (u == a && v == b) || (u == b && v == a);
      if (is_inserted) {
        inserted = e;
      } else if (side(a, b, u) * side(a, b, v) < 0) {
        crossed_.push_back(e);
      } else {
        suspects_.push_back(e);
      }
    }
    return inserted;
  }

  void restore_delaunay() {
    while (!suspects_.empty()) {
      const MeshEdge e = suspects_.back();
      suspects_.pop_back();
      if (mesh_.is_hull(e) || (mesh_.marks(e) & kConstraintMark) != 0) continue;
      const Halfedge h = 2 * e;
      if (fast_in_circle(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.apex(h)),
                         mesh_.point(mesh_.apex(h + 1))) <= 0) {
        continue;
      }
      flip(e);
      for (const Halfedge next : {mesh_.next(h), mesh_.previous(h), mesh_.next(h + 1), mesh_.previous(h + 1)}) {
        suspects_.push_back(edge_of(next));
      }
    }
  }

  // Every vertex keeps a halfedge that starts there.
  void flip(MeshEdge e) {
    for (const Halfedge h : {2 * e, 2 * e + 1}) spokes_[mesh_.origin(h)] = mesh_.rotate_left(h);
    mesh_.flip(e);
  }

  PlanarMesh& mesh_;
  std::vector<Index> vertices_;   // by the caller's numbers
  std::vector<Halfedge> spokes_;  // one from every vertex
  std::deque<MeshEdge> crossed_;
  std::vector<MeshEdge> suspects_;
};

}  // namespace

void insert_constraints(PlanarMesh& delaunay, std::span<const Edge> edges) {
  ConstraintInsertion insertion(delaunay);
  for (const Edge& edge : edges) insertion.insert(edge);
  delaunay.clear_marks(kConstraintMark);
}

}  // namespace mwt
