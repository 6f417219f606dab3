#include "algorithms/boolean_model/edge_program.h"

#include <algorithm>
#include <cmath>

namespace mwt {

namespace {

// What a solution may miss of 0, 1 or a right side and still count as there.
constexpr double kReadingError = 1e-6;
// How often multipliers are refined, and how often cliques are added, at most.
constexpr int kMaxRefinements = 3, kMaxRounds = 30;
// Relative to the sum of the terms' magnitudes: lengths err by 2^-97, each addition by 2^-100.
constexpr double kSumError = 0x1p-88;

}  // namespace

// Column 0 stands for choosing nothing at all, so that every restriction has a solution; it costs more than any model.
EdgeProgram::EdgeProgram(Points points, const CrossingModel& model, double unit, const Deadline& deadline)
    : model_(model), deadline_(deadline), rows_of_(model.edges.size()), use_(model.edges.size(), 0) {
  program_.add_column({});
  std::vector<std::uint32_t> all;
  for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
    const Point &p = points[model.edges[e].a], &q = points[model.edges[e].b];
    const DoubleDouble whole = length(p, q);
    cost_.push_back({whole.high / unit, whole.low / unit});
    program_.add_column({});
    all.push_back(e);
  }
  add_row({all, static_cast<double>(model.size), Sense::equal});
  for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
    std::vector<std::uint32_t> edges = model.crossing[e];
    edges.push_back(e);
    if (model.crossing[e].empty()) {
      add_row({edges, 1, Sense::equal});
    } else {
      add_row({edges, 1, Sense::at_least});
    }
  }
}

int EdgeProgram::add_row(const Row& row) {
  std::vector<LinearProgram::Entry> entries;
  for (const std::uint32_t e : row.edges) entries.push_back({static_cast<int>(e) + 1, 1});
  if (row.sense != Sense::at_most) entries.push_back({0, row.right_side});
  const int number = program_.add_row(entries, row.right_side);
  int slack = -1;
  if (row.sense != Sense::equal) {
    const LinearProgram::Entry entry{number, row.sense == Sense::at_least ? -1.0 : 1.0};
    slack = program_.add_column(std::span(&entry, 1));
  }
  for (const std::uint32_t e : row.edges) rows_of_[e].push_back(static_cast<std::uint32_t>(number));
  rows_.push_back(row);
  slack_column_.push_back(slack);
  multiplier_.push_back(0);
  return number;
}

DoubleDouble EdgeProgram::reduced_cost(std::uint32_t edge) const {
  DoubleDouble result = cost_[edge];
  for (const std::uint32_t row : rows_of_[edge]) result += -multiplier_[row];
  return result;
}

EdgeProgram::Bound EdgeProgram::bound() const {
  DoubleDouble sum;
  double magnitude = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double term = multiplier_[i] * rows_[i].right_side;  // right sides are small integers
    sum += exact_product(multiplier_[i], rows_[i].right_side);
    magnitude += std::abs(term);
  }
  double worst = 0;
  for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
    const DoubleDouble reduced = reduced_cost(e);
    worst = std::min(worst, reduced.high);
    magnitude += cost_[e].high;
    for (const std::uint32_t row : rows_of_[e]) magnitude += std::abs(multiplier_[row]);
    if (reduced.high < 0) sum += reduced;  // times x <= 1
  }
  const double error = kSumError * magnitude + std::abs(sum.low);
  return {next_down(sum.high - error), worst, 2 * error};
}

