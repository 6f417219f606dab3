// The dynamic program over intervals of a boundary: minimum weight triangulations of all its parts that a chord cuts
// off.
//
// P. D. Gilbert 1979, G. T. Klincsek 1980; here restricted to given chords, for boundaries that may touch themselves.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/deadline.h"
#include "geometry/numbers/double_double.h"
#include "geometry/triangulation.h"

namespace mwt {

/// One boundary after the other in the same memory. Not for concurrent use: one object per thread.
///
/// Positions 0 .. L-1 follow the boundary, the inside on the left. A cell (i, j), i < j, is a side of the boundary
/// (j = i + 1, or the closing side from the last position to the first) or a chord that may be used; its value is the
/// least total length of chords, itself included, that triangulate the part between the boundary from i to j and it.
///
/// Exact: each cell's best apex is found in doubles with a proven error bound, what that leaves open is compared in
/// double-double arithmetic, and what that leaves open by compare_length_sums(). Of equal options, always the same one
/// is kept. Values err by at most value_error() of themselves.
///
/// For m cells O(L + m) space; time O(L + m) for short boundaries, in general the sum over the cells of the cells at
/// one of their ends, divided by up to 64 where few of these meet cells of the other end (chains that face each other).
class IntervalProgram {
 public:
  using Position = std::uint32_t;
  using Cell = std::uint32_t;
  static constexpr Cell kNoCell = 0xFFFFFFFF;

  /// A way to triangulate an interval: by an apex, given by the cells on its two sides.
  struct Option {
    Cell left = 0;
    Cell right = 0;
  };

  struct Counters {
    std::uint64_t cells = 0;                ///< chords and closing sides whose value was computed
    std::uint64_t precise_comparisons = 0;  ///< comparisons of sums that doubles could not decide
    std::uint64_t undecided_ties = 0;       ///< of these, sums that no available precision could compare
  };

  explicit IntervalProgram(Points points) : points_(points) {}

  /// Forgets the boundary. Then, for one position after the other: add_position(), and add_cell() or add_copy() for its
  /// cells, `to` ascending, beginning with the next position.
  void clear();
  void add_position(Index vertex);
  void add_cell(Position to);
  /// A cell whose interval repeats, vertex by vertex, that of another cell `period` positions later; computed there.
  void add_copy(Position to, Position period);

  /// `is_closed`: cell (0, L-1) is the closing side of the boundary, so that it has no length. Whether the deadline
  /// allowed it; it does not matter for up to kSmall positions.
  [[nodiscard]] bool compute(bool is_closed, const Deadline& deadline);

  [[nodiscard]] Position size() const { return static_cast<Position>(vertex_.size()); }
  [[nodiscard]] Index vertex(Position position) const { return vertex_[position]; }
  [[nodiscard]] Cell cell_count() const { return static_cast<Cell>(to_.size()); }
  [[nodiscard]] std::pair<Cell, Cell> row(Position from) const { return {first_[from], first_[from + 1]}; }
  [[nodiscard]] Position to(Cell cell) const { return to_[cell]; }
  [[nodiscard]] Cell find(Position from, Position to) const;  ///< kNoCell if there is none

  /// After compute():
  [[nodiscard]] bool is_feasible(Cell cell) const { return value_[cell].high < kInfeasible; }
  [[nodiscard]] const DoubleDouble& value(Cell cell) const { return value_[cell]; }
  [[nodiscard]] double value_error() const { return 3 * (static_cast<double>(size()) + 8) * kDoubleDoubleError; }
  /// The last cell of a closed boundary: its closing side.
  [[nodiscard]] Cell closing_cell() const { return first_[1] - 1; }

  /// Calls visit(triangle, is_chord) for each triangle of the cell's best triangulation, counter-clockwise from the
  /// cell's first vertex, its side from the first to the last corner being a chord or not. While visit() is true;
  /// returns whether it always was. Precondition: the cell is feasible.
  template <class Visit>
  bool visit_triangles(Position from, Cell cell, Visit visit);

