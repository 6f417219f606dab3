#include "algorithms/exact/candidates/lmt_kernels.h"

#include <algorithm>
#include <utility>

#include "algorithms/exact/candidates/lmt_scalar.h"
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

struct MachineRounding {
  static float multiply_add(float a, float b, float c) {
    const hn::CappedTag<float, 1> one;
    return hn::GetLane(hn::MulAdd(hn::Set(one, a), hn::Set(one, b), hn::Set(one, c)));
  }
};

HWY_INLINE std::uint32_t lanes() { return static_cast<std::uint32_t>(hn::Lanes(kFloat)); }

HWY_INLINE auto first_lanes(std::uint32_t count) { return hn::FirstN(kWord, count); }

template <class Tag>
HWY_INLINE std::uint64_t bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(tag, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits & ((std::uint64_t{1} << lanes()) - 1);
}

HWY_INLINE std::uint32_t first_of(std::uint64_t bits) { return static_cast<std::uint32_t>(__builtin_ctzll(bits)); }

// ScalarStars (lmt_scalar.h) has each of these functions for one halfedge at a time, with comments on what is computed;
// the lanes here compute exactly the same.
struct VectorStars {
  static HWY_INLINE std::uint32_t position_of(const Star& star, Index target) {
    const auto wanted = hn::Set(kWord, target);
    for (std::uint32_t i = 0; i < star.count; i += lanes()) {
      const auto found = hn::And(hn::Eq(hn::LoadU(kWord, star.target() + i), wanted), first_lanes(star.count - i));
      const std::intptr_t lane = hn::FindFirstTrue(kWord, found);
      if (lane >= 0) return i + static_cast<std::uint32_t>(lane);
    }
    return kNotFound;
  }

  template <class Broken>
  static HWY_INLINE void erase(Star& star, std::uint32_t position, const Broken& broken) {
    const std::uint32_t last = star.count - 1;
    for (std::uint32_t i = position; i < last; i += lanes()) {
      const auto valid = first_lanes(last - i);
      const auto close_gap = [&](auto tag, auto* row) HWY_ATTR {
        hn::BlendedStore(hn::LoadU(tag, row + i + 1), hn::RebindMask(tag, valid), tag, row + i);
      };
      close_gap(kWord, star.target());
      close_gap(kWord, star.certificate());
      close_gap(kFloat, star.x());
      close_gap(kFloat, star.y());
    }
    star.count = last;
    renumber_certificates(star, position, broken);
  }

  template <class Broken>
  static HWY_INLINE void renumber_certificates(Star& star, std::uint32_t position, const Broken& broken_at) {
    const auto removed = hn::Set(kWord, position), low_half = hn::Set(kWord, 0xFFFF);
    const auto none = hn::Set(kWord, Star::kNoCertificate), one = hn::Set(kWord, 1);
    for (std::uint32_t i = 0; i < star.count; i += lanes()) {
      const auto valid = first_lanes(star.count - i);
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
      for (std::uint64_t bits = bits_of(kWord, broken); bits != 0; bits &= bits - 1)
        broken_at(star.target()[i + first_of(bits)]);
    }
  }

