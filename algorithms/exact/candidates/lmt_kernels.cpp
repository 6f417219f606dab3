#include "algorithms/exact/candidates/lmt_kernels.h"

#include <algorithm>
#include <utility>

#include "geometry/predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/exact/candidates/lmt_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mwt {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Float = hn::CappedTag<float, 16>;
using Word = hn::RebindToUnsigned<Float>;
constexpr Float kFloat;
constexpr Word kWord;

// Relative rounding errors of the floats' products and differences stay below this, with room: vectors err by 2^-24 in
// each component, differences of two vectors by 2^-23 of both lengths, and what is compared below, products of two of
// these, by 12 * 2^-24 < 8e-7 of the squares that its margin is relative to. No product that matters underflows
// (Star::component). Comparisons with components that are not numbers are false; each is used so that false means not
// sure.
constexpr float kRounding = 2e-6F;

HWY_INLINE std::uint32_t lanes() { return static_cast<std::uint32_t>(hn::Lanes(kFloat)); }

HWY_INLINE auto first_lanes(std::uint32_t count) { return hn::FirstN(kWord, count); }

constexpr std::uint32_t kNotFound = 0xFFFFFFFF;

// Position of `target` in the star.
HWY_INLINE std::uint32_t position_of(const Star& star, Index target) {
  const auto wanted = hn::Set(kWord, target);
  for (std::uint32_t i = 0; i < star.count; i += lanes()) {
    const auto found = hn::And(hn::Eq(hn::LoadU(kWord, star.target() + i), wanted), first_lanes(star.count - i));
    const std::intptr_t lane = hn::FindFirstTrue(kWord, found);
    if (lane >= 0) return i + static_cast<std::uint32_t>(lane);
  }
  return kNotFound;
}

// Third corners of candidate triangles on one side of an edge s -> o, relative to s.
struct Apexes {
  enum class Triangle : std::uint8_t { not_looked_at, open, blocked };

  std::vector<float> x, y;
  std::vector<std::uint32_t> position;  // in the star of s
  std::vector<Triangle> triangle;       // whether some point is known to lie in the apex's triangle with the edge
  std::uint32_t count = 0;
  float side = 0;  // +1 left, -1 right

  void start(std::size_t room, float on_side) {
    if (x.size() < room) {
      x.resize(room);
      y.resize(room);
      position.resize(room);
    }
    triangle.clear();
    count = 0;
    side = on_side;
  }
};

class Deletion {
 public:
  Deletion(StarTable& table, Points points, const HullEdges& hull)
      : stars_(table.stars), points_(points), hull_(hull) {}

