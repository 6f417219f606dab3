#include "algorithms/proof/cover_duals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "algorithms/proof/dual_leaf.h"
#include "algorithms/proof/integer_duals.h"
#include "algorithms/triangle_lp/cover_balance.h"
#include "algorithms/triangle_lp/cover_flow.h"
#include "algorithms/triangle_lp/cover_model.h"
#include "algorithms/triangle_lp/cover_program.h"

namespace mwt {

namespace {

// A branch whose bound is this near to the known cover, relatively, is done.
constexpr double kEnough = 1e-13;
// The cost of the cover has this many bits, in units.
constexpr int kBits = 56;
// Checking a proof with more nodes would take too long.
constexpr std::size_t kMaxNodes = 1'000;

// Depth-first search over decisions on edges, as CoverSearch in triangle_cover.cpp, but all triangles stay: the
// verifier would need a proof for each one left out.
class CoverProof {
 public:
  CoverProof(DualRegion& region, const TriangleCoverProblem& problem)
      : region_(region),
        problem_(problem),
        model_(problem),
        has_cover_(problem.start.size() == problem.triangle_count) {
    const double cost = has_cover_ ? cost_of_start() : model_.max_cover_cost;
    enough_ = has_cover_ ? cost * (1 - kEnough) : std::numeric_limits<double>::max();
    const int shift = kBits - std::ilogb(std::max(cost, 0x1p-30));
    region_.unit_exponent = model_.exponent - shift;
    duals_.emplace(model_, problem.points, shift);
    for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) number_of_[model_.edges[edge]] = edge;
    for (std::uint32_t i = 0; i < region_.open_edges.size(); ++i) {
      const auto& [from, to] = region_.open_edges[i];
      if (const auto edge = model_edge(region_.places[from], region_.places[to])) place_of_[*edge] = i;
    }
  }

  void run() {
    CoverDuals duals = duals_of_cover(model_, problem_.points, problem_.start);
    balance_duals(model_, duals, problem_.deadline);
    const std::vector<std::uint32_t> first = promising_columns(model_, duals, problem_.start, 10);
    program_.emplace(model_, std::move(duals), first, problem_.deadline);
    explore();
    const std::int64_t least = *std::min_element(bounds_.begin(), bounds_.end());
    region_.lower_bound = next_down(std::ldexp(static_cast<double>(least), region_.unit_exponent));
    region_.lower_bound = std::max(region_.lower_bound, 0.0);
  }

 private:
  [[nodiscard]] double cost_of_start() const {
    const std::set<Triangle> start(problem_.start.begin(), problem_.start.end());
    double cost = 0;
    for (const CoverModel::Column& column : model_.columns) {
      if (start.contains(column.triangle)) cost += model_.cost(column);
    }
    return cost;
  }

  [[nodiscard]] std::optional<std::uint32_t> model_edge(Index a, Index b) const {
    const auto found = number_of_.find(make_edge(a, b));
    return found == number_of_.end() ? std::nullopt : std::optional(found->second);
  }

  void explore() {
    const double lower = program_->solve(enough_);
    const bool is_done = lower >= enough_ || !program_->solved() || has_passed(problem_.deadline) ||
                         program_->cover() || !has_cover_ || region_.tree.size() > kMaxNodes;
    const auto edge = is_done ? std::nullopt : program_->fractional_edge();
    const auto place = edge ? place_of_.find(*edge) : place_of_.end();
    if (place == place_of_.end()) return round_to_leaf();
    add_branch(region_, place->second);
    for (const EdgeDecision decision : {EdgeDecision::in, EdgeDecision::out}) {
      program_->decide(*edge, decision);
      explore();
    }
    program_->decide(*edge, EdgeDecision::open);
  }

  void round_to_leaf() {
    duals_->round(program_->best_duals());
    bounds_.push_back(duals_->bound());
    add_leaf(region_, [this](Index from, Index to) { return dual_of(from, to); });
  }

  // 0 for edges that are a side of no triangle. Opposite on the two sides of an edge that is not decided to be in.
  [[nodiscard]] std::int64_t dual_of(Index from, Index to) const {
    const auto edge = model_edge(from, to);
    if (!edge) return 0;
    return duals_->of(from < to ? forward_side(*edge) : backward_side(*edge));
  }

  DualRegion& region_;
  const TriangleCoverProblem& problem_;
  CoverModel model_;
  bool has_cover_;
  double enough_ = 0;
  std::optional<IntegerDuals> duals_;
  std::map<Edge, std::uint32_t> number_of_;
  std::map<std::uint32_t, std::uint32_t> place_of_;  // of the model's edges among the region's open ones
  std::optional<CoverProgram> program_;
  std::vector<std::int64_t> bounds_;  // of the leaves
};

}  // namespace

void add_cover_duals(DualRegion& region, const TriangleCoverProblem& problem) { CoverProof(region, problem).run(); }

}  // namespace mwt
