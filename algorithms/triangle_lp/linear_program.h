// A linear program that grows by rows and columns: the only code that calls GLPK.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"

namespace mwt {

/// Minimise cost . x subject to equations and x >= 0, all in doubles and with GLPK's tolerances: an optimum found here
/// is a proposal, which the caller certifies.
///
/// GLPK ends the process when it meets an error of its own. Here that only makes the program `failed()`: every later
/// call does nothing and solve() returns false. GLPK keeps one environment per thread, which this class frees with its
/// last use: at most one object may exist per thread at a time; different threads do not disturb each other.
class LinearProgram {
 public:
  /// A non-zero coefficient in some row or column.
  struct Entry {
    int position;  ///< the column, for an entry of a row; the row, for an entry of a column; from 0
    double value;
  };
  enum class Method { primal, dual };
  LinearProgram();
  ~LinearProgram();
  LinearProgram(const LinearProgram&) = delete;
  LinearProgram& operator=(const LinearProgram&) = delete;

  /// Appends the equation `entries` . x = right_side; returns its position.
  int add_row(std::span<const Entry> entries, double right_side);
  /// Gives a row a new right side, or none: then it is no restriction.
  void set_right_side(int row, std::optional<double> right_side);

  /// Appends a variable >= 0 of cost 0; returns its position.
  int add_column(std::span<const Entry> entries);
  void replace_column(int column, std::span<const Entry> entries);

  /// One cost per column.
  void set_costs(std::span<const double> costs);

  /// Whether an optimal basis was found, starting from the last one. `primal` suits new columns or costs, `dual` new
  /// rows or right sides. Deterministic, except for the deadline.
  [[nodiscard]] bool solve(Method method, const Deadline& deadline);

  /// The solution of the last successful solve().
  [[nodiscard]] double value(int column) const;
  [[nodiscard]] double dual(int row) const;

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] bool failed() const { return problem_ == nullptr; }

 private:
  template <class Action>
  bool guarded(Action action);
  void load(std::span<const Entry> entries);
  bool run_simplex(Method method, const Deadline& deadline);

  void* problem_ = nullptr;  // glp_prob; null after an error
  int rows_ = 0;
  int columns_ = 0;
  std::vector<int> positions_;  // entries in GLPK's form: from 1, element 0 unused
  std::vector<double> values_;
};

}  // namespace mwt
