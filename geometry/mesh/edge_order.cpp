#include "geometry/mesh/edge_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "geometry/mesh/radix_sort.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

struct Differences {
  DoubleDouble x, y;  // exact
};

Differences differences(const Point& p, const Point& q) { return {exact_sum(p.x, -q.x), exact_sum(p.y, -q.y)}; }

// Sorted magnitudes of the two differences: equal ones span segments of equal length.
std::array<DoubleDouble, 2> shape(const Point& p, const Point& q) {
  auto [x, y] = differences(p, q);
  if (x.high < 0) x = -x;
  if (y.high < 0) y = -y;
  return x < y ? std::array{x, y} : std::array{y, x};
}

}  // namespace

bool is_surely_shorter(const EdgeKey& one, const EdgeKey& two) {
  const DoubleDouble& a = one.squared_length;
  const DoubleDouble& b = two.squared_length;
  if (!is_trusted_product(a.high) || !is_trusted_product(b.high)) return false;
  if (one.exact && two.exact) return a < b;
  constexpr double kKeyMargin = 0x1p-95;  // each key errs by 2^-97 of itself, their difference by 2^-100
  return (a - b).high < -kKeyMargin * (a.high + b.high);
}

EdgeKey EdgeOrder::key(Index a, Index b, std::uint32_t tag) const {
  const auto [x, y] = differences(points_[a], points_[b]);
  const DoubleDouble xx = square(x), yy = square(y);
  DoubleDouble sum = xx + yy;
  const bool overflowed = !(sum.high < std::numeric_limits<double>::max());
  if (overflowed) sum = std::numeric_limits<double>::infinity();  // not the NaN of inf - inf
  // Squares that fit one double, added without error.
  const auto no_underflow = [](const DoubleDouble& part, const DoubleDouble& part_squared) {
    return part.high == 0 || is_trusted_product(part_squared.high);
  };
  const bool exact = is_trusted_product(sum.high) && x.low == 0 && y.low == 0 && xx.low == 0 && yy.low == 0 &&
                     no_underflow(x, xx) && no_underflow(y, yy);
  return {sum, a, b, tag, exact};
}

// Known without further computation, by exact squares or congruent differences. False does not mean that they differ.
bool EdgeOrder::have_equal_lengths(const EdgeKey& one, const EdgeKey& two) const {
  if (one.exact && two.exact) return one.squared_length == two.squared_length;
  return shape(points_[one.a], points_[one.b]) == shape(points_[two.a], points_[two.b]);
}

// -1, 0, +1 as the first edge is shorter, equal or longer. From cheap to costly.
int EdgeOrder::compare_lengths(const EdgeKey& one, const EdgeKey& two) const {
  if (is_surely_shorter(one, two)) return -1;
  if (is_surely_shorter(two, one)) return 1;
  if (have_equal_lengths(one, two)) return 0;
  return compare_length(points_[one.a], points_[one.b], points_[two.a], points_[two.b]);
}

bool EdgeOrder::precedes_slow(const EdgeKey& one, const EdgeKey& two) const {
  if (is_surely_shorter(one, two)) return true;
  if (is_same_edge(one, two)) return false;
  const int sign = compare_lengths(one, two);
  return sign != 0 ? sign < 0 : labelled(one.a, one.b) < labelled(two.a, two.b);
}

// Edges of one length, by `high` first, then stably by `low`: linear time for the ties of large lattices.
void EdgeOrder::sort_by_labels(std::span<EdgeKey> edges) const {
  const auto bits_of = [](std::uint64_t value) { return static_cast<int>(std::bit_width(value)); };
  const int place_bits = bits_of(edges.size());
  const std::uint64_t place_mask = (std::uint64_t{1} << place_bits) - 1;
  KeptVector<std::uint64_t> order, buffer;
  order.reserve(edges.size());
  Index largest = 0;
  for (std::uint64_t i = 0; i < edges.size(); ++i) {
    const Index high = labelled(edges[i].a, edges[i].b).b;
    largest = std::max(largest, high);
    order.push_back((std::uint64_t{high} << place_bits) | i);
  }
  radix_sort(order, place_bits, place_bits + bits_of(largest), buffer);
  for (std::uint64_t& entry : order) {
    const std::uint64_t place = entry & place_mask;
    entry = (std::uint64_t{labelled(edges[place].a, edges[place].b).a} << place_bits) | place;
  }
  radix_sort(order, place_bits, place_bits + bits_of(largest), buffer);
  std::vector<EdgeKey> sorted;
  sorted.reserve(edges.size());
  for (const std::uint64_t entry : order) sorted.push_back(edges[entry & place_mask]);
  std::copy(sorted.begin(), sorted.end(), edges.begin());
}

