#include "geometry/edge_order.h"

#include <algorithm>
#include <cmath>

#include "geometry/double_double.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

struct KeyedEdge {
  double squared_length;  // rounded, each of its five operations once
  Edge edge;
};

double squared_length(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

bool square_is_exact(const DoubleDouble& difference) {
  if (difference.low != 0) return false;
  const DoubleDouble product = exact_product(difference.high, difference.high);
  return product.low == 0 && (product.high > 1e-280 || difference.high == 0);  // below, lost bits would not show
}

// Whether squared_length(p, q) rounded nothing away.
bool squared_length_is_exact(const Point& p, const Point& q) {
  const DoubleDouble dx = exact_sum(p.x, -q.x), dy = exact_sum(p.y, -q.y);
  return square_is_exact(dx) && square_is_exact(dy) && exact_sum(dx.high * dx.high, dy.high * dy.high).low == 0;
}

// Whether the rounded keys x <= y prove that the first edge is shorter. Bounds as in compare_length.
bool certainly_less(double x, double y) { return y - x > 1e-15 * (x + y) && x + y > 1e-280 && x + y < 1e300; }

// The squared length to about 100 bits. Its relative error is at most 4 * kDoubleDoubleError unless it leaves [1e-200,
// 1e200].
struct PreciseSquare {
  DoubleDouble dx, dy;  // exact
  DoubleDouble value;

  PreciseSquare(const Point& p, const Point& q)
      : dx(exact_sum(p.x, -q.x)), dy(exact_sum(p.y, -q.y)), value(square(dx) + square(dy)) {}

  [[nodiscard]] bool is_safe() const { return value.high > 1e-200 && value.high < 1e200; }
};

bool same_size(const DoubleDouble& x, const DoubleDouble& y) { return x == y || x == -y; }

class ExactOrder {
 public:
  explicit ExactOrder(Points points) : points_(points) {}

  bool operator()(const KeyedEdge& x, const KeyedEdge& y) const {
    const int comparison = compare(x, y);
    return comparison != 0 ? comparison < 0 : x.edge < y.edge;
  }

 private:
  // From cheap to costly: exact keys, 100 bits, mirrored or turned differences, exact arithmetic.
  int compare(const KeyedEdge& x, const KeyedEdge& y) const {
    const Point &a = points_[x.edge.a], &b = points_[x.edge.b], &c = points_[y.edge.a], &d = points_[y.edge.b];
    if (squared_length_is_exact(a, b) && squared_length_is_exact(c, d)) {
      return (x.squared_length > y.squared_length) - (x.squared_length < y.squared_length);
    }
    const PreciseSquare s(a, b), t(c, d);
    const double difference = (s.value - t.value).high;
    const bool is_certain = std::abs(difference) > 16 * kDoubleDoubleError * (s.value.high + t.value.high);
    if (is_certain && s.is_safe() && t.is_safe()) return difference > 0 ? 1 : -1;
    if (same_size(s.dx, t.dx) && same_size(s.dy, t.dy)) return 0;
    if (same_size(s.dx, t.dy) && same_size(s.dy, t.dx)) return 0;
    return compare_length(a, b, c, d);
  }

  Points points_;
};

bool rounded_order(const KeyedEdge& x, const KeyedEdge& y) {
  if (x.squared_length != y.squared_length) return x.squared_length < y.squared_length;
  return x.edge < y.edge;
}

}  // namespace

void sort_by_length(Points points, std::vector<Edge>& edges) {
  std::vector<KeyedEdge> keyed;
  keyed.reserve(edges.size());
  for (const Edge& edge : edges) keyed.push_back({squared_length(points[edge.a], points[edge.b]), edge});
  std::sort(keyed.begin(), keyed.end(), rounded_order);

  // Where two neighbours certainly differ, so does everything before from everything after.
  const ExactOrder exact_order(points);
  for (auto first = keyed.begin(); first != keyed.end();) {
    auto last = first + 1;
    while (last != keyed.end() && !certainly_less((last - 1)->squared_length, last->squared_length)) ++last;
    if (!std::is_sorted(first, last, exact_order)) std::sort(first, last, exact_order);
    first = last;
  }
  std::transform(keyed.begin(), keyed.end(), edges.begin(), [](const KeyedEdge& k) { return k.edge; });
}

}  // namespace mwt
