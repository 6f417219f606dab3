#include "algorithms/common/lightest_heuristic.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "algorithms/common/other_deadline.h"
#include "algorithms/flip/flip.h"
#include "algorithms/interrupted.h"
#include "algorithms/patch/patch.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using Clock = Context::Clock;

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

// What an algorithm makes of the points, from `start` if given, else from its default start.
Triangulation result_of(const AlgorithmInfo& algorithm, Points points, const Context& context,
                        const Triangulation* start = nullptr) {
  Context own;
  own.seed = context.seed;
  own.deadline = context.deadline;
  std::map<std::string, std::string> given;
  if (start != nullptr) {
    own.start = *start;
    given["start"] = "given";  // names no algorithm, so own.start counts
  }
  own.parameters = Parameters(algorithm.name, algorithm.parameters, given);
  return algorithm.function(points, own).triangulation;
}

class LightestSoFar {
 public:
  explicit LightestSoFar(Points points) : points_(points) {}

  // Whether it is lighter than all before.
  bool consider(Triangulation candidate) {
    const double candidate_weight = weight(points_, candidate).upper;
    if (candidate_weight >= weight_) return false;
    weight_ = candidate_weight;
    lightest_ = std::move(candidate);
    return true;
  }

  [[nodiscard]] Triangulation take() { return std::move(lightest_); }

 private:
  Points points_;
  Triangulation lightest_;
  double weight_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Triangulation lightest_heuristic(Points points, const Context& context, const std::optional<Triangulation>& own) {
  throw_if_interrupted(context.deadline);  // a Delaunay triangulation of many points takes a while
  LightestSoFar result(points);
  const AlgorithmInfo patch = patch_entry();
  const auto consider_patched = [&](const Triangulation* start) {
    return !context.deadline_passed() && result.consider(result_of(patch, points, context, start));
  };
  const Triangulation flipped = result_of(flip_entry(), points, context);
  result.consider(flipped);
  if (own) result.consider(*own);
  const bool greedy_is_better = consider_patched(nullptr);
  if (own) consider_patched(&*own);
  if (!greedy_is_better) consider_patched(&flipped);
  return result.take();
}

void improve_by_heuristics(Points points, Context& context, Solution& solution) {
  const ScopedPhase phase(context, "heuristics");
  const OtherDeadline last_moment(context, deadline_of_heuristics(context.deadline));
  std::optional<Triangulation> own;
  if (!solution.triangulation.triangles.empty()) own = std::move(solution.triangulation);
  solution.triangulation = lightest_heuristic(points, context, own);
  if (solution.optimum) solution.optimum->upper = weight(points, solution.triangulation).upper;
}

Deadline deadline_before_heuristics(const Deadline& deadline, std::size_t n) {
  if (!deadline) return deadline;
  constexpr double kSufficientPerPoint = 8e-6;  // twice what random points take on one 2.8 GHz core
  constexpr double kSufficient = 2;             // what 10,000 points of a corridor take
  const Clock::time_point now = deadline_clock();
  const Clock::duration quarter = std::max(*deadline - now, Clock::duration::zero()) / 4;
  return deadline.moved_to(*deadline -
                           std::min(quarter, duration_of(kSufficient + kSufficientPerPoint * static_cast<double>(n))));
}

Deadline deadline_before_bounds(const Deadline& deadline, std::size_t n) {
  if (!deadline) return deadline;
  constexpr double kSufficientPerPoint = 8e-6;
  constexpr double kSufficient = 3;
  const Clock::duration tenth = std::max(*deadline - deadline_clock(), Clock::duration::zero()) / 10;
  return deadline.moved_to(*deadline -
                           std::min(tenth, duration_of(kSufficient + kSufficientPerPoint * static_cast<double>(n))));
}

Deadline deadline_of_bounds(const Deadline& deadline, std::size_t n) {
  if (!deadline) return deadline;
  constexpr double kPerPoint = 1e-6;
  constexpr double kMinSeconds = 0.05;
  return deadline.moved_to(
      std::max(*deadline, deadline_clock() + duration_of(kMinSeconds + kPerPoint * static_cast<double>(n))));
}

Deadline deadline_of_heuristics(const Deadline& deadline) {
  if (!deadline) return deadline;
  constexpr double kMinSeconds = 0.2;
  return deadline.moved_to(std::max(*deadline, deadline_clock() + duration_of(kMinSeconds)));
}

}  // namespace mwt