  /// For a closed boundary, after compute(): what a triangulation of the whole that contains a cell's chord costs at
  /// least beyond the best one, for all cells. A triangulation has a triangle on the chord's outer side; it costs the
  /// excess of its sides' values over that of its own outer side, and that side's outside cost in turn.
  ///
  /// `outside`, by cell, holds what other triangles on the outer side, not made of cells, cost (infinity where there
  /// are none; -1: the cell must not be used), and is lowered to the least of both; costs beyond `limit` become
  /// infinite or stay too large. Rounded down. As long as compute().
  void add_outside_costs(double limit, std::vector<double>& outside) const;

  [[nodiscard]] const Counters& counters() const { return counters_; }

  static constexpr std::size_t kSmall = 32;
  static constexpr double kInfeasible = 1e308;  ///< values of cells without triangulation are not below

 private:
  // A cell (apex, j), the right part of cells (i, j) with i < apex.
  struct BackwardCell {
    Position apex;
    Cell cell;
    double value;
  };
  // Those of a position `to` whose apex is in the same block of 64 positions, as bits: the backward cells from `first`
  // on, by descending apex.
  struct Block {
    Position number;
    Cell first;
    std::uint64_t apexes;
  };
  struct Interval {
    Position from;
    Cell cell;
  };
  static constexpr Cell kCopy = kNoCell;
  static constexpr std::size_t kShort = 256;
  static constexpr Position kBlock = 64;

  void lay_out_backward_cells();
  void lay_out_blocks();
  void add_backward_cell(Position from, Cell cell);
  void compute_row(Position from);
  [[nodiscard]] bool compute_cell(Position from, Cell cell);
  [[nodiscard]] Interval without_copy(const Interval& interval) const;
  [[nodiscard]] bool find_best_option(Position from, Cell cell, Option& best);
  [[nodiscard]] Option best_of_close_options(Position from, Cell cell, double threshold);
  [[nodiscard]] int compare_options(Position from, const Option& one, const Option& other);
  template <class Visit>
  void for_each_option(Cell cell, Visit visit) const;
  template <class Visit>
  void for_each_meeting_cell(const Block& block, std::uint64_t apexes, Visit visit) const;
  template <class Visit>
  void for_each_computed_option(Position from, Cell cell, const std::vector<Cell>& row,
                                const std::vector<std::uint64_t>& row_block, Visit visit) const;
  void collect_diagonals(Position from, const Option& option, std::vector<Edge>& edges);

  [[nodiscard]] bool is_side(Position from, Position to) const {
    return to == from + 1 || (is_closed_ && from == 0 && to + 1 == size());
  }
  [[nodiscard]] DoubleDouble sum(const Option& option) const { return value_[option.left] + value_[option.right]; }

  Points points_;
  Counters counters_;
  bool is_closed_ = true;

  std::vector<Index> vertex_;
  // Cells row by row, ascending `to`.
  std::vector<Cell> first_;
  std::vector<Position> to_;
  std::vector<DoubleDouble> value_;
  std::vector<Option> best_;  // of a copy: {kCopy, the cell copied}
  Position period_ = 0;

  // For each j the feasible cells (i, j), descending i.
  std::vector<Cell> backward_first_;
  std::vector<Cell> backward_end_;
  std::vector<BackwardCell> backward_;
  // The same by blocks; only of boundaries longer than kShort.
  std::vector<Cell> block_first_;
  std::vector<Cell> block_end_;
  std::vector<Block> blocks_;

  // The current row by j: values (infinite where there is no cell) and cells, and which there are by blocks.
  std::vector<double> row_value_;
  std::vector<Cell> row_cell_;
  std::vector<std::uint64_t> row_block_;

  std::vector<Option> close_;
  std::vector<Interval> stack_;
  std::vector<Edge> one_;
  std::vector<Edge> other_;
};

template <class Visit>
bool IntervalProgram::visit_triangles(Position from, Cell cell, Visit visit) {
  stack_.assign({{from, cell}});
  while (!stack_.empty()) {
    const auto [begin, open] = without_copy(stack_.back());
    stack_.pop_back();
    const Position end = to_[open];
    if (end == begin + 1) continue;
    const Option& best = best_[open];
    const Position apex = to_[best.left];
    if (!visit(Triangle{vertex_[begin], vertex_[apex], vertex_[end]}, !is_side(begin, end))) return false;
    stack_.push_back({begin, best.left});
    stack_.push_back({apex, best.right});
  }
  return true;
}

}  // namespace mwt
