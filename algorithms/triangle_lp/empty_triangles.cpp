#include "algorithms/triangle_lp/empty_triangles.h"

#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/predicates.h"

namespace mwt {

namespace {

// For every directed line through two points, the set of other points on it or to its left, as bits.
class LeftSets {
 public:
  LeftSets(Points points, const Deadline& deadline)
      : n_(points.size()), words_((n_ + 63) / 64), bits_(n_ * n_ * words_, 0) {
    for (std::size_t a = 0; a < n_ && !has_passed(deadline); ++a) {
      for (std::size_t b = a + 1; b < n_; ++b) {
        for (std::size_t c = b + 1; c < n_; ++c) insert_triple(a, b, c, orientation(points[a], points[b], points[c]));
      }
    }
  }

  [[nodiscard]] bool is_left_or_on(std::size_t a, std::size_t b, std::size_t p) const {
    return (set(a, b)[p / 64] >> (p % 64)) & 1U;
  }

  /// Whether no point lies in the closed counter-clockwise triangle abc besides its corners.
  [[nodiscard]] bool is_empty(std::size_t a, std::size_t b, std::size_t c) const {
    const std::uint64_t *left_of_ab = set(a, b), *left_of_bc = set(b, c), *left_of_ca = set(c, a);
    for (std::size_t w = 0; w < words_; ++w) {
      if (left_of_ab[w] & left_of_bc[w] & left_of_ca[w]) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] const std::uint64_t* set(std::size_t a, std::size_t b) const { return &bits_[(a * n_ + b) * words_]; }

  void insert(std::size_t a, std::size_t b, std::size_t p) {
    bits_[(a * n_ + b) * words_ + p / 64] |= std::uint64_t{1} << (p % 64);
  }

  void insert_triple(std::size_t a, std::size_t b, std::size_t c, int turn) {
    if (turn >= 0) {
      insert(a, b, c);
      insert(b, c, a);
      insert(c, a, b);
    }
    if (turn <= 0) {
      insert(b, a, c);
      insert(c, b, a);
      insert(a, c, b);
    }
  }

  std::size_t n_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<Triangle> empty_triangles(Points points) {
  return *empty_triangles(points, std::numeric_limits<std::size_t>::max(), {});
}

std::optional<std::vector<Triangle>> empty_triangles(Points points, std::size_t most, const Deadline& deadline) {
  const LeftSets left(points, deadline);
  std::vector<Triangle> triangles;
  const Index n = static_cast<Index>(points.size());
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      if (triangles.size() > most || has_passed(deadline)) return {};
      for (Index c = a + 1; c < n; ++c) {
        const bool turns_left = c != b && left.is_left_or_on(a, b, c) && !left.is_left_or_on(b, a, c);
        if (turns_left && left.is_empty(a, b, c)) triangles.push_back({a, b, c});
      }
    }
  }
  return triangles.size() > most ? std::nullopt : std::optional(std::move(triangles));
}

}  // namespace mwt
