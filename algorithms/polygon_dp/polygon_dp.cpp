#include "algorithms/polygon_dp/polygon_dp.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/polygon_dp/convex_polygon.h"
#include "algorithms/proof/convex_proof.h"
#include "base/error.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/double_double.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rows of the table that are filled together.
constexpr std::size_t kBlock = 16;

// The table of the dynamic program. Entry (i, j) is the cost of the chain from i to j with its chord: the chord's
// length once for a side of the polygon, `diagonal_factor` times for a diagonal, plus the best split's two entries.
class IntervalTable {
 public:
  IntervalTable(Points points, std::span<const Index> polygon, double diagonal_factor)
      : points_(points),
        polygon_(polygon),
        size_(polygon.size()),
        diagonal_factor_(diagonal_factor),
        high_(size_ * size_, kInfinity),
        low_(size_ * size_, 0.0) {
    for (std::size_t i = 0; i + 1 < size_; ++i) set(i, i + 1, chord_length(i, i + 1));
    for (std::size_t end = size_ - 1; end > 0;) {
      const std::size_t first = end - std::min(end, kBlock);
      fill_rows(first, end);
      end = first;
    }
  }

  // Whether the chain from i to j can be triangulated.
  [[nodiscard]] bool is_feasible(std::size_t i, std::size_t j) const { return high_[i * size_ + j] < kInfinity; }

  [[nodiscard]] DoubleDouble cost(std::size_t i, std::size_t j) const {
    return {high_[i * size_ + j], low_[i * size_ + j]};
  }

  // The first k for which triangle (i, k, j) is best; `size()` if none turns left with feasible rests.
  [[nodiscard]] std::size_t best_split(std::size_t i, std::size_t j) const {
    const double any_bound = min_sum(i, j);
    if (any_bound == kInfinity) return size_;
    const std::size_t k = best_split_near(i, j, any_bound);
    return k != size_ ? k : best_split_near(i, j, min_left_turning_sum(i, j));
  }

 private:
  // Rows first .. end - 1, those after them being complete. Like the source report's loop over gaps, this takes (i, j)
  // after all (i, k) and (k, j), and so gives the same table. But row j serves several rows i while it is in cache,
  // which halves the time from 2000 vertices on.
  void fill_rows(std::size_t first, std::size_t end) {
    for (std::size_t j = first + 2; j < size_; ++j) {
      for (std::size_t i = std::min(end, j - 1); i-- > first;) fill(i, j);
    }
  }

  void fill(std::size_t i, std::size_t j) {
    const std::size_t k = best_split(i, j);
    if (k == size_) return;
    const bool is_side = i == 0 && j + 1 == size_;
    const double factor = is_side ? 1 : diagonal_factor_;
    const DoubleDouble chord = chord_length(i, j);
    set(i, j, DoubleDouble{factor * chord.high, factor * chord.low} + (cost(i, k) + cost(k, j)));
  }

  // Both (i, j) and (j, i), so that both factors of a split's loop over k lie in rows.
  void set(std::size_t i, std::size_t j, const DoubleDouble& value) {
    high_[i * size_ + j] = high_[j * size_ + i] = value.high;
    low_[i * size_ + j] = low_[j * size_ + i] = value.low;
  }

  // The smallest sum over all splits, whichever way their triangles turn. Four minima side by side keep the
  // processor busy; this loop is where the time goes.
  [[nodiscard]] double min_sum(std::size_t i, std::size_t j) const {
    const double* left = &high_[i * size_];
    const double* right = &high_[j * size_];
    std::array<double, 4> smallest = {kInfinity, kInfinity, kInfinity, kInfinity};
    std::size_t k = i + 1;
    for (; k + 4 <= j; k += 4) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        smallest[lane] = std::min(smallest[lane], left[k + lane] + right[k + lane]);
      }
    }
    for (; k < j; ++k) smallest[0] = std::min(smallest[0], left[k] + right[k]);
    return std::min(std::min(smallest[0], smallest[1]), std::min(smallest[2], smallest[3]));
  }

  [[nodiscard]] double min_left_turning_sum(std::size_t i, std::size_t j) const {
    double smallest = kInfinity;
    for (std::size_t k = i + 1; k < j; ++k) {
      const double sum = high_[i * size_ + k] + high_[j * size_ + k];
      if (sum < smallest && turns_left(i, k, j)) smallest = sum;
    }
    return smallest;
  }

  // The best of the left-turning splits whose rounded sum is `bound` or so close above it that rounding may have
  // exchanged them.
  [[nodiscard]] std::size_t best_split_near(std::size_t i, std::size_t j, double bound) const {
    if (bound == kInfinity) return size_;
    const double limit = bound * (1 + kRoundedSumMargin);
    std::size_t best = size_;
    DoubleDouble best_sum = kInfinity;
    for (std::size_t k = next_near(i, j, i + 1, limit); k < j; k = next_near(i, j, k + 1, limit)) {
      if (!turns_left(i, k, j)) continue;
      const DoubleDouble sum = cost(i, k) + cost(k, j);
      if (sum < best_sum) {
        best_sum = sum;
        best = k;
      }
    }
    return best;
  }

  // The first split from k on whose rounded sum is at most `limit`, else j.
  [[nodiscard]] std::size_t next_near(std::size_t i, std::size_t j, std::size_t k, double limit) const {
    const double* left = &high_[i * size_];
    const double* right = &high_[j * size_];
    while (k < j && left[k] + right[k] > limit) ++k;
    return k;
  }

  [[nodiscard]] const Point& at(std::size_t i) const { return points_[polygon_[i]]; }
  [[nodiscard]] bool turns_left(std::size_t i, std::size_t k, std::size_t j) const {
    return orientation(at(i), at(k), at(j)) > 0;
  }
  [[nodiscard]] DoubleDouble chord_length(std::size_t i, std::size_t j) const { return length(at(i), at(j)); }

  Points points_;
  std::span<const Index> polygon_;
  std::size_t size_;
  double diagonal_factor_;
  std::vector<double> high_;  // costs in double-double; infinity where there is no triangulation
  std::vector<double> low_;
};