  // Merged a vector of the first star at a time.
  template <class ExactSide>
  static HWY_INLINE void collect_apexes(const Star& star, const Star& other, const ExaminedEdge& edge,
                                        const ExactSide& exact_side, Apexes& left, Apexes& right) {
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
      if (hn::AllFalse(kWord, common)) continue;
      append_by_side(star, edge, i, hn::RebindMask(kFloat, common), exact_side, left, right);
    }
  }

  // The neighbours in the lanes of `common`, from position i of the star on.
  template <class ExactSide>
  static HWY_INLINE void append_by_side(const Star& star, const ExaminedEdge& edge, std::uint32_t i,
                                        hn::Mask<Float> common, const ExactSide& exact_side, Apexes& left,
                                        Apexes& right) {
    const auto ex = hn::Set(kFloat, edge.vector.x), ey = hn::Set(kFloat, edge.vector.y);
    const auto x = hn::LoadU(kFloat, star.x() + i), y = hn::LoadU(kFloat, star.y() + i);
    const auto one = hn::Mul(ex, y), two = hn::Mul(ey, x);
    const auto height = hn::Sub(one, two);
    const auto margin = hn::Mul(hn::Add(hn::Abs(one), hn::Abs(two)), hn::Set(kFloat, kLmtMargin));
    auto is_left = hn::And(common, hn::Gt(height, margin));
    auto is_right = hn::And(common, hn::Lt(height, hn::Neg(margin)));
    const auto unsure = hn::AndNot(hn::Or(is_left, is_right), common);
    if (!hn::AllFalse(kFloat, unsure)) {
      std::uint64_t left_bits = bits_of(kFloat, is_left), right_bits = bits_of(kFloat, is_right);
      for (std::uint64_t bits = bits_of(kFloat, unsure); bits != 0; bits &= bits - 1) {
        const int side = exact_side(star.target()[i + first_of(bits)]);
        const std::uint64_t bit = bits & (~bits + 1);
        if (side > 0) left_bits |= bit;
        if (side < 0) right_bits |= bit;
      }
      is_left = hn::LoadMaskBits(kFloat, reinterpret_cast<const std::uint8_t*>(&left_bits));
      is_right = hn::LoadMaskBits(kFloat, reinterpret_cast<const std::uint8_t*>(&right_bits));
    }
    const auto positions = hn::Iota(kWord, i);
    append(left, is_left, x, y, positions);
    append(right, is_right, x, y, positions);
  }

  static HWY_INLINE void append(Apexes& apexes, hn::Mask<Float> chosen, hn::Vec<Float> x, hn::Vec<Float> y,
                                hn::Vec<Word> positions) {
    // Stores of whole vectors: some processors (AMD Zen 4) take a hundred cycles to compress into memory.
    hn::StoreU(hn::Compress(x, chosen), kFloat, apexes.x.data() + apexes.count);
    hn::StoreU(hn::Compress(y, chosen), kFloat, apexes.y.data() + apexes.count);
    hn::StoreU(hn::Compress(positions, hn::RebindMask(kWord, chosen)), kWord, apexes.position.data() + apexes.count);
    apexes.count += static_cast<std::uint32_t>(hn::CountTrue(kFloat, chosen));
  }

  static HWY_INLINE bool has_point_inside(const Star& star, const FloatVector& first, const FloatVector& second,
                                          float side) {
    const float one = first.x * second.y, two = first.y * second.x;
    const float area = side * (one - two) - kLmtMargin * (std::abs(one) + std::abs(two));
    const float rounding =
        kLmtMargin * (std::abs(first.x) + std::abs(first.y) + std::abs(second.x) + std::abs(second.y));
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

  template <class Visit>
  static HWY_INLINE void visit_certifying(const ExaminedEdge& edge, const Apexes& left, std::uint32_t a,
                                          const Apexes& right, const Visit& visit) {
    const auto ex = hn::Set(kFloat, edge.vector.x), ey = hn::Set(kFloat, edge.vector.y);
    const auto margin = hn::Set(kFloat, kLmtMargin), square = hn::Set(kFloat, edge.square);
    const auto enough = hn::Set(kFloat, edge.square * (1 - kLmtMargin));
    const auto lx = hn::Set(kFloat, left.x[a]), ly = hn::Set(kFloat, left.y[a]);
    const auto left_square = hn::MulAdd(lx, lx, hn::Mul(ly, ly));
    const auto from_o_x = hn::Sub(lx, ex), from_o_y = hn::Sub(ly, ey);
    for (std::uint32_t i = 0; i < right.count; i += lanes()) {
      const auto x = hn::LoadU(kFloat, right.x.data() + i), y = hn::LoadU(kFloat, right.y.data() + i);
      const auto reach = hn::Add(left_square, hn::MulAdd(x, x, hn::Mul(y, y)));
      const auto slack = hn::Mul(margin, hn::Add(reach, square));
      const auto at_s = hn::Sub(hn::Mul(x, ly), hn::Mul(y, lx));
      const auto at_o = hn::Sub(hn::Mul(from_o_x, hn::Sub(y, ey)), hn::Mul(from_o_y, hn::Sub(x, ex)));
      const auto is_convex = hn::And(hn::Gt(at_s, slack), hn::Gt(at_o, slack));
      const auto dx = hn::Sub(lx, x), dy = hn::Sub(ly, y);
      const auto diagonal = hn::Add(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), slack);
      const auto is_shorter = hn::Lt(diagonal, enough);
      const auto valid = hn::RebindMask(kFloat, first_lanes(right.count - i));
      const auto certifies = hn::AndNot(hn::And(is_convex, is_shorter), valid);
      for (std::uint64_t bits = bits_of(kFloat, certifies); bits != 0; bits &= bits - 1) {
        if (visit(i + first_of(bits))) return;
      }
    }
  }
};