  LmtCounters run(std::span<const CandidatePair> edges, const Context& context) {
    constexpr std::size_t kEdgesPerLookAtTheClock = 256;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % kEdgesPerLookAtTheClock == 0 && context.deadline_passed()) break;
      examine(edges[i].p, edges[i].q, /*again=*/false);
      examine_pending();
    }
    return counters_;
  }

 private:
  void examine_pending() {
    while (!pending_.empty()) {
      const auto [p, q] = pending_.back();
      pending_.pop_back();
      examine(p, q, /*again=*/true);
    }
  }

  void examine(Index p, Index q, bool again) {
    if (hull_.contains(p, q)) return;
    const bool p_is_smaller = stars_[p].count <= stars_[q].count;
    const Index s = p_is_smaller ? p : q, o = p_is_smaller ? q : p;
    if (stars_[s].count > Star::kWorthExamining || stars_[o].count > Star::kMaximumCount) return;
    const std::uint32_t at_s = position_of(stars_[s], o), at_o = position_of(stars_[o], s);
    if (at_s == kNotFound) return;  // deleted meanwhile
    const bool has_certificate =
        stars_[s].certificate()[at_s] != Star::kNoCertificate && stars_[o].certificate()[at_o] != Star::kNoCertificate;
    if (again && has_certificate) return;
    ++counters_.checks;
    std::uint32_t left = 0, right = 0;
    if (find_certificate(s, o, at_s, left, right)) {
      store_certificate(s, o, at_s, at_o, left, right);
    } else {
      ++counters_.deleted;
      remove(s, at_s);
      remove(o, at_o);
    }
  }

  void store_certificate(Index s, Index o, std::uint32_t at_s, std::uint32_t at_o, std::uint32_t left,
                         std::uint32_t right) {
    const Star& star = stars_[s];
    const std::uint32_t left_at_o = position_of(stars_[o], star.target()[left]);
    const std::uint32_t right_at_o = position_of(stars_[o], star.target()[right]);
    star.certificate()[at_s] = left | (right << 16);
    stars_[o].certificate()[at_o] = left_at_o | (right_at_o << 16);
  }

  // Takes one entry out of a star, keeps the order of the others, and notes whose certificate used it.
  HWY_INLINE void remove(Index s, std::uint32_t position) {
    Star& star = stars_[s];
    const std::uint32_t last = star.count - 1;
    for (std::uint32_t row = 0; row < 4; ++row) {
      std::uint32_t* const words = star.words + row * std::size_t{star.capacity};
      for (std::uint32_t i = position; i < last; i += lanes()) {
        hn::BlendedStore(hn::LoadU(kWord, words + i + 1), first_lanes(last - i), kWord, words + i);
      }
    }
    star.count = last;
    const auto removed = hn::Set(kWord, position), low_half = hn::Set(kWord, 0xFFFF);
    const auto none = hn::Set(kWord, Star::kNoCertificate), one = hn::Set(kWord, 1);
    for (std::uint32_t i = 0; i < last; i += lanes()) {
      const auto valid = first_lanes(last - i);
      const auto certificate = hn::LoadU(kWord, star.certificate() + i);
      const auto left = hn::And(certificate, low_half), right = hn::ShiftRight<16>(certificate);
      const auto has_one = hn::And(valid, hn::Ne(certificate, none));
      const auto broken = hn::And(has_one, hn::Or(hn::Eq(left, removed), hn::Eq(right, removed)));
      const auto new_left = hn::Sub(left, hn::IfThenElseZero(hn::Gt(left, removed), one));
      const auto new_right = hn::Sub(right, hn::IfThenElseZero(hn::Gt(right, removed), one));
      auto renumbered = hn::Or(new_left, hn::ShiftLeft<16>(new_right));
      renumbered = hn::IfThenElse(broken, none, hn::IfThenElse(has_one, renumbered, certificate));
      hn::BlendedStore(renumbered, valid, kWord, star.certificate() + i);
      if (hn::AllFalse(kWord, broken)) continue;
      std::uint64_t bits = 0;
      hn::StoreMaskBits(kWord, broken, reinterpret_cast<std::uint8_t*>(&bits));
      bits &= (std::uint64_t{1} << lanes()) - 1;
      for (; bits != 0; bits &= bits - 1) {
        pending_.push_back({s, star.target()[i + static_cast<std::uint32_t>(__builtin_ctzll(bits))]});
      }
    }
  }

  // Looks for a certificate of edge s -> o; on success `left` and `right` are its apexes' positions in the star of s.
  bool find_certificate(Index s, Index o, std::uint32_t at_s, std::uint32_t& left, std::uint32_t& right) {
    const Star& star = stars_[s];
    edge_x_ = star.x()[at_s];
    edge_y_ = star.y()[at_s];
    edge_square_ = edge_x_ * edge_x_ + edge_y_ * edge_y_;
    collect_apexes(s, o);
    return left_.count > 0 && right_.count > 0 && find_pair(star, stars_[o], left, right);
  }

  // The common neighbours of both ends, by side. Both stars are sorted by target: merged a vector at a time.
  HWY_INLINE void collect_apexes(Index s, Index o) {
    const Star& star = stars_[s];
    const Star& other = stars_[o];
    left_.start(star.count + 2 * lanes(), 1.0F);
    right_.start(star.count + 2 * lanes(), -1.0F);
    std::uint32_t k = 0;
    for (std::uint32_t i = 0; i < star.count; i += lanes()) {
      const std::uint32_t size = std::min(lanes(), star.count - i);
      const Index first = star.target()[i], last = star.target()[i + size - 1];
      const auto targets = hn::LoadU(kWord, star.target() + i);
      auto common = hn::Ne(targets, targets);
      while (k < other.count && other.target()[k] < first) ++k;
      for (; k < other.count && other.target()[k] <= last; ++k) {
        common = hn::Or(common, hn::Eq(targets, hn::Set(kWord, other.target()[k])));
      }
      common = hn::And(common, first_lanes(size));
      if (!hn::AllFalse(kWord, common)) append_by_side(s, o, i, hn::RebindMask(kFloat, common));
    }
    left_.triangle.assign(left_.count, Apexes::Triangle::not_looked_at);
    right_.triangle.assign(right_.count, Apexes::Triangle::not_looked_at);
  }

  // Files the neighbours in the lanes of `common`, from position i of the star of s on.
  HWY_INLINE void append_by_side(Index s, Index o, std::uint32_t i, hn::Mask<Float> common) {
    const Star& star = stars_[s];
    const auto ex = hn::Set(kFloat, edge_x_), ey = hn::Set(kFloat, edge_y_);
    const auto x = hn::LoadU(kFloat, star.x() + i), y = hn::LoadU(kFloat, star.y() + i);
    const auto one = hn::Mul(ex, y), two = hn::Mul(ey, x);
    const auto height = hn::Sub(one, two);
    const auto margin = hn::Mul(hn::Add(hn::Abs(one), hn::Abs(two)), hn::Set(kFloat, kRounding));
    const auto is_left = hn::And(common, hn::Gt(height, margin));
    const auto is_right = hn::And(common, hn::Lt(height, hn::Neg(margin)));
    const auto unsure = hn::AndNot(hn::Or(is_left, is_right), common);
    const auto positions = hn::Iota(kWord, i);
    append(left_, is_left, x, y, positions);
    append(right_, is_right, x, y, positions);
    if (!hn::AllFalse(kFloat, unsure)) append_exactly(s, o, i, unsure);
  }

  HWY_INLINE void append(Apexes& apexes, hn::Mask<Float> chosen, hn::Vec<Float> x, hn::Vec<Float> y,
                         hn::Vec<Word> positions) {
    hn::CompressBlendedStore(x, chosen, kFloat, apexes.x.data() + apexes.count);
    hn::CompressBlendedStore(y, chosen, kFloat, apexes.y.data() + apexes.count);
    hn::CompressBlendedStore(positions, hn::RebindMask(kWord, chosen), kWord, apexes.position.data() + apexes.count);
    apexes.count += static_cast<std::uint32_t>(hn::CountTrue(kFloat, chosen));
  }

  // Nearly collinear apexes: their side is decided exactly.
  void append_exactly(Index s, Index o, std::uint32_t first, hn::Mask<Float> unsure) {
    const Star& star = stars_[s];
    std::uint64_t bits = 0;
    hn::StoreMaskBits(kFloat, unsure, reinterpret_cast<std::uint8_t*>(&bits));
    bits &= (std::uint64_t{1} << lanes()) - 1;
    for (; bits != 0; bits &= bits - 1) {
      const std::uint32_t i = first + static_cast<std::uint32_t>(__builtin_ctzll(bits));
      const int side = orientation(points_[s], points_[o], points_[star.target()[i]]);
      if (side == 0) continue;
      Apexes& apexes = side > 0 ? left_ : right_;
      apexes.x[apexes.count] = star.x()[i];
      apexes.y[apexes.count] = star.y()[i];
      apexes.position[apexes.count++] = i;
    }
  }

  // Whether no neighbour of either end is known to lie inside the triangle of the edge and the apex.
  HWY_INLINE bool is_open(const Star& star, const Star& other, Apexes& apexes, std::uint32_t a) {
    Apexes::Triangle& known = apexes.triangle[a];
    if (known == Apexes::Triangle::not_looked_at) {
      known = is_blocked(star, other, apexes, a) ? Apexes::Triangle::blocked : Apexes::Triangle::open;
    }
    return known == Apexes::Triangle::open;
  }

  HWY_INLINE bool is_blocked(const Star& star, const Star& other, const Apexes& apexes, std::uint32_t a) const {
    const float side = apexes.side;
    const Vector edge{side * edge_x_, side * edge_y_}, apex{side * apexes.x[a], side * apexes.y[a]};
    if (has_point_inside(star, edge, apex, side)) return true;
    const std::uint32_t at_o = position_of(other, star.target()[apexes.position[a]]);
    const Vector apex_from_o{side * other.x()[at_o], side * other.y()[at_o]};
    return has_point_inside(other, apex_from_o, {-edge.x, -edge.y}, side);
  }

  struct Vector {
    float x, y;
  };

  // Whether a neighbour lies certainly inside the triangle spanned at the star's center by two vectors, the second to
  // the left of the first; both are given times `side`.
  HWY_INLINE bool has_point_inside(const Star& star, Vector first, Vector second, float side) const {
    const float one = first.x * second.y, two = first.y * second.x;
    const float area = side * (one - two) - kRounding * (std::abs(one) + std::abs(two));
    const float rounding =
        kRounding * (std::abs(first.x) + std::abs(first.y) + std::abs(second.x) + std::abs(second.y));
    const auto fx = hn::Set(kFloat, first.x), fy = hn::Set(kFloat, first.y);
    const auto sx = hn::Set(kFloat, second.x), sy = hn::Set(kFloat, second.y);
    const auto error = hn::Set(kFloat, rounding), inner_area = hn::Set(kFloat, area);
    for (std::uint32_t i = 0; i < star.count; i += lanes()) {
      const auto x = hn::LoadU(kFloat, star.x() + i), y = hn::LoadU(kFloat, star.y() + i);
      const auto margin = hn::Mul(error, hn::Add(hn::Abs(x), hn::Abs(y)));
      const auto left_of_first = hn::Sub(hn::Mul(fx, y), hn::Mul(fy, x));
      const auto right_of_second = hn::Sub(hn::Mul(x, sy), hn::Mul(y, sx));
      auto inside = hn::And(hn::Gt(left_of_first, margin), hn::Gt(right_of_second, margin));
      inside = hn::And(inside, hn::Lt(hn::Add(hn::Add(left_of_first, right_of_second), margin), inner_area));
      inside = hn::And(inside, hn::RebindMask(kFloat, first_lanes(star.count - i)));
      if (!hn::AllFalse(kFloat, inside)) return true;
    }
    return false;
  }

  // A left and a right apex for which the edge is, or may be, locally minimal.
  HWY_INLINE bool find_pair(const Star& star, const Star& other, std::uint32_t& left, std::uint32_t& right) {
    const auto ex = hn::Set(kFloat, edge_x_), ey = hn::Set(kFloat, edge_y_);
    const auto rounding = hn::Set(kFloat, kRounding);
    const auto enough = hn::Set(kFloat, edge_square_ * (1 - kRounding));
    for (std::uint32_t a = 0; a < left_.count; ++a) {
      const auto lx = hn::Set(kFloat, left_.x[a]), ly = hn::Set(kFloat, left_.y[a]);
      const auto left_square = hn::MulAdd(lx, lx, hn::Mul(ly, ly));
      const auto from_o_x = hn::Sub(lx, ex), from_o_y = hn::Sub(ly, ey);
      for (std::uint32_t i = 0; i < right_.count; i += lanes()) {
        const auto x = hn::LoadU(kFloat, right_.x.data() + i), y = hn::LoadU(kFloat, right_.y.data() + i);
        const auto reach = hn::Add(left_square, hn::MulAdd(x, x, hn::Mul(y, y)));
        const auto slack = hn::Mul(rounding, hn::Add(reach, hn::Set(kFloat, edge_square_)));
        const auto at_s = hn::Sub(hn::Mul(x, ly), hn::Mul(y, lx));
        const auto at_o = hn::Sub(hn::Mul(from_o_x, hn::Sub(y, ey)), hn::Mul(from_o_y, hn::Sub(x, ex)));
        const auto is_convex = hn::And(hn::Gt(at_s, slack), hn::Gt(at_o, slack));
        const auto dx = hn::Sub(lx, x), dy = hn::Sub(ly, y);
        const auto diagonal = hn::Add(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), slack);
        const auto is_shorter = hn::Lt(diagonal, enough);
        const auto refuses = hn::And(is_convex, is_shorter);
        const auto certifies = hn::AndNot(refuses, hn::RebindMask(kFloat, first_lanes(right_.count - i)));
        std::uint64_t bits = 0;
        hn::StoreMaskBits(kFloat, certifies, reinterpret_cast<std::uint8_t*>(&bits));
        bits &= (std::uint64_t{1} << lanes()) - 1;
        if (bits != 0 && !is_open(star, other, left_, a)) break;
        for (; bits != 0; bits &= bits - 1) {
          const std::uint32_t r = i + static_cast<std::uint32_t>(__builtin_ctzll(bits));
          if (!is_open(star, other, right_, r)) continue;
          left = left_.position[a];
          right = right_.position[r];
          return true;
        }
      }
    }
    return false;
  }

  std::vector<Star>& stars_;
  Points points_;
  const HullEdges& hull_;
  std::vector<CandidatePair> pending_;  // their certificates broke
  LmtCounters counters_;

  // The edge under examination, relative to s, and its apexes.
  float edge_x_ = 0, edge_y_ = 0, edge_square_ = 0;
  Apexes left_, right_;
};

LmtCounters DeleteEdgesWithoutCertificate(StarTable& table, Points points, const HullEdges& hull,
                                          std::span<const CandidatePair> edges, const Context& context) {
  return Deletion(table, points, hull).run(edges, context);
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(DeleteEdgesWithoutCertificate);

LmtCounters delete_edges_without_certificate(StarTable& table, Points points, const HullEdges& hull,
                                             std::span<const CandidatePair> edges, const Context& context) {
  return HWY_DYNAMIC_DISPATCH(DeleteEdgesWithoutCertificate)(table, points, hull, edges, context);
}

}  // namespace mwt
#endif