bool EdgeProgram::optimise(LinearProgram::Method method, double scale) {
  std::vector<double> costs(static_cast<std::size_t>(program_.columns()), 0);
  double penalty = 0;
  for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
    costs[e + std::size_t{1}] = reduced_cost(e).high * scale;
    penalty += cost_[e].high;
  }
  double paid = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (slack_column_[i] >= 0) {
      const double entry = rows_[i].sense == Sense::at_least ? -1.0 : 1.0;
      costs[static_cast<std::size_t>(slack_column_[i])] = -entry * multiplier_[i] * scale;
    }
    if (rows_[i].sense != Sense::at_most) paid += multiplier_[i] * rows_[i].right_side;
  }
  costs[0] = (2 * penalty - paid) * scale;
  program_.set_costs(costs);
  ++programs_;
  if (!program_.solve(method, deadline_)) return false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    multiplier_[i] += program_.dual(static_cast<int>(i)) / scale;
    if (rows_[i].sense == Sense::at_least) multiplier_[i] = std::max(multiplier_[i], 0.0);
    if (rows_[i].sense == Sense::at_most) multiplier_[i] = std::min(multiplier_[i], 0.0);
  }
  for (std::uint32_t e = 0; e < use_.size(); ++e) use_[e] = program_.value(static_cast<int>(e) + 1);
  return true;
}

double EdgeProgram::solve(double enough) {
  double scale = 1;
  int refinements = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    if (!optimise(round == 0 ? LinearProgram::Method::dual : LinearProgram::Method::primal, scale)) break;
    const Bound now = bound();
    if (now.lower > best_.lower) {
      best_ = now;
      best_reduced_cost_.clear();
      for (std::uint32_t e = 0; e < model_.edges.size(); ++e) best_reduced_cost_.push_back(reduced_cost(e));
    }
    if (best_.lower >= enough) break;
    if (add_violated_cliques()) {
      scale = 1;
      continue;
    }
    if (refinements++ == kMaxRefinements || now.worst >= 0) break;
    scale = std::ldexp(1.0, std::min(-std::ilogb(now.worst), 50));
  }
  return best_.lower;
}

// Begins with each pair that the solution uses too much together, and adds what crosses all so far, most used first.
bool EdgeProgram::add_violated_cliques() {
  constexpr std::size_t kMaxCliques = 50;
  std::vector<std::uint32_t> used;
  for (std::uint32_t e = 0; e < use_.size(); ++e) {
    if (use_[e] > kReadingError) used.push_back(e);
  }
  std::sort(used.begin(), used.end(),
            [&](std::uint32_t e, std::uint32_t f) { return use_[e] > use_[f] || (use_[e] == use_[f] && e < f); });
  std::vector<std::vector<std::uint32_t>> cliques;
  for (const std::uint32_t first : used) {
    std::vector<std::uint32_t> clique{first};
    double total = use_[first];
    for (const std::uint32_t e : used) {
      const bool crosses_all =
          std::all_of(clique.begin(), clique.end(), [&](std::uint32_t f) { return model_.cross(e, f); });
      if (!crosses_all) continue;
      clique.push_back(e);
      total += use_[e];
    }
    if (total <= 1 + kReadingError) continue;
    for (std::uint32_t e = 0; e < use_.size(); ++e) {
      const bool crosses_all =
          std::all_of(clique.begin(), clique.end(), [&](std::uint32_t f) { return model_.cross(e, f); });
      if (crosses_all) clique.push_back(e);
    }
    std::sort(clique.begin(), clique.end());
    if (std::find(cliques.begin(), cliques.end(), clique) == cliques.end()) cliques.push_back(std::move(clique));
    if (cliques.size() == kMaxCliques) break;
  }
  for (std::vector<std::uint32_t>& clique : cliques) add_row({std::move(clique), 1, Sense::at_most});
  return !cliques.empty();
}

std::vector<ModelEdge> EdgeProgram::fixed_edges(double limit) const {
  std::vector<ModelEdge> fixed(model_.edges.size(), ModelEdge::open);
  for (std::uint32_t e = 0; e < best_reduced_cost_.size(); ++e) {
    const double reduced = best_reduced_cost_[e].high;
    const double with_the_other = next_down(best_.lower + next_down(std::abs(reduced) - best_.error));
    if (with_the_other <= limit) continue;
    fixed[e] = reduced > 0 ? ModelEdge::out : ModelEdge::in;
  }
  return fixed;
}

}  // namespace mwt
