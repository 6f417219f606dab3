// For tests only: a solver for small point sets that writes proofs, without any cleverness, and that can be broken.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "verifier/bounds.h"
#include "verifier/diamond.h"
#include "verifier/exact.h"
#include "verifier/testing/proof.h"
#include "verifier/triangulation.h"

namespace mwt::verifier::testing {

/// In which way the solver is wrong.
enum class Fault {
  none,
  diamond_too_large,      ///< base angle of the diamonds pi / 3 instead of pi / 4.6
  deletes_ties,           ///< LMT deletes an edge if the other diagonal is as long
  occupied_too_early,     ///< emptiness is tested over the triangle's bounding box
  forgets_to_check_sides  ///< of the edges that cross another, those at later points are overlooked: marks it certain
};

/// Numbers a region's corners c_0 .. c_{L-1} as a polygon.
class PolygonProgram {
 public:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max() / 8;

  /// `allowed(i, j)` says whether a diagonal may join corners i < j.
  template <class Allowed>
  PolygonProgram(Points points, std::vector<Index> corners, long unit_exponent, const Allowed& allowed)
      : points_(points),
        corners_(std::move(corners)),
        size_(corners_.size()),
        value_(size_ * size_, kNever),
        best_(size_ * size_) {
    for (std::size_t gap = 1; gap < size_; ++gap) {
      for (std::size_t i = 0; i + gap < size_; ++i) fill(i, i + gap, unit_exponent, allowed);
    }
  }

  [[nodiscard]] bool is_feasible() const { return at(0, size_ - 1) < kNever; }
  [[nodiscard]] std::int64_t optimum() const { return at(0, size_ - 1); }
  /// What the polygon beyond diagonal ij costs, with half the diagonal: the dual value of the side from j to i.
  [[nodiscard]] std::int64_t dual(std::size_t i, std::size_t j) const { return at(i, j); }

  void append_triangles(std::vector<Corners>& triangles) const { append(0, size_ - 1, triangles); }

 private:
  template <class Allowed>
  void fill(std::size_t i, std::size_t j, long unit_exponent, const Allowed& allowed) {
    std::int64_t& value = value_[i * size_ + j];
    if (j == i + 1) {
      value = 0;
      return;
    }
    const bool is_root = i == 0 && j + 1 == size_;
    if (!is_root && !allowed(i, j)) return;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (at(i, k) == kNever || at(k, j) == kNever || turn(point(i), point(k), point(j)) <= 0) continue;
      const std::int64_t sum = whole(i, k, unit_exponent) + whole(k, j, unit_exponent);
      if (sum >= value) continue;
      value = sum;
      best_[i * size_ + j] = k;
    }
    if (value < kNever && !is_root) value += half(i, j, unit_exponent);
  }

  [[nodiscard]] std::int64_t at(std::size_t i, std::size_t j) const { return value_[i * size_ + j]; }
  [[nodiscard]] const Point& point(std::size_t i) const { return points_[corners_[i]]; }
  [[nodiscard]] std::int64_t half(std::size_t i, std::size_t j, long unit_exponent) const {
    return floor_below(scaled(length(point(i), point(j)), -unit_exponent - 1), kNever);
  }
  // With both halves of the diagonal.
  [[nodiscard]] std::int64_t whole(std::size_t i, std::size_t j, long unit_exponent) const {
    return j == i + 1 ? 0 : at(i, j) + half(i, j, unit_exponent);
  }

  void append(std::size_t i, std::size_t j, std::vector<Corners>& triangles) const {
    if (j == i + 1) return;
    const std::size_t k = best_[i * size_ + j];
    triangles.push_back({corners_[i], corners_[k], corners_[j]});
    append(i, k, triangles);
    append(k, j, triangles);
  }

  Points points_;
  std::vector<Index> corners_;
  std::size_t size_;
  std::vector<std::int64_t> value_;
  std::vector<std::size_t> best_;
};

class NaiveProver {
 public:
  explicit NaiveProver(Points points, Fault fault = Fault::none)
      : points_(points.begin(), points.end()),
        fault_(fault),
        is_candidate_(points.size() * points.size()),
        is_certain_(is_candidate_.size()) {}

