#include "algorithms/exact/faces/polygon_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNoPosition = std::numeric_limits<std::uint32_t>::max();

// Faces of up to this many corners are solved whatever the time.
constexpr std::size_t kSmallFace = 32;

// The largest sum of two values' high parts that is not surely worse than the least such sum. Among sums that underflow
// all are close.
double close_above(double least) {
  if (least == 0) return 0;
  if (least < kMinTrustedLength) return std::numeric_limits<double>::max();
  return least + least * kRoundedSumMargin;
}

}  // namespace

PolygonFaceOutcome PolygonFaceSolver::solve(std::span<const Corner> corners, const Deadline& deadline,
                                            FaceTriangles& result) {
  corners_ = corners;
  if (!collect_cells()) return PolygonFaceOutcome::not_a_polygon;
  lay_out_backward_cells();
  const PolygonFaceOutcome outcome = compute_cells(deadline);
  if (outcome != PolygonFaceOutcome::solved) return outcome;
  return emit(result) ? PolygonFaceOutcome::solved : PolygonFaceOutcome::not_a_polygon;
}

bool PolygonFaceSolver::turns_left(const Triangle& triangle) const {
  return orientation(graph_.points[triangle[0]], graph_.points[triangle[1]], graph_.points[triangle[2]]) > 0;
}

// Counter-clockwise around a corner its candidates end at ascending positions, those behind the corner's own last. If
// every candidate is found from its first end, the candidates' halfedges in all corners are twice as many.
bool PolygonFaceSolver::collect_cells() {
  const auto size = static_cast<Position>(corners_.size());
  collect_positions_of_vertices();
  passed_.assign(size, 0);
  first_.clear();
  to_.clear();
  std::uint64_t halfedges = 0;
  std::uint64_t diagonals = 0;
  for (Position from = 0; from < size; ++from) {
    first_.push_back(static_cast<Cell>(to_.size()));
    const Corner& corner = corners_[from];
    Position last = from + 1;
    if (last < size) to_.push_back(last);
    halfedges += corner.candidates;
    for (std::uint32_t i = 0; i < corner.candidates; ++i) {
      last = find_position(candidate_of(graph_, corner, i), last, corner.vertex);
      if (last == kNoPosition) break;
      to_.push_back(last);
      ++diagonals;
    }
    if (from == 0) to_.push_back(size - 1);
  }
  first_.push_back(static_cast<Cell>(to_.size()));
  return size >= 4 && halfedges == 2 * diagonals;
}

void PolygonFaceSolver::collect_positions_of_vertices() {
  positions_.clear();
  for (Position p = 0; p < corners_.size(); ++p) positions_.emplace_back(corners_[p].vertex, p);
  std::sort(positions_.begin(), positions_.end());
}

// Callers visit candidates in corner order, so the search continues where it found the last one.
bool PolygonFaceSolver::leads_back(Position position, Index partner) {
  const Corner& corner = corners_[position];
  std::uint32_t& passed = passed_[position];
  for (std::uint32_t i = passed; i < corner.candidates; ++i) {
    if (candidate_of(graph_, corner, i) != partner) continue;
    passed = i + 1;
    return true;
  }
  return leads_to(graph_, corner, partner);
}

// The corner of `vertex` behind position `after` that the edge from `partner` reaches.
PolygonFaceSolver::Position PolygonFaceSolver::find_position(Index vertex, Position after, Index partner) {
  const auto first_behind = std::pair(vertex, after + 1);
  for (auto it = std::lower_bound(positions_.begin(), positions_.end(), first_behind);
       it != positions_.end() && it->first == vertex; ++it) {
    if (leads_back(it->second, partner)) return it->second;
  }
  return kNoPosition;
}

void PolygonFaceSolver::lay_out_backward_cells() {
  const std::size_t size = corners_.size();
  backward_first_.assign(size + 1, 0);
  for (const Position to : to_) ++backward_first_[to + 1];
  for (std::size_t p = 1; p <= size; ++p) backward_first_[p] += backward_first_[p - 1];
  backward_end_.assign(backward_first_.begin(), backward_first_.end() - 1);
  backward_.resize(to_.size());
  value_.resize(to_.size());
  best_.resize(to_.size());
  row_value_.assign(size, kInfinity);
  row_cell_.resize(size);
}

PolygonFaceOutcome PolygonFaceSolver::compute_cells(const Deadline& deadline) {
  for (auto from = static_cast<Position>(corners_.size() - 1); from-- > 0;) {
    const bool late = corners_.size() > kSmallFace && has_passed(deadline);
    if (late) return PolygonFaceOutcome::out_of_time;
    compute_row(from);
  }
  const Cell last = backward_end_.back() - 1;  // exists: the boundary edge to the last position
  return backward_[last].apex == 0 ? PolygonFaceOutcome::solved : PolygonFaceOutcome::no_triangulation;
}

