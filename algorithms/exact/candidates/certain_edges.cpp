#include "algorithms/exact/candidates/certain_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>

#include "algorithms/exact/candidates/by_direction.h"
#include "algorithms/exact/candidates/neighbours.h"
#include "algorithms/exact/search_stopped.h"
#include "geometry/predicates.h"
#include "geometry/triangulation.h"

namespace mwt {

namespace {

constexpr std::size_t kGrain = 4096;

// In larger stars edges are looked up by bisection, each edge is tested on its own, and the deadline is checked at
// each.
constexpr std::size_t kLargeStar = 64;

class Marking {
 public:
  Marking(Points points, const StarTable& stars, const Context& context)
      : graph_{points, {}, {}, {}}, stars_(stars.stars), context_(context) {}

  CandidateGraph run() {
    make_rows();
    const auto n = static_cast<Index>(graph_.points.size());
    for_each_vertex(n, [&](Index v) { sort_row(v); });
    if (!hidden_.empty()) drop_hidden();
    graph_.certain.assign(graph_.target.size(), 0);
    for_each_vertex(n, [&](Index v) { mark_edges_from_smaller_end(v); });
    for_each_vertex(n, [&](Index v) { copy_marks_to_larger_end(v); });
    return std::move(graph_);
  }

 private:
  using Place = std::uint32_t;  // in a star
  static constexpr Place kNoPlace = std::numeric_limits<Place>::max();

  template <class Body>
  static void for_each_vertex(Index n, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<Index>(0, n, kGrain), [&](const tbb::blocked_range<Index>& range) {
      for (Index v = range.begin(); v < range.end(); ++v) body(v);
    });
  }

  std::span<Index> row(Index v) {
    return std::span(graph_.target).subspan(graph_.first[v], graph_.first[v + std::size_t{1}] - graph_.first[v]);
  }

  void make_rows() {
    graph_.first.resize(graph_.points.size() + 1);
    std::uint32_t total = 0;
    for (std::size_t v = 0; v < graph_.points.size(); ++v) {
      graph_.first[v] = total;
      total += stars_[v].count;
    }
    graph_.first.back() = total;
    graph_.target.resize(total);
  }

  void sort_row(Index v) {
    const std::span<Index> targets = row(v);
    std::copy_n(stars_[v].target(), stars_[v].count, targets.begin());
    const ByDirection by_direction(graph_.points, v);
    std::sort(targets.begin(), targets.end(), by_direction);
    for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
      // The first of a run of equal directions hides all others.
      std::size_t j = i + 1;
      for (; j < targets.size() && by_direction.is_same_direction(targets[i], targets[j]); ++j) {
        const std::lock_guard lock(hidden_mutex_);
        hidden_.push_back(make_edge(v, targets[j]));
      }
      i = j - 1;
    }
  }