std::vector<Triangle> preorder_triangles(const IntervalTable& table, std::span<const Index> polygon) {
  std::vector<Triangle> triangles;
  triangles.reserve(polygon.size() - 2);
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, polygon.size() - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = table.best_split(i, j);
    triangles.push_back({polygon[i], polygon[k], polygon[j]});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
  return triangles;
}

void require_convex_position(Points points, const std::vector<Index>& hull) {
  if (hull.size() == points.size()) return;
  std::vector<bool> on_hull(points.size(), false);
  for (const Index p : hull) on_hull[p] = true;
  const auto inner = std::find(on_hull.begin(), on_hull.end(), false) - on_hull.begin();
  throw NotApplicable("polygon_dp takes points on the boundary of their convex hull only; point " +
                      std::to_string(inner) + " lies inside");
}

Solution solve(Points points, Context& context) {
  const std::vector<Index> hull = convex_hull(points);
  require_convex_position(points, hull);
  const bool by_edges = context.parameters.text("objective") == "edges";
  Solution solution;
  {
    const OtherDeadline leaving_time(context, deadline_before_heuristics(context.deadline, points.size()));
    ConvexPolygonSolution result = triangulate_convex_polygon(
        points, hull, by_edges ? PolygonObjective::edges : PolygonObjective::perimeter, context);
    solution.triangulation = {static_cast<Index>(points.size()), std::move(result.triangles)};
    solution.stop_reason = result.stop_reason;
    if (by_edges) solution.optimum = {result.weight_of_optimum.lower, weight(points, solution.triangulation).upper};
    if (by_edges && context.proof != nullptr) note_convex_polygon(points, hull, solution.stop_reason, context);
  }
  if (solution.stop_reason) improve_by_heuristics(points, context, solution);
  return solution;
}

Solution solve_at_any_size(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

PolygonTriangulation triangulate_polygon(Points points, std::span<const Index> polygon, PolygonObjective objective) {
  const std::size_t n = polygon.size();
  if (n < 3) throw InputError("triangulate_polygon: a polygon has at least 3 vertices, not " + std::to_string(n));
  const IntervalTable table(points, polygon, objective == PolygonObjective::edges ? 1 : 2);
  if (!table.is_feasible(0, n - 1)) {
    throw InputError("triangulate_polygon: the cycle has no triangulation; it must be simple and counter-clockwise");
  }
  // A length errs by 8 units and passes through at most 2n additions, of one unit each.
  const double relative_error = (2 * static_cast<double>(n) + 16) * kDoubleDoubleError;
  return {preorder_triangles(table, polygon), enclose(table.cost(0, n - 1), relative_error)};
}

AlgorithmInfo polygon_dp_entry() {
  AlgorithmInfo info;
  info.name = "polygon_dp";
  info.summary = "interval dynamic program; points in convex position only";
  info.source = "source report, section 5.2 step 3; Gilbert 1979, Klincsek 1980";
  info.guarantee = "optimal; with too little time or memory a certified interval";
  info.time = "O(n^3)";
  info.space = "O(n^2)";
  info.exactness = Exactness::exact;
  info.has_proofs = true;
  info.max_n = 20'000;
  info.version = 3;
  info.convex_position_only = true;
  info.parameters = {{"objective",
                      ParameterType::choice,
                      "edges",
                      "what is minimised: the weight, or the source report's perimeter sum (no certified optimum)",
                      {"edges", "perimeter"}}};
  info.function = solve_at_any_size;
  return info;
}

}  // namespace mwt