void PolygonFaceSolver::compute_row(Position from) {
  for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
    const Position to = to_[cell];
    value_[cell] = 0;
    if (to != from + 1) {
      if (!find_best_option(from, cell, best_[cell])) continue;
      value_[cell] = value(best_[cell]);
      if (!is_boundary(from, to)) {
        value_[cell] += length(graph_.points[corners_[from].vertex], graph_.points[corners_[to].vertex]);
      }
      ++counters_.cells;
    }
    row_value_[to] = value_[cell].high;
    row_cell_[to] = cell;
    backward_[backward_end_[to]++] = {from, cell, value_[cell].high};
  }
  for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) row_value_[to_[cell]] = kInfinity;
}

// Calls visit(option, sum of the values' high parts) for each apex; the sum is infinite where the row has no cell.
template <class Visit>
void PolygonFaceSolver::for_each_option(Cell cell, Visit visit) const {
  const Position to = to_[cell];
  for (Cell i = backward_first_[to]; i < backward_end_[to]; ++i) {
    const BackwardCell& right = backward_[i];
    visit(Option{row_cell_[right.apex], right.cell}, row_value_[right.apex] + right.value);
  }
}

bool PolygonFaceSolver::find_best_option(Position from, Cell cell, Option& best) {
  double least = kInfinity;
  double second = kInfinity;
  for_each_option(cell, [&](const Option& option, double sum) {
    if (sum < least) {
      second = least;
      least = sum;
      best = option;
    } else if (sum < second) {
      second = sum;
    }
  });
  if (least == kInfinity) return false;
  const double threshold = close_above(least);
  if (second <= threshold) best = best_of_close_options(from, cell, threshold);
  return true;
}

PolygonFaceSolver::Option PolygonFaceSolver::best_of_close_options(Position from, Cell cell, double threshold) {
  std::optional<Option> best;
  close_.clear();
  for_each_option(cell, [&](const Option& option, double sum) {
    if (sum <= threshold) close_.push_back(option);
  });
  for (const Option& option : close_) {
    if (!best || compare_options(from, option, *best) < 0) best = option;
  }
  return *best;
}

int PolygonFaceSolver::compare_options(Position from, const Option& one, const Option& other) {
  ++counters_.precise_comparisons;
  const DoubleDouble sum = value(one);
  const double difference = (sum - value(other)).high;
  const double error = 3 * (static_cast<double>(corners_.size()) + 8) * kDoubleDoubleError * sum.high;
  if (sum.high >= kMinTrustedLength && std::abs(difference) > error) return difference > 0 ? 1 : -1;
  collect_diagonals(from, one, one_);
  collect_diagonals(from, other, other_);
  const std::optional<int> sign = compare_length_sums(graph_.points, one_, other_);
  if (!sign) ++counters_.undecided_ties;
  return sign.value_or(0);
}

void PolygonFaceSolver::collect_diagonals(Position from, const Option& option, std::vector<Edge>& edges) {
  edges.clear();
  stack_.assign({{from, option.left}, {to_[option.left], option.right}});
  while (!stack_.empty()) {
    const auto [begin, cell] = stack_.back();
    stack_.pop_back();
    const Position end = to_[cell];
    if (end == begin + 1) continue;
    edges.push_back(make_edge(corners_[begin].vertex, corners_[end].vertex));
    const Option& best = best_[cell];
    stack_.push_back({begin, best.left});
    stack_.push_back({to_[best.left], best.right});
  }
}

// Where a candidate crosses the face's boundary, the program's triangles may overlap or lie outside, but then some of
// them do not turn left: those that all do cover the face once (see polygon_dp.h).
bool PolygonFaceSolver::emit(FaceTriangles& result) {
  const std::size_t before = result.triangles.size();
  one_.clear();  // the diagonals
  stack_.assign({{0, first_[1] - 1}});
  while (!stack_.empty()) {
    const auto [begin, cell] = stack_.back();
    stack_.pop_back();
    const Position end = to_[cell];
    if (end == begin + 1) continue;
    const Option& best = best_[cell];
    const Position apex = to_[best.left];
    const Triangle triangle{corners_[begin].vertex, corners_[apex].vertex, corners_[end].vertex};
    if (!turns_left(triangle)) {
      result.triangles.resize(before);
      return false;
    }
    result.triangles.push_back(triangle);
    if (!is_boundary(begin, end)) one_.push_back({triangle[0], triangle[2]});
    stack_.push_back({begin, best.left});
    stack_.push_back({apex, best.right});
  }
  for (const Edge& diagonal : one_) result.diagonals.add(graph_.points[diagonal.a], graph_.points[diagonal.b]);
  return true;
}

}  // namespace mwt