  // Rebuilds the rows without the hidden edges.
  void drop_hidden() {
    std::sort(hidden_.begin(), hidden_.end());
    const auto is_hidden = [&](Index v, Index w) {
      return std::binary_search(hidden_.begin(), hidden_.end(), make_edge(v, w));
    };
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < graph_.points.size(); ++v) {
      const std::uint32_t first = graph_.first[v], last = graph_.first[v + 1];
      graph_.first[v] = kept;
      for (std::uint32_t i = first; i < last; ++i) {
        if (!is_hidden(static_cast<Index>(v), graph_.target[i])) graph_.target[kept++] = graph_.target[i];
      }
    }
    graph_.first.back() = kept;
    graph_.target.resize(kept);
  }

  bool has_edge(Index v, Index w) const {
    if (graph_.star(w).size() < graph_.star(v).size()) std::swap(v, w);
    const auto star = graph_.star(v);
    if (star.size() <= kLargeStar) return std::find(star.begin(), star.end(), w) != star.end();
    // The table's stars are sorted by target. They contain hidden edges as well, which is safe: they can only
    // take the mark from more edges.
    const Star& sorted = stars_[v];
    return std::binary_search(sorted.target(), sorted.target() + sorted.count, w);
  }

  void check_deadline() const {
    if (context_.deadline_passed())
      throw SearchStopped(StopReason::deadline, "the deadline passed while marking certain edges");
  }

  void mark_edges_from_smaller_end(Index s) {
    constexpr Index kVerticesPerCheck = 64;
    if (s % kVerticesPerCheck == 0) check_deadline();
    if (graph_.star(s).size() > kLargeStar) {
      mark_in_large_star(s);
    } else {
      mark_in_small_star(s);
    }
  }

  // Every edge to a later point is certain until an edge yw between neighbours is found that crosses it.
  void mark_in_small_star(Index s) {
    const auto star = graph_.star(s);
    std::vector<Place>& marked = scratch_.local();
    marked.clear();
    for (Place t = 0; t < star.size(); ++t) {
      if (s < star[t]) marked.push_back(t);
    }
    for (Place y = 0; y < star.size() && !marked.empty(); ++y) unmark_edges_crossed_from(s, y, marked);
    for (const Place t : marked) graph_.certain[graph_.first[s] + t] = 1;
  }

  // Where long chains face each other, edges from the nearest neighbours, in the own chain, cross nearly everything.
  void mark_in_large_star(Index s) {
    const auto star = graph_.star(s);
    std::vector<Place>& order = scratch_.local();
    order.resize(star.size());
    std::iota(order.begin(), order.end(), Place{0});
    const auto near = order.begin() + std::min<std::ptrdiff_t>(8, std::ssize(order));
    std::partial_sort(order.begin(), near, order.end(), [&](Place a, Place b) {
      return compare_length(graph_.points[s], graph_.points[star[a]], graph_.points[s], graph_.points[star[b]]) < 0;
    });
    std::vector<Place>& places = places_.local();
    places.assign(star.size(), kNoPlace);
    for (Place t = 0; t < star.size(); ++t) {
      if (star[t] < s) continue;
      check_deadline();
      const bool is_crossed = std::any_of(order.begin(), order.end(), [&](Place y) {
        if (y == t) return false;
        if (places[y] == kNoPlace) places[y] = place_in_star(graph_, star[y], s);
        return is_crossed_from(graph_, star[y], places[y], s, star[t], [&](Index w) { return has_edge(s, w); });
      });
      if (!is_crossed) graph_.certain[graph_.first[s] + t] = 1;
    }
  }

  // By edges from neighbour y to those that follow it counter-clockwise, up to the opposite direction.
  void unmark_edges_crossed_from(Index s, Place y, std::vector<Place>& marked) const {
    const auto star = graph_.star(s);
    const auto degree = static_cast<Place>(star.size());
    const auto steps_to = [&](Place t) { return t > y ? t - y : t + degree - y; };
    const Point& from = graph_.points[star[y]];
    Place steps = steps_to(first_after(marked, y));
    while (++steps < degree) {
      const Place w = y + steps < degree ? y + steps : y + steps - degree;
      const Point& to = graph_.points[star[w]];
      if (orientation(graph_.points[s], from, to) <= 0) return;
      if (!has_edge(star[y], star[w])) continue;
      erase_between(marked, y, w, [&](Place t) { return orientation(from, to, graph_.points[star[t]]) < 0; });
      if (marked.empty()) return;
      steps = std::max(steps, steps_to(first_after(marked, y)));
    }
  }

  // Around the circle; precondition: there are any.
  static Place first_after(const std::vector<Place>& places, Place y) {
    const auto next = std::upper_bound(places.begin(), places.end(), y);
    return next != places.end() ? *next : places.front();
  }

  // Erases those of the places after y and before w, around the circle, that meet the condition.
  template <class Condition>
  static void erase_between(std::vector<Place>& places, Place y, Place w, const Condition& condition) {
    const auto erase = [&](Place first, Place end) {
      const auto from = std::lower_bound(places.begin(), places.end(), first);
      const auto to = std::lower_bound(from, places.end(), end);
      places.erase(std::remove_if(from, to, condition), to);
    };
    if (y < w) return erase(y + 1, w);
    erase(y + 1, kNoPlace);
    erase(0, w);
  }

  void copy_marks_to_larger_end(Index t) {
    for (std::uint32_t i = graph_.first[t]; i < graph_.first[t + std::size_t{1}]; ++i) {
      const Index s = graph_.target[i];
      if (s > t) continue;
      graph_.certain[i] = graph_.certain[graph_.first[s] + place_in_star(graph_, s, t)];
    }
  }

  CandidateGraph graph_;
  const std::vector<Star>& stars_;
  const Context& context_;
  tbb::enumerable_thread_specific<std::vector<Place>> scratch_;
  tbb::enumerable_thread_specific<std::vector<Place>> places_;  // of a vertex in the stars of its neighbours
  std::mutex hidden_mutex_;
  std::vector<Edge> hidden_;  // edges through another point
};

}  // namespace

CandidateGraph mark_certain_edges(Points points, const StarTable& stars, const Context& context) {
  return Marking(points, stars, context).run();
}

}  // namespace mwt