// The algorithm: examines edges, deletes those without a certificate, and examines again what that affects. `Stars` is
// ScalarStars or VectorStars.
template <class Stars>
class Deletion {
 public:
  Deletion(StarTable& table, Points points, const HullEdges& hull, std::vector<Edge>* deleted,
           std::uint32_t max_examined)
      : stars_(table.stars), points_(points), hull_(hull), deleted_(deleted), max_examined_(max_examined) {}

  LmtCounters run(std::span<const CandidatePair> edges, const Context& context) {
    constexpr std::size_t kEdgesPerDeadlineCheck = 256;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % kEdgesPerDeadlineCheck == 0 && context.deadline_passed()) break;
      examine(edges[i].p, edges[i].q, /*again=*/false);
      examine_pending();
    }
    return counters_;
  }

  // Deletes all of them, whatever their certificates.
  LmtCounters run_without(std::span<const CandidatePair> edges, const Context& context) {
    for (const auto& [p, q] : edges) {
      remove_if_present(p, q);
      remove_if_present(q, p);
      if (!context.deadline_passed()) examine_pending();
    }
    return counters_;
  }

 private:
  void remove_if_present(Index s, Index o) {
    const std::uint32_t place = Stars::position_of(stars_[s], o);
    if (place != kNotFound) remove(s, place);
  }

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
    if (stars_[s].count > max_examined_ || stars_[o].count > Star::kMaxCount) return;
    const std::uint32_t at_s = Stars::position_of(stars_[s], o), at_o = Stars::position_of(stars_[o], s);
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
      if (deleted_ != nullptr) deleted_->push_back(make_edge(p, q));
      remove(s, at_s);
      remove(o, at_o);
    }
  }

  void store_certificate(Index s, Index o, std::uint32_t at_s, std::uint32_t at_o, std::uint32_t left,
                         std::uint32_t right) {
    const Star& star = stars_[s];
    const std::uint32_t left_at_o = Stars::position_of(stars_[o], star.target()[left]);
    const std::uint32_t right_at_o = Stars::position_of(stars_[o], star.target()[right]);
    star.certificate()[at_s] = left | (right << 16);
    stars_[o].certificate()[at_o] = left_at_o | (right_at_o << 16);
  }

  void remove(Index s, std::uint32_t position) {
    Stars::erase(stars_[s], position, [&](Index target) HWY_ATTR { pending_.push_back({s, target}); });
  }

  // Whether edge s -> o has a certificate; if so, `left` and `right` are its apexes' positions in the star of s.
  bool find_certificate(Index s, Index o, std::uint32_t at_s, std::uint32_t& left, std::uint32_t& right) {
    const Star& star = stars_[s];
    const Star& other = stars_[o];
    const float x = star.x()[at_s], y = star.y()[at_s];
    edge_ = {{x, y}, x * x + y * y};
    // Vectors may write past the last apex.
    left_.start(star.count + 2 * lanes(), 1.0F);
    right_.start(star.count + 2 * lanes(), -1.0F);
    const auto exact_side = [&](Index v) HWY_ATTR { return orientation(points_[s], points_[o], points_[v]); };
    Stars::collect_apexes(star, other, edge_, exact_side, left_, right_);
    left_.triangle.assign(left_.count, Apexes::Triangle::not_examined);
    right_.triangle.assign(right_.count, Apexes::Triangle::not_examined);
    for (std::uint32_t a = 0; a < left_.count && right_.count > 0; ++a) {
      if (find_right_apex(star, other, a, right)) {
        left = left_.position[a];
        return true;
      }
    }
    return false;
  }

  // A right apex that makes a certificate with left apex a, as its position in `star`.
  HWY_INLINE bool find_right_apex(const Star& star, const Star& other, std::uint32_t a, std::uint32_t& right) {
    bool found = false;
    Stars::visit_certifying(edge_, left_, a, right_, [&](std::uint32_t r) HWY_ATTR {
      if (!is_open(star, other, left_, a)) return true;
      if (!is_open(star, other, right_, r)) return false;
      right = right_.position[r];
      found = true;
      return true;
    });
    return found;
  }

  // Whether no neighbour of either end is known to lie inside the triangle of the edge and the apex.
  bool is_open(const Star& star, const Star& other, Apexes& apexes, std::uint32_t a) const {
    Apexes::Triangle& known = apexes.triangle[a];
    if (known == Apexes::Triangle::not_examined) {
      known = is_blocked(star, other, apexes, a) ? Apexes::Triangle::blocked : Apexes::Triangle::open;
    }
    return known == Apexes::Triangle::open;
  }

  HWY_INLINE bool is_blocked(const Star& star, const Star& other, const Apexes& apexes, std::uint32_t a) const {
    const float side = apexes.side;
    const FloatVector edge{side * edge_.vector.x, side * edge_.vector.y}, apex{side * apexes.x[a], side * apexes.y[a]};
    if (Stars::has_point_inside(star, edge, apex, side)) return true;
    const std::uint32_t at_o = Stars::position_of(other, star.target()[apexes.position[a]]);
    const FloatVector apex_from_o{side * other.x()[at_o], side * other.y()[at_o]};
    return Stars::has_point_inside(other, apex_from_o, {-edge.x, -edge.y}, side);
  }

  std::vector<Star>& stars_;
  Points points_;
  const HullEdges& hull_;
  std::vector<Edge>* deleted_;  // a log, or nullptr
  std::uint32_t max_examined_;
  std::vector<CandidatePair> pending_;  // their certificates broke
  LmtCounters counters_;
  ExaminedEdge edge_;
  Apexes left_, right_;
};