// Sorts edges whose lengths agree in 100 bits.
void EdgeOrder::sort_nearly_equal(std::span<EdgeKey> edges) const {
  constexpr std::size_t kManyEdges = 64;
  const auto is_as_long_as_the_first = [&](const EdgeKey& e) { return have_equal_lengths(e, edges.front()); };
  if (edges.size() > kManyEdges && std::all_of(edges.begin(), edges.end(), is_as_long_as_the_first)) {
    sort_by_labels(edges);
  } else {
    std::sort(edges.begin(), edges.end(), [this](const EdgeKey& x, const EdgeKey& y) { return precedes_slow(x, y); });
  }
}

void EdgeOrder::sort(std::span<EdgeKey> edges) const {
  std::sort(edges.begin(), edges.end(),
            [](const EdgeKey& x, const EdgeKey& y) { return x.squared_length < y.squared_length; });
  for (std::size_t first = 0, last = 1; first < edges.size(); first = last++) {
    while (last < edges.size() && !is_surely_shorter(edges[last - 1], edges[last])) ++last;
    if (last - first > 1) sort_nearly_equal(edges.subspan(first, last - first));
  }
}

namespace {

struct MeasuredEdge {
  double squared_length;
  Edge edge;
};

// Calls must_stop() once per 65,536 steps; throws if it returns true, for nothing else leads out of std::sort.
class StopCheck {
 public:
  struct Stopped {};

  explicit StopCheck(const std::function<bool()>& must_stop) : must_stop_(must_stop) {}

  void count(std::size_t steps) {
    constexpr std::size_t kStepsBetweenChecks = std::size_t{1} << 16;
    steps_ += steps;
    if (steps_ < kStepsBetweenChecks) return;
    steps_ = 0;
    if (must_stop_()) throw Stopped{};
  }

 private:
  const std::function<bool()>& must_stop_;
  std::size_t steps_ = 0;
};

std::vector<MeasuredEdge> sorted_by_rounded_length(Points points, const std::vector<Edge>& edges, StopCheck& check) {
  std::vector<MeasuredEdge> result;
  result.reserve(edges.size());
  for (const Edge& edge : edges) {
    check.count(1);
    const double dx = points[edge.a].x - points[edge.b].x, dy = points[edge.a].y - points[edge.b].y;
    result.push_back({dx * dx + dy * dy, edge});
  }
  std::sort(result.begin(), result.end(), [&](const MeasuredEdge& x, const MeasuredEdge& y) {
    check.count(1);
    return x.squared_length < y.squared_length;
  });
  return result;
}

void sort(Points points, std::vector<Edge>& edges, StopCheck& check) {
  const std::vector<MeasuredEdge> measured = sorted_by_rounded_length(points, edges, check);
  const EdgeOrder order(points);
  std::vector<EdgeKey> run;
  auto out = edges.begin();
  // Where two neighbours certainly differ, so does everything before from everything after.
  for (std::size_t first = 0, last = 1; first < measured.size(); first = last++) {
    const auto differ = [](const MeasuredEdge& x, const MeasuredEdge& y) {
      return EdgeOrder::surely_differ(x.squared_length, y.squared_length);
    };
    while (last < measured.size() && !differ(measured[last - 1], measured[last])) ++last;
    constexpr std::size_t kStepsOfExactComparisons = 64;
    check.count(last - first == 1 ? 1 : kStepsOfExactComparisons * (last - first));
    run.clear();
    for (std::size_t i = first; i < last; ++i) run.push_back(order.key(measured[i].edge.a, measured[i].edge.b));
    order.sort(run);
    for (const EdgeKey& key : run) *out++ = {key.a, key.b};
  }
}

}  // namespace

bool sort_by_length(Points points, std::vector<Edge>& edges, const std::function<bool()>& must_stop) {
  StopCheck check(must_stop);
  try {
    sort(points, edges, check);
    return true;
  } catch (const StopCheck::Stopped&) {
    return false;
  }
}

void sort_by_length(Points points, std::vector<Edge>& edges) {
  static_cast<void>(sort_by_length(points, edges, [] { return false; }));
}

}  // namespace mwt
