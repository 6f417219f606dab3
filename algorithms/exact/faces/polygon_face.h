// Minimum weight triangulation of a face whose boundary is in one piece: interval dynamic program over candidates.
//
// The corners of such a face, in the order of the walk, are the positions 0 .. L-1 of a weakly simple polygon. A
// candidate joins two definite corners, and because the boundary is connected, three candidates or boundary edges
// between three positions bound an empty triangle; so the program over intervals of positions (P. D. Gilbert 1979, G.
// T. Klincsek 1980), restricted to candidates, is exact, with slits and repeated vertices as well.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_walk.h"
#include "geometry/numbers/double_double.h"
#include "geometry/weight.h"

namespace mwt {

/// Triangles and the total length of those of their sides that are no boundary edges.
struct FaceTriangles {
  std::vector<Triangle> triangles;
  LengthSum diagonals;
};

struct PolygonFaceCounters {
  std::uint64_t cells = 0;                ///< intervals whose optimum was computed
  std::uint64_t precise_comparisons = 0;  ///< comparisons of sums that doubles could not decide
  std::uint64_t undecided_ties = 0;       ///< of these, sums that no available precision could compare
};

enum class PolygonFaceOutcome {
  solved,
  not_a_polygon,     ///< candidates lead to other components (holes, isolated vertices) or cross the boundary
  no_triangulation,  ///< by candidates
  out_of_time,
};

/// Solves faces one after the other in the same memory. Not for concurrent use: one object per thread.
///
/// Exact: each interval's best apex is found in doubles with a proven error bound, what that leaves open is compared in
/// double-double arithmetic, and what that leaves open by compare_length_sums(). Of equal options, always the same
/// one is kept.
///
/// For L corners and m candidates O(L + m) space; time O(L + m) for small faces, in general the sum over the candidates
/// of the candidates at one of their ends.
class PolygonFaceSolver {
 public:
  explicit PolygonFaceSolver(const CandidateGraph& graph) : graph_(graph) {}

  /// Adds the face's optimal triangulation to `result`, unless the outcome is another than `solved`.
  /// Precondition: at least 3 corners.
  PolygonFaceOutcome solve(std::span<const Corner> corners, const Deadline& deadline, FaceTriangles& result);

  [[nodiscard]] const PolygonFaceCounters& counters() const { return counters_; }

 private:
  using Position = std::uint32_t;
  using Cell = std::uint32_t;

  // A cell (apex, j), the right part of cells (i, j) with i < apex.
  struct BackwardCell {
    Position apex;
    Cell cell;
    double value;
  };
  // A way to triangulate an interval: by an apex, given by the cells on its two sides.
  struct Option {
    Cell left = 0;
    Cell right = 0;
  };
  // A cell and the position its interval begins at.
  struct PlacedCell {
    Position from;
    Cell cell;
  };

  [[nodiscard]] bool collect_cells();
  void collect_positions_of_vertices();
  [[nodiscard]] bool leads_back(Position position, Index partner);
  [[nodiscard]] Position find_position(Index vertex, Position after, Index partner);
  void lay_out_backward_cells();
  [[nodiscard]] PolygonFaceOutcome compute_cells(const Deadline& deadline);
  void compute_row(Position from);
  [[nodiscard]] bool find_best_option(Position from, Cell cell, Option& best);
  [[nodiscard]] Option best_of_close_options(Position from, Cell cell, double threshold);
  [[nodiscard]] int compare_options(Position from, const Option& one, const Option& other);
  template <class Visit>
  void for_each_option(Cell cell, Visit visit) const;
  void collect_diagonals(Position from, const Option& option, std::vector<Edge>& edges);
  [[nodiscard]] bool emit(FaceTriangles& result);
  [[nodiscard]] bool turns_left(const Triangle& triangle) const;

  [[nodiscard]] bool is_boundary(Position from, Position to) const {
    return to == from + 1 || (from == 0 && to + 1 == corners_.size());
  }
  [[nodiscard]] DoubleDouble value(const Option& option) const { return value_[option.left] + value_[option.right]; }

  const CandidateGraph& graph_;
  PolygonFaceCounters counters_;

  std::span<const Corner> corners_;
  std::vector<std::pair<Index, Position>> positions_;  // of the vertices, sorted
  std::vector<std::uint32_t> passed_;                  // by position: its candidates up to the last one found

  // Cells (i, j), i < j, row by row, ascending j: boundary edges and candidates.
  std::vector<Cell> first_;
  std::vector<Position> to_;
  std::vector<DoubleDouble> value_;  // lengths of the diagonals in the cell's triangulation, the cell's own included
  std::vector<Option> best_;

  // For each j the cells (i, j) that have a triangulation, descending i.
  std::vector<Cell> backward_first_;
  std::vector<Cell> backward_end_;
  std::vector<BackwardCell> backward_;

  // The current row by j: values (infinite where there is no cell) and cells.
  std::vector<double> row_value_;
  std::vector<Cell> row_cell_;

  std::vector<Option> close_;
  std::vector<PlacedCell> stack_;
  std::vector<Edge> one_;
  std::vector<Edge> other_;
};

}  // namespace mwt
