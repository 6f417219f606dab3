#include "algorithms/boolean_model/edge_program.h"

#include <algorithm>
#include <cmath>

namespace mwt {

namespace {

// What a solution may miss of 0, 1 or a right side and still count as there.
constexpr double kReadingError = 1e-6;
// How often multipliers are refined, and how often cliques are added, before branching is the better way.
constexpr int kMaxRefinements = 3, kMaxRounds = 30;
// Relative to the sum of the terms' magnitudes: lengths err by 2^-97, each addition by 2^-100.
constexpr double kSumError = 0x1p-88;

}  // namespace

// Column 0 stands for choosing nothing at all, so that every restriction has a solution; it costs more than any model.
EdgeProgram::EdgeProgram(Points points, const CrossingModel& model, double unit, const Deadline& deadline)
    : model_(model),
      deadline_(deadline),
      rows_of_(model.edges.size()),
      decision_row_(model.edges.size(), -1),
      use_(model.edges.size(), 0),
      decisions_(model.edges.size()) {
  program_.add_column({});
  std::vector<std::uint32_t> all;
  for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
    const Point &p = points[model.edges[e].a], &q = points[model.edges[e].b];
    const DoubleDouble whole = length(p, q);
    cost_.push_back({whole.high / unit, whole.low / unit});
    program_.add_column({});
    all.push_back(e);
  }
  add_row({all, static_cast<double>(model.size), Sense::equal, true});
  for (std::uint32_t e = 0; e < model.edges.size(); ++e) {
    std::vector<std::uint32_t> edges = model.crossing[e];
    edges.push_back(e);
    if (model.crossing[e].empty()) {
      add_row({edges, 1, Sense::equal, true});
    } else {
      add_row({edges, 1, Sense::at_least, true});
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

void EdgeProgram::decide(std::uint32_t edge, std::optional<bool> decision) {
  decisions_[edge] = decision;
  if (decision_row_[edge] < 0) decision_row_[edge] = add_row({{edge}, 0, Sense::equal, false});
  const auto number = static_cast<std::size_t>(decision_row_[edge]);
  rows_[number].is_active = decision.has_value();
  rows_[number].right_side = decision.value_or(false) ? 1 : 0;
  if (!decision) multiplier_[number] = 0;
  const auto right_side = decision ? std::optional(rows_[number].right_side) : std::nullopt;
  program_.set_right_side(decision_row_[edge], right_side);
}

DoubleDouble EdgeProgram::reduced_cost(std::uint32_t edge) const {
  DoubleDouble result = cost_[edge];
  for (const std::uint32_t row : rows_of_[edge]) result += -multiplier_[row];
  return result;
}

// `worst` becomes the least reduced cost, at most 0.
double EdgeProgram::bound(double& worst) const {
  DoubleDouble sum;
  double magnitude = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double term = multiplier_[i] * rows_[i].right_side;  // right sides are small integers
    sum += exact_product(multiplier_[i], rows_[i].right_side);
    magnitude += std::abs(term);
  }
  worst = 0;
  for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
    const DoubleDouble reduced = reduced_cost(e);
    worst = std::min(worst, reduced.high);
    magnitude += cost_[e].high;
    for (const std::uint32_t row : rows_of_[e]) magnitude += std::abs(multiplier_[row]);
    if (reduced.high < 0) sum += reduced;  // times x <= 1
  }
  return next_down(sum.high - (kSumError * magnitude + std::abs(sum.low)));
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
    if (!rows_[i].is_active) continue;
    multiplier_[i] += program_.dual(static_cast<int>(i)) / scale;
    if (rows_[i].sense == Sense::at_least) multiplier_[i] = std::max(multiplier_[i], 0.0);
    if (rows_[i].sense == Sense::at_most) multiplier_[i] = std::min(multiplier_[i], 0.0);
  }
  for (std::uint32_t e = 0; e < use_.size(); ++e) use_[e] = program_.value(static_cast<int>(e) + 1);
  return true;
}

double EdgeProgram::solve(double enough) {
  double best = 0, worst = 0;
  double scale = 1;
  int refinements = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    if (!optimise(round == 0 ? LinearProgram::Method::dual : LinearProgram::Method::primal, scale)) break;
    best = std::max(best, bound(worst));
    if (best >= enough) break;
    if (add_violated_cliques()) {
      scale = 1;
      continue;
    }
    if (refinements++ == kMaxRefinements || worst >= 0) break;
    scale = std::ldexp(1.0, std::min(-std::ilogb(worst), 50));
  }
  return best;
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
  for (std::vector<std::uint32_t>& clique : cliques) add_row({std::move(clique), 1, Sense::at_most, true});
  return !cliques.empty();
}

std::optional<std::uint32_t> EdgeProgram::fractional_edge() const {
  std::optional<std::uint32_t> best;
  double best_merit = 0;
  for (std::uint32_t e = 0; e < use_.size(); ++e) {
    const double fraction = std::min(use_[e], 1 - use_[e]);
    if (decisions_[e] || model_.crossing[e].empty() || fraction < kReadingError) continue;
    const double merit = fraction * cost_[e].high;
    if (merit > best_merit) {
      best = e;
      best_merit = merit;
    }
  }
  return best;
}

}  // namespace mwt
