#include "algorithms/flip_naive/flip_naive.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/greedy/greedy.h"
#include "algorithms/greedy_naive/greedy_naive.h"
#include "algorithms/sweep/sweep.h"
#include "base/error.h"
#include "geometry/delaunay.h"
#include "geometry/mesh/flip_triangulation.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

namespace {

// How often the deadline is looked at: once in so many edges or flips.
constexpr std::size_t kDeadlineInterval = 256;

class Search {
 public:
  Search(Points points, const Triangulation& start, const Deadline& deadline, std::size_t max_flips)
      : points_(points), triangulation_(start), deadline_(deadline), max_flips_(max_flips) {}

  void improve_in_passes() {
    bool flipped = true;
    while (flipped && !stopped_early_ && flips_.size() < max_flips_) {
      flipped = pass();
      ++passes_;
    }
  }

  void improve_best_first() {
    for (Index e = 0; e < triangulation_.edge_count(); ++e) propose(e);
    while (!proposals_.empty() && flips_.size() < max_flips_ && !deadline_passed(flips_.size())) {
      const Proposal proposal = proposals_.top();
      proposals_.pop();
      const Index e = proposal.number;
      if (is_outdated(proposal)) continue;
      flip(e);
      for (const Index side : triangulation_.sides(e)) propose(side);
    }
  }

  FlipSearch take() { return {triangulation_.triangulation(), std::move(flips_), passes_, stopped_early_}; }

 private:
  // A flip that improved when it was proposed.
  struct Proposal {
    DoubleDouble gain;
    Edge removed;
    Edge added;
    Index number;  // of the edge

    // The order of the queue: the largest gain on top, the smaller edges among equals.
    bool operator<(const Proposal& other) const {
      if (!(gain == other.gain)) return gain < other.gain;
      return std::tie(removed, added) > std::tie(other.removed, other.added);
    }
  };

  [[nodiscard]] Edge new_edge(Index e) const {
    const auto [a, b, c, d] = triangulation_.quadrilateral(e);
    return make_edge(c, d);
  }

  [[nodiscard]] bool improves(Index e) const {
    if (triangulation_.is_boundary(e)) return false;
    const auto [a, b, c, d] = triangulation_.quadrilateral(e);
    return compare_length(points_[c], points_[d], points_[a], points_[b]) < 0 &&
           is_flippable(points_, triangulation_, e);
  }

  [[nodiscard]] DoubleDouble gain(const Edge& removed, const Edge& added) const {
    return length(points_[removed.a], points_[removed.b]) - length(points_[added.a], points_[added.b]);
  }

  void flip(Index e) {
    const Edge removed = triangulation_.edge(e), added = new_edge(e);
    // An exact comparison found the gain positive, even where it is too small to show.
    const double shown = std::max(gain(removed, added).high, std::numeric_limits<double>::denorm_min());
    flips_.push_back({removed, added, shown});
    triangulation_.flip(e);
  }

  // One pass over all edges in the order of their ends. Whether it flipped any.
  bool pass() {
    std::vector<std::pair<Edge, Index>> order;
    order.reserve(triangulation_.edge_count());
    for (Index e = 0; e < triangulation_.edge_count(); ++e) order.emplace_back(triangulation_.edge(e), e);
    std::sort(order.begin(), order.end());
    const std::size_t flips_before = flips_.size();
    for (std::size_t i = 0; i < order.size() && !deadline_passed(i); ++i) {
      if (flips_.size() == max_flips_) break;
      if (improves(order[i].second)) flip(order[i].second);
    }
    return flips_.size() != flips_before;
  }

  void propose(Index e) {
    if (!improves(e)) return;
    const Edge removed = triangulation_.edge(e), added = new_edge(e);
    proposals_.push({gain(removed, added), removed, added, e});
  }

  // Whether the edge or its quadrilateral has changed since.
  [[nodiscard]] bool is_outdated(const Proposal& proposal) const {
    return triangulation_.edge(proposal.number) != proposal.removed || new_edge(proposal.number) != proposal.added;
  }

  bool deadline_passed(std::size_t step) {
    if (step % kDeadlineInterval == 0) stopped_early_ = has_passed(deadline_);
    return stopped_early_;
  }

  Points points_;
  FlipTriangulation triangulation_;
  Deadline deadline_;
  std::size_t max_flips_;
  std::priority_queue<Proposal> proposals_;
  std::vector<Flip> flips_;
  Index passes_ = 0;
  bool stopped_early_ = false;
};

Triangulation start_of(Points points, const Context& context) {
  if (context.start) return *context.start;
  const std::string& start = context.parameters.text("start");
  if (start == "delaunay") return delaunay_triangulation(points);
  if (start == "sweep") return sweep_triangulation(points);
  if (start != "greedy") {
    throw InputError("flip_naive: parameter start=" + start +
                     " is neither delaunay, sweep or greedy nor a file of triangles");
  }
  std::optional<Triangulation> greedy = greedy_naive(points, context.deadline);
  return greedy ? *std::move(greedy) : greedy_triangulation(points);
}

Triangulation timed_start_of(Points points, Context& context) {
  const ScopedPhase phase(context, "start");
  return start_of(points, context);
}

std::size_t max_flips(const Parameters& parameters) {
  const std::int64_t given = parameters.integer("max_flips");
  if (given < -1) throw InputError("flip_naive: parameter max_flips must be -1 (any number) or more");
  return given < 0 ? kAnyNumberOfFlips : static_cast<std::size_t>(given);
}

Solution solve(Points points, Context& context) {
  const Triangulation start = timed_start_of(points, context);
  const ScopedPhase phase(context, "flips");
  const bool first = context.parameters.text("improvement") == "first";
  FlipSearch result = flip_search(points, start, first ? FlipImprovement::first : FlipImprovement::best,
                                  context.deadline, max_flips(context.parameters));
  Solution solution;
  solution.triangulation = std::move(result.triangulation);
  solution.counters["flips"] = static_cast<double>(result.flips.size());
  if (first) solution.counters["passes"] = result.passes;
  solution.flips = std::move(result.flips);
  solution.stop_reason = deadline_if(result.stopped_early);
  return solution;
}

}  // namespace

FlipSearch flip_search(Points points, const Triangulation& start, FlipImprovement improvement, const Deadline& deadline,
                       std::size_t max_flips) {
  Search search(points, start, deadline, max_flips);
  if (improvement == FlipImprovement::first) {
    search.improve_in_passes();
  } else {
    search.improve_best_first();
  }
  return search.take();
}

AlgorithmInfo flip_naive_entry() {
  AlgorithmInfo info;
  info.name = "flip_naive";
  info.summary = "local search by flips, as the source report writes it";
  info.source = "source report, section 5.3";
  info.guarantee = "none: linear in n in the worst case; the source report claims at most 1.2 with probability 1/2";
  info.time = "O(n log n) per pass";
  info.space = "O(n + flips)";
  info.max_n = 1'000'000;
  info.parameters = {{"start",
                      ParameterType::text,
                      "delaunay",
                      "initial triangulation: delaunay, sweep, greedy (of greedy_naive), or a file of triangles",
                      {"delaunay", "sweep", "greedy"}},
                     {"improvement",
                      ParameterType::choice,
                      "first",
                      "which improving flip to make: the first met in passes over all edges, or the best of all",
                      {"first", "best"}},
                     {"max_flips", ParameterType::integer, "-1", "stop after so many flips; -1: at a local optimum"}};
  info.function = solve;
  return info;
}

}  // namespace mwt
