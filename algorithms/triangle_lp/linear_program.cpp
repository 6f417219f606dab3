#include "algorithms/triangle_lp/linear_program.h"

#include <glpk.h>

#include <algorithm>
#include <climits>
#include <csetjmp>

namespace mwt {

namespace {

// GLPK is about to end the process. As its manual advises: free all it holds, then leave by a jump.
void jump_back(void* destination) {
  glp_free_env();
  std::longjmp(*static_cast<std::jmp_buf*>(destination), 1);
}

// GLPK prints errors on the terminal even in quiet mode; a hook that claims to have handled each message prevents that.
int swallow_message(void*, const char*) { return 1; }

glp_prob* glpk(void* problem) { return static_cast<glp_prob*>(problem); }

// Half of what is left until the deadline in milliseconds. GLPK's limit holds for the dual simplex method and, where
// that fails, once more for the primal one.
int time_slice_ms(const Deadline& deadline) {
  if (!deadline) return INT_MAX;
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(*deadline - deadline_clock());
  return static_cast<int>(std::clamp<long long>(left.count() / 2, 1, INT_MAX));
}

// How far GLPK may leave bounds and reduced costs violated: 100 times closer than its default, as its solutions are
// refined, and no closer, as its own rounding would keep it from ending.
constexpr double kSimplexTolerance = 1e-9;

glp_smcp simplex_options(LinearProgram::Method method, const Deadline& deadline) {
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = method == LinearProgram::Method::primal ? GLP_PRIMAL : GLP_DUALP;
  options.tol_bnd = kSimplexTolerance;
  options.tol_dj = kSimplexTolerance;
  options.tm_lim = time_slice_ms(deadline);
  return options;
}

}  // namespace

// Runs `action`, which must leave nothing to be destroyed when a jump cuts it short: it holds no objects with
// destructors.
template <class Action>
bool LinearProgram::guarded(Action action) {
  if (failed()) return false;
  std::jmp_buf destination;
  glp_error_hook(jump_back, &destination);
  if (setjmp(destination) != 0) {
    problem_ = nullptr;
    return false;
  }
  action(glpk(problem_));
  glp_error_hook(nullptr, nullptr);
  return true;
}

LinearProgram::LinearProgram() {
  glp_term_hook(swallow_message, nullptr);
  problem_ = glp_create_prob();
}

LinearProgram::~LinearProgram() {
  if (!failed()) glp_delete_prob(glpk(problem_));
  glp_free_env();
}

void LinearProgram::load(std::span<const Entry> entries) {
  positions_.assign(1, 0);
  values_.assign(1, 0);
  for (const Entry& entry : entries) {
    positions_.push_back(entry.position + 1);
    values_.push_back(entry.value);
  }
}

int LinearProgram::add_row(std::span<const Entry> entries, double right_side) {
  load(entries);
  guarded([&](glp_prob* problem) {
    const int row = glp_add_rows(problem, 1);
    glp_set_row_bnds(problem, row, GLP_FX, right_side, right_side);
    glp_set_mat_row(problem, row, static_cast<int>(positions_.size()) - 1, positions_.data(), values_.data());
  });
  return rows_++;
}

void LinearProgram::set_right_side(int row, std::optional<double> right_side) {
  const double bound = right_side.value_or(0);
  const int type = right_side ? GLP_FX : GLP_FR;
  guarded([&](glp_prob* problem) { glp_set_row_bnds(problem, row + 1, type, bound, bound); });
}

int LinearProgram::add_column(std::span<const Entry> entries) {
  guarded([&](glp_prob* problem) {
    const int column = glp_add_cols(problem, 1);
    glp_set_col_bnds(problem, column, GLP_LO, 0, 0);
  });
  replace_column(columns_, entries);
  return columns_++;
}

void LinearProgram::replace_column(int column, std::span<const Entry> entries) {
  load(entries);
  guarded([&](glp_prob* problem) {
    glp_set_mat_col(problem, column + 1, static_cast<int>(positions_.size()) - 1, positions_.data(), values_.data());
  });
}

void LinearProgram::set_costs(std::span<const double> costs) {
  guarded([&](glp_prob* problem) {
    for (int column = 0; column < columns_; ++column) {
      glp_set_obj_coef(problem, column + 1, costs[static_cast<std::size_t>(column)]);
    }
  });
}

// Slice by slice, each from the basis that the last one left.
bool LinearProgram::run_simplex(Method method, const Deadline& deadline) {
  bool optimal = false;
  int result = GLP_ETMLIM;
  while (result == GLP_ETMLIM && !has_passed(deadline)) {
    const bool survived = guarded([&](glp_prob* problem) {
      const glp_smcp options = simplex_options(method, deadline);
      result = glp_simplex(problem, &options);
      optimal = result == 0 && glp_get_status(problem) == GLP_OPT;
    });
    if (!survived) return false;
  }
  return optimal;
}

bool LinearProgram::solve(Method method, const Deadline& deadline) {
  if (run_simplex(method, deadline)) return true;
  // The last basis may have become singular: once more from the rows' own variables.
  const bool in_time = !has_passed(deadline);
  return in_time && guarded([](glp_prob* problem) { glp_std_basis(problem); }) && run_simplex(Method::dual, deadline);
}

double LinearProgram::value(int column) const { return failed() ? 0 : glp_get_col_prim(glpk(problem_), column + 1); }

double LinearProgram::dual(int row) const { return failed() ? 0 : glp_get_row_dual(glpk(problem_), row + 1); }

}  // namespace mwt
