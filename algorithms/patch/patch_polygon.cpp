#include "algorithms/patch/patch_polygon.h"

#include <algorithm>
#include <limits>

#include "geometry/mesh/distance.h"
#include "geometry/numbers/double_double.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

PatchPolygon::PatchPolygon(PlanarMesh& mesh, int max_k)
    : mesh_(mesh),
      row_length_(static_cast<std::size_t>(max_k) + 2),
      costs_(row_length_ * row_length_),
      apexes_(costs_.size()) {}

Halfedge PatchPolygon::name_of_triangle(Halfedge side) const {
  return std::min(side, std::min(mesh_.next(side), mesh_.previous(side)));
}

// Whether the triangle beyond `side` may join.
bool PatchPolygon::is_open(Halfedge side, std::uint32_t closed) const {
  if ((mesh_.marks(edge_of(side)) & (kHullMark | closed)) != 0) return false;
  return std::find(triangles_.begin(), triangles_.end(), name_of_triangle(twin(side))) == triangles_.end();
}

// Replaces the side at `link` by the two other sides of the triangle beyond it.
void PatchPolygon::add_triangle(std::size_t link) {
  const Halfedge beyond = twin(links_[link].side);
  triangles_.push_back(name_of_triangle(beyond));
  inner_.push_back(edge_of(beyond));
  links_.push_back({mesh_.previous(beyond), links_[link].next});
  links_[link] = {mesh_.next(beyond), links_.size() - 1};
}

void PatchPolygon::grow(Halfedge start, int k, std::uint32_t closed) {
  triangles_.assign(1, name_of_triangle(start));
  inner_.clear();
  links_ = {{start, 1}, {mesh_.next(start), 2}, {mesh_.previous(start), 0}};
  const auto wanted = static_cast<std::size_t>(k);
  // A link's side changes when its triangle joins: going round the links again and again is breadth-first enough, and
  // every round adds a triangle or is the last.
  for (bool grew = true; grew && triangles_.size() < wanted;) {
    grew = false;
    const std::size_t round_end = links_.size();
    for (std::size_t link = 0; link < round_end && triangles_.size() < wanted; ++link) {
      if (!is_open(links_[link].side, closed)) continue;
      add_triangle(link);
      grew = true;
    }
  }
  is_enclosed_ = std::none_of(links_.begin(), links_.end(), [&](const Link& l) { return is_open(l.side, closed); });
  collect_boundary();
}

void PatchPolygon::collect_boundary() {
  boundary_.clear();
  corners_.clear();
  places_.clear();
  std::size_t link = 0;
  do {
    boundary_.push_back(links_[link].side);
    corners_.push_back(mesh_.origin(links_[link].side));
    places_.push_back(mesh_.point(corners_.back()));
    link = links_[link].next;
  } while (link != 0);
}

bool PatchPolygon::improve() {
  if (inner_.empty()) return false;
  find_optimum();
  if (!is_surely_shorter()) return false;
  std::size_t used = 0;
  rebuild(0, corners_.size() - 1, boundary_.back(), used);
  return true;
}

// Interval dynamic programming: G. T. Klincsek, "Minimal triangulations of polygonal domains", Annals of Discrete
// Mathematics 9 (1980); P. D. Gilbert, "New results on planar triangulations", 1979.
void PatchPolygon::find_optimum() {
  const std::size_t size = corners_.size();
  for (std::size_t i = 0; i + 1 < size; ++i) costs_[at(i, i + 1)] = costs_[at(i + 1, i)] = 0;
  for (std::size_t length = 2; length < size; ++length) {
    for (std::size_t i = 0; i + length < size; ++i) find_best_apex(i, i + length);
  }
}

// Of the triangles on chord (i, j), the one with the least cost beyond its two other sides.
void PatchPolygon::find_best_apex(std::size_t i, std::size_t j) {
  double best = std::numeric_limits<double>::infinity();
  std::size_t apex = i;
  const double *from_i = &costs_[at(i, 0)], *from_j = &costs_[at(j, 0)];
  const Point* const places = places_.data();
  const Point p = places[i], q = places[j];
  for (std::size_t m = i + 1; m < j; ++m) {
    const double cost = from_i[m] + from_j[m];
    if (!(cost < best)) continue;
    if (orientation(p, places[m], q) <= 0) continue;
    best = cost;
    apex = m;
  }
  const bool is_boundary = i == 0 && j + 1 == corners_.size();
  if (!is_boundary && apex != i) best += rounded_distance(p, q);
  costs_[at(i, j)] = costs_[at(j, i)] = best;
  apexes_[at(i, j)] = apex;
}

// Floating point first: both sums have fewer than 2^7 terms and err by less than 2^-44 of themselves. Else
// double-double. Nothing is sure about lengths that underflow: a mesh has some only next to ordinary ones, to which
// they are nothing.
bool PatchPolygon::is_surely_shorter() {
  const double optimum = costs_[at(0, corners_.size() - 1)];
  present_.clear();
  double present = 0;
  for (const MeshEdge e : inner_) {
    present_.push_back(make_edge(mesh_.origin(2 * e), mesh_.target(2 * e)));
    present += rounded_distance(mesh_.point(present_.back().a), mesh_.point(present_.back().b));
  }
  if (present < kMinTrustedLength) return false;
  if (optimum < present * (1 - 0x1p-42)) return true;
  if (!(optimum < present * (1 + 0x1p-42))) return false;
  chords_.clear();
  collect_chords(0, corners_.size() - 1, chords_);
  const auto is_present = [&](const Edge& chord) {
    return std::find(present_.begin(), present_.end(), chord) != present_.end();
  };
  const bool is_nothing_new = std::all_of(chords_.begin(), chords_.end(), is_present);  // by far the most frequent case
  if (is_nothing_new) return false;
  DoubleDouble gain;
  for (const Edge& edge : present_) gain += length(mesh_.point(edge.a), mesh_.point(edge.b));
  for (const Edge& chord : chords_) gain += -length(mesh_.point(chord.a), mesh_.point(chord.b));
  // Fewer than 2^8 terms and partial sums, none above 2 `present`, each off by at most 2^-97 of that.
  return gain.high > 0x1p-80 * present;
}

// The chords of the optimum inside corners i .. j, without (i, j) itself.
void PatchPolygon::collect_chords(std::size_t i, std::size_t j, std::vector<Edge>& chords) const {
  if (j - i < 2) return;
  const std::size_t m = apexes_[at(i, j)];
  if (m - i > 1) chords.push_back(make_edge(corners_[i], corners_[m]));
  if (j - m > 1) chords.push_back(make_edge(corners_[m], corners_[j]));
  collect_chords(i, m, chords);
  collect_chords(m, j, chords);
}

// Links the optimum's triangles inside corners i .. j; `base` goes from j to i. Edges inside are used again.
void PatchPolygon::rebuild(std::size_t i, std::size_t j, Halfedge base, std::size_t& used) {
  const std::size_t m = apexes_[at(i, j)];
  const auto side = [&](std::size_t from, std::size_t to) {
    if (to - from == 1) return boundary_[from];
    const MeshEdge e = inner_[used++];
    mesh_.set_edge(e, corners_[from], corners_[to]);
    rebuild(from, to, 2 * e + 1, used);
    return 2 * e;
  };
  const Halfedge first = side(i, m);
  const Halfedge second = side(m, j);
  mesh_.link_triangle(base, first, second);
}

}  // namespace mwt