  /// Nothing if the certain edges are not connected or a face cannot be triangulated by candidates.
  std::optional<Proof> prove() {
    if (points_.size() < 3 || hull_of(points_).empty()) return {};
    find_candidates();
    delete_not_minimal();
    mark_certain();
    if (!collect_faces() || !solve_faces()) return {};
    finish();
    return proof_;
  }

  /// Of the open edges in the triangulation, one is left out of its face.
  std::optional<Proof> prove_without_an_edge() {
    if (!prove()) return {};
    for (const Corners& t : proof_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        if (certain(a, b)) continue;
        proof_.regions.clear();
        proof_.triangles.clear();
        left_out_ = EdgeEnds{a, b};
        if (!solve_faces()) return {};
        finish();
        return proof_;
      }
    }
    return {};
  }

 private:
  [[nodiscard]] std::size_t place(Index a, Index b) const { return std::min(a, b) * points_.size() + std::max(a, b); }
  [[nodiscard]] bool candidate(Index a, Index b) const { return is_candidate_[place(a, b)]; }
  [[nodiscard]] bool certain(Index a, Index b) const { return is_certain_[place(a, b)]; }
  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }

  template <class Visit>
  void for_each_candidate(const Visit& visit) const {
    for (Index a = 0; a < size(); ++a) {
      for (Index b = a + 1; b < size(); ++b) {
        if (candidate(a, b)) visit(a, b);
      }
    }
  }

  void find_candidates() {
    for (Index a = 0; a < size(); ++a) {
      for (Index b = a + 1; b < size(); ++b) is_candidate_[place(a, b)] = passes_diamond_test(a, b);
    }
  }

  [[nodiscard]] bool passes_diamond_test(Index a, Index b) const {
    const double tangent = fault_ == Fault::diamond_too_large ? std::sqrt(3.0) : kDiamondTangent;
    bool left = false, right = false;
    for (Index i = 0; i < size(); ++i) {
      if (i == a || i == b) continue;
      const int side = turn(points_[a], points_[b], points_[i]);
      if (is_inside_segment(points_[i], points_[a], points_[b])) return false;
      if (side == 0 || sign_of_form(points_[a], points_[b], points_[i], -side, tangent) <= 0 ||
          sign_of_form(points_[b], points_[a], points_[i], side, tangent) <= 0) {
        continue;
      }
      (side > 0 ? left : right) = true;
    }
    return !(left && right);
  }

  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const {
    const Point &p = points_[a], &q = points_[b], &r = points_[c];
    for (Index i = 0; i < size(); ++i) {
      if (i == a || i == b || i == c) continue;
      const Point& s = points_[i];
      const bool is_inside = turn(p, q, s) >= 0 && turn(q, r, s) >= 0 && turn(r, p, s) >= 0;
      const bool is_in_box = std::min({p.x, q.x, r.x}) <= s.x && s.x <= std::max({p.x, q.x, r.x}) &&
                             std::min({p.y, q.y, r.y}) <= s.y && s.y <= std::max({p.y, q.y, r.y});
      if (fault_ == Fault::occupied_too_early ? is_in_box : is_inside) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_locally_minimal(Index a, Index b) const {
    for (Index l = 0; l < size(); ++l) {
      if (!is_triangle(a, b, l)) continue;
      for (Index r = 0; r < size(); ++r) {
        if (!is_triangle(b, a, r)) continue;
        const int comparison = compare_lengths(points_[l], points_[r], points_[a], points_[b]);
        const bool is_convex =
            turn(points_[l], points_[r], points_[b]) > 0 && turn(points_[r], points_[l], points_[a]) > 0;
        if (!is_convex || (fault_ == Fault::deletes_ties ? comparison > 0 : comparison >= 0)) return true;
      }
    }
    return false;
  }

  // Whether c lies left of ab, and the triangle is an empty one of candidates.
  [[nodiscard]] bool is_triangle(Index a, Index b, Index c) const {
    return c != a && c != b && turn(points_[a], points_[b], points_[c]) > 0 && candidate(a, c) && candidate(b, c) &&
           is_empty(a, b, c);
  }

  void delete_not_minimal() {
    const std::vector<Index> hull = hull_of(points_);
    std::set<EdgeEnds> hull_edges;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Index a = hull[i], b = hull[(i + 1) % hull.size()];
      hull_edges.insert({std::min(a, b), std::max(a, b)});
    }
    EdgeStep step;
    for (bool changed = true; changed;) {
      changed = false;
      for_each_candidate([&](Index a, Index b) {
        if (hull_edges.contains({a, b}) || is_locally_minimal(a, b)) return;
        is_candidate_[place(a, b)] = false;
        step.edges.push_back({a, b});
        changed = true;
      });
    }
    proof_.steps.push_back(step);
  }

  void mark_certain() {
    EdgeStep step{3, {}, {}};
    for_each_candidate([&](Index a, Index b) {
      bool is_crossed = false;
      for_each_candidate([&](Index c, Index d) {
        const bool is_overlooked = fault_ == Fault::forgets_to_check_sides && c > (a + b) / 2;
        if (!is_overlooked && do_cross(points_[a], points_[b], points_[c], points_[d])) is_crossed = true;
      });
      is_certain_[place(a, b)] = !is_crossed;
      if (!is_crossed) step.edges.push_back({a, b});
    });
    proof_.steps.push_back(step);
  }

  // Certain neighbours of v, counter-clockwise.
  [[nodiscard]] std::vector<Index> star(Index v) const {
    std::vector<Index> result;
    for (Index w = 0; w < size(); ++w) {
      if (w != v && certain(v, w)) result.push_back(w);
    }
    const auto is_upper = [&](Index w) {
      return points_[w].y > points_[v].y || (points_[w].y == points_[v].y && points_[w].x > points_[v].x);
    };
    std::sort(result.begin(), result.end(), [&](Index a, Index b) {
      if (is_upper(a) != is_upper(b)) return is_upper(a);
      return turn(points_[v], points_[a], points_[b]) > 0;
    });
    return result;
  }

  // Walks with the face on the left, the outer one left out. False if some face is no polygon.
  bool collect_faces() {
    std::vector<std::vector<Index>> stars;
    std::size_t edges = 0;
    for (Index v = 0; v < size(); ++v) {
      stars.push_back(star(v));
      edges += stars.back().size();
    }
    std::set<EdgeEnds> walked;
    for (Index v = 0; v < size(); ++v) {
      for (const Index w : stars[v]) {
        if (walked.contains({v, w})) continue;
        std::vector<Index> face;
        for (EdgeEnds side{v, w}; walked.insert(side).second;) {
          face.push_back(side[0]);
          const auto& next = stars[side[1]];
          const auto back = std::find(next.begin(), next.end(), side[0]);
          side = {side[1], back == next.begin() ? next.back() : *(back - 1)};
        }
        faces_.push_back(face);
      }
    }
    // The graph is connected if Euler's formula holds with one component.
    if (points_.size() + faces_.size() != edges / 2 + 2) return false;
    const std::vector<Index> hull = hull_of(points_);
    std::erase_if(faces_, [&](const std::vector<Index>& face) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        for (std::size_t h = 0; h < hull.size(); ++h) {
          if (face[i] == hull[(h + 1) % hull.size()] && face[(i + 1) % face.size()] == hull[h]) return true;
        }
      }
      return false;
    });
    return true;
  }

  // Whether the direction from corner i to another point leads into the face.
  [[nodiscard]] bool leads_inside(const std::vector<Index>& face, std::size_t i, Index target) const {
    const Point& o = points_[face[i]];
    const Point& next = points_[face[(i + 1) % face.size()]];
    const Point& last = points_[face[(i + face.size() - 1) % face.size()]];
    const Point& d = points_[target];
    const int from_next = turn(o, next, d), to_last = turn(o, d, last);
    const int angle = next == last ? -1 : turn(o, next, last);
    if (angle > 0) return from_next > 0 && to_last > 0;
    if (angle == 0) return from_next > 0;
    return next == last || from_next > 0 || to_last > 0;
  }

  bool solve_faces() {
    for (const auto& face : faces_) {
      if (!solve_face(face)) return false;
    }
    return true;
  }

  bool solve_face(const std::vector<Index>& face) {
    const auto allowed = [&](std::size_t i, std::size_t j) {
      const Index a = face[i], b = face[j];
      const bool is_left_out = left_out_ && place(a, b) == place((*left_out_)[0], (*left_out_)[1]);
      return a != b && candidate(a, b) && !certain(a, b) && !is_left_out && leads_inside(face, i, b) &&
             leads_inside(face, j, a);
    };
    double extent = 0;
    for (const Index p : face) extent = std::max(extent, upper_double(length(points_[p], points_[face.front()])));
    RegionStep region;
    region.unit_exponent = std::ilogb(extent) - 45;
    const PolygonProgram program(points_, face, region.unit_exponent, allowed);
    if (!program.is_feasible()) return false;
    program.append_triangles(proof_.triangles);
    if (face.size() == 3) return true;
    region.walks = {face};
    TreeNode leaf;
    leaf.side_duals.assign(face.size(), 0);
    leaf.side_duals.back() = program.optimum();
    constexpr std::int64_t kLarge = std::int64_t{1} << 56;  // for diagonals beyond which nothing fits
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = i + 2; j < face.size(); ++j) {
        if (!allowed(i, j)) continue;
        region.open_edges.push_back({i, j});
        leaf.edge_duals.push_back({-std::min(program.dual(i, j), kLarge)});
      }
    }
    region.tree = {leaf};
    proof_.regions.push_back(region);
    return true;
  }

  void finish() {
    proof_.point_count = points_.size();
    proof_.hash = sha256(points_);
    proof_.order.clear();
    for (Index i = 0; i < size(); ++i) proof_.order.push_back(i);
    const Bounds weight = weight_of(points_, proof_.triangles, hull_of(points_));
    proof_.claimed_lower = std::nextafter(lower_double(weight) * (1 - 1e-13), 0);
    proof_.claimed_upper = upper_double(weight);
  }

  std::vector<Point> points_;
  Fault fault_;
  std::vector<bool> is_candidate_, is_certain_;
  std::optional<EdgeEnds> left_out_;
  std::vector<std::vector<Index>> faces_;
  Proof proof_;
};