LmtCounters DeleteEdgesWithoutCertificate(StarTable& table, Points points, const HullEdges& hull,
                                          std::span<const CandidatePair> edges, const Context& context,
                                          std::vector<Edge>* deleted, std::uint32_t max_examined) {
  return Deletion<VectorStars>(table, points, hull, deleted, max_examined).run(edges, context);
}

LmtCounters DeleteEdgesWithoutCertificatePlainly(StarTable& table, Points points, const HullEdges& hull,
                                                 std::span<const CandidatePair> edges, const Context& context) {
  return Deletion<ScalarStars<MachineRounding>>(table, points, hull, nullptr, Star::kMaxExamined).run(edges, context);
}

LmtCounters DeleteEdges(StarTable& table, Points points, const HullEdges& hull, std::span<const CandidatePair> edges,
                        const Context& context, std::vector<Edge>* deleted) {
  return Deletion<VectorStars>(table, points, hull, deleted, Star::kMaxExamined).run_without(edges, context);
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(DeleteEdgesWithoutCertificate);
HWY_EXPORT(DeleteEdges);
HWY_EXPORT(DeleteEdgesWithoutCertificatePlainly);

LmtCounters delete_edges_without_certificate(StarTable& table, Points points, const HullEdges& hull,
                                             std::span<const CandidatePair> edges, const Context& context,
                                             std::vector<Edge>* deleted, std::uint32_t max_examined) {
  return HWY_DYNAMIC_DISPATCH(DeleteEdgesWithoutCertificate)(table, points, hull, edges, context, deleted,
                                                             max_examined);
}

LmtCounters delete_edges(StarTable& table, Points points, const HullEdges& hull, std::span<const CandidatePair> edges,
                         const Context& context, std::vector<Edge>* deleted) {
  return HWY_DYNAMIC_DISPATCH(DeleteEdges)(table, points, hull, edges, context, deleted);
}

LmtCounters delete_edges_without_certificate_plainly(StarTable& table, Points points, const HullEdges& hull,
                                                     std::span<const CandidatePair> edges, const Context& context) {
  return HWY_DYNAMIC_DISPATCH(DeleteEdgesWithoutCertificatePlainly)(table, points, hull, edges, context);
}

}  // namespace mwt
#endif
