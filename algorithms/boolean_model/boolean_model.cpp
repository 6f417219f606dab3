#include "algorithms/boolean_model/boolean_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/boolean_model/edge_program.h"
#include "algorithms/boolean_model/model_search.h"
#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/max_points.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/greedy/greedy.h"
#include "geometry/convex_hull.h"
#include "geometry/edge_faces.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// Models this much lighter than the best one, relatively, are not searched for: the interval stays within 1e-12.
constexpr double kPruningGap = 2e-13;

Interval length_of(Points points, const std::vector<Edge>& edges) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

double power_of_two_near_longest(Points points, const CrossingModel& model) {
  double longest = 0;
  for (const Edge& edge : model.edges) longest = std::max(longest, length(points[edge.a], points[edge.b]).high);
  return std::ldexp(1.0, std::ilogb(longest));
}

// Edges in this order, each unless it crosses one before: a model, for none can be added.
std::vector<std::uint32_t> first_model(const CrossingModel& model, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> chosen;
  for (const std::uint32_t e : order) {
    const bool is_free = std::none_of(chosen.begin(), chosen.end(), [&](std::uint32_t f) { return model.cross(e, f); });
    if (is_free) chosen.push_back(e);
  }
  return chosen;
}

class ModelSolver {
 public:
  ModelSolver(Points points, const CrossingModel& model, const Deadline& deadline)
      : points_(points), model_(model), deadline_(deadline), unit_(power_of_two_near_longest(points, model)) {
    best_ = edges_of(greedy_triangulation(points));
    upper_ = length_of(points, best_).upper;
  }

  // A certified lower bound on all models: at least the hull, which all contain.
  double run() {
    double lower = cycle_length(points_, convex_hull(points_)).lower;
    EdgeProgram program(points_, model_, unit_, deadline_);
    lower = std::max(lower, program.solve(enough() / unit_) * unit_);
    programs_ = program.programs();
    keep_if_lighter(model_near(program));
    if (lower >= enough()) return std::min(lower, upper_);
    const std::vector<ModelEdge> known = program.fixed_edges(enough() / unit_);
    fixed_ = model_.edges.size() - static_cast<std::size_t>(std::count(known.begin(), known.end(), ModelEdge::open));
    const ModelSummary summary = search_models(points_, model_, known, deadline_);
    stop_reason_ = summary.stop_reason;
    if (stop_reason_) return lower;
    // What the program excludes is not lighter than `enough` was.
    const double least = enough();
    if (summary.lightest.empty()) return least;
    keep_if_lighter(summary.lightest);
    return std::min(least, summary.weight.lower);
  }

  [[nodiscard]] const std::vector<Edge>& best() const { return best_; }
  [[nodiscard]] const std::optional<StopReason>& stop_reason() const { return stop_reason_; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }
  [[nodiscard]] std::size_t fixed() const { return fixed_; }

 private:
  [[nodiscard]] double enough() const { return upper_ * (1 - kPruningGap); }

  // What the program uses most first, then the shortest.
  [[nodiscard]] std::vector<std::uint32_t> model_near(const EdgeProgram& program) const {
    std::vector<std::uint32_t> order(model_.edges.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto length_of_edge = [&](std::uint32_t e) {
      return length(points_[model_.edges[e].a], points_[model_.edges[e].b]).high;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t e, std::uint32_t f) {
      const double more = program.use(e) - program.use(f);
      return more != 0 ? more > 0 : length_of_edge(e) < length_of_edge(f);
    });
    return first_model(model_, order);
  }

  void keep_if_lighter(const std::vector<std::uint32_t>& chosen) {
    if (chosen.size() != model_.size) throw std::logic_error("boolean_model: a model is no triangulation");
    std::vector<Edge> edges;
    for (const std::uint32_t e : chosen) edges.push_back(model_.edges[e]);
    const double found = length_of(points_, edges).upper;
    if (found >= upper_) return;
    upper_ = found;
    best_ = std::move(edges);
  }

  Points points_;
  const CrossingModel& model_;
  const Deadline& deadline_;
  double unit_;
  std::vector<Edge> best_;
  double upper_ = 0;
  std::uint64_t programs_ = 0;
  std::size_t fixed_ = 0;
  std::optional<StopReason> stop_reason_;
};

Solution solve(Points points, Context& context) {
  require_max_points("boolean_model", points, context);
  const CrossingModel model(points);
  Solution solution;
  const Deadline deadline = deadline_before_heuristics(context.deadline, points.size());
  ModelSolver solver(points, model, deadline);
  const double lower = [&] {
    const ScopedPhase phase(context, "search");
    return solver.run();
  }();
  solution.triangulation = triangulation_of(points, solver.best());
  const double upper = weight(points, solution.triangulation).upper;
  solution.optimum = {std::min(lower, upper), upper};
  solution.stop_reason = solver.stop_reason();
  if (solution.stop_reason) improve_by_heuristics(points, context, solution);
  solution.counters = {{"variables", static_cast<double>(model.edges.size())},
                       {"programs", static_cast<double>(solver.programs())},
                       {"fixed_variables", static_cast<double>(solver.fixed())}};
  if (context.parameters.text("count") != "on") return solution;
  const ScopedPhase phase(context, "count");
  const std::vector<ModelEdge> open(model.edges.size(), ModelEdge::open);
  const ModelSummary all = search_models(points, model, open, context.deadline);
  if (!all.have_the_same_size) throw std::logic_error("boolean_model: a model is no triangulation");
  if (!all.stop_reason) solution.count = all.count;
  solution.stop_reason = combined(solution.stop_reason, all.stop_reason);
  return solution;
}

Solution solve_in_range(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

AlgorithmInfo boolean_model_entry() {
  AlgorithmInfo info;
  info.name = "boolean_model";
  info.summary =
      "the source report's Boolean model, one variable per edge, by a linear program and search; counts its models too";
  info.source = "source report, section 3";
  info.guarantee = "optimal, up to the certified interval it returns";
  info.time = "exponential; O(n^4) parts in convex position; linear programs of O(n^2) variables";
  info.space = "O(n^4)";
  info.exactness = Exactness::exact;
  info.max_n = 20;
  info.parameters = {{"max_points", ParameterType::integer, "24", "largest number of points it takes"},
                     {"count", ParameterType::choice, "off", "whether to count the models, one by one", {"off", "on"}}};
  info.function = solve_in_range;
  return info;
}

}  // namespace mwt