/// As a solver would that overlooks one inner point in every test, and inserts it at the end in the triangle it lies
/// in: a proof in perfect form.
inline std::optional<Proof> prove_without_a_point(const std::vector<Point>& points) {
  const std::vector<Index> hull = hull_of(points);
  for (Index p = 0; p < points.size(); ++p) {
    if (std::find(hull.begin(), hull.end(), p) != hull.end()) continue;
    std::vector<Point> others = points;
    others.erase(others.begin() + p);
    auto proof = NaiveProver(others).prove();
    if (!proof) return {};
    const auto numbers = [&](auto& ends) {
      for (Index& v : ends) v += v >= p ? 1 : 0;
    };
    for (Corners& t : proof->triangles) numbers(t);
    for (EdgeStep& step : proof->steps) {
      for (EdgeEnds& edge : step.edges) numbers(edge);
    }
    for (RegionStep& region : proof->regions) numbers(region.walks.front());
    const auto around = std::find_if(proof->triangles.begin(), proof->triangles.end(), [&](const Corners& t) {
      return turn(points[t[0]], points[t[1]], points[p]) > 0 && turn(points[t[1]], points[t[2]], points[p]) > 0 &&
             turn(points[t[2]], points[t[0]], points[p]) > 0;
    });
    if (around == proof->triangles.end()) continue;
    const auto [a, b, c] = *around;
    *around = {a, b, p};
    proof->triangles.insert(proof->triangles.end(), {{b, c, p}, {c, a, p}});
    // The edges to p, called certain.
    proof->steps.back().edges.insert(proof->steps.back().edges.end(), {{a, p}, {b, p}, {c, p}});
    proof->point_count = points.size();
    proof->hash = sha256(points);
    proof->order.push_back(static_cast<Index>(points.size() - 1));
    const Bounds weight = weight_of(points, proof->triangles, hull);
    proof->claimed_lower = std::nextafter(lower_double(weight) * (1 - 1e-13), 0);
    proof->claimed_upper = upper_double(weight);
    return proof;
  }
  return {};
}

/// Uniform in the unit square, or with integer coordinates below `range`, where ties and collinear triples abound.
inline std::vector<Point> random_points(std::size_t n, unsigned seed, int range = 0) {
  std::mt19937 random(seed);
  std::vector<Point> points;
  for (int tries = 0; points.size() < n && tries < 1000; ++tries) {
    const double x = static_cast<double>(random()), y = static_cast<double>(random());
    const Point p = range == 0 ? Point{x * 0x1p-32, y * 0x1p-32} : Point{std::fmod(x, range), std::fmod(y, range)};
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

}  // namespace mwt::verifier::testing
