#include "algorithms/exact/certain_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

#include "algorithms/exact/by_direction.h"
#include "algorithms/exact/search_stopped.h"
#include "geometry/predicates.h"
#include "geometry/triangulation.h"

namespace mwt {

namespace {

constexpr std::size_t kGrain = 4096;

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
    const auto star = graph_.star(v);
    return std::find(star.begin(), star.end(), w) != star.end();
  }

  bool is_certain(Index s, Index t) const {
    const Point& a = graph_.points[s];
    const Point& b = graph_.points[t];
    const auto star = graph_.star(s);
    const std::size_t degree = star.size();
    const auto here = static_cast<std::size_t>(std::find(star.begin(), star.end(), t) - star.begin());
    // Neighbours to the left of st follow it in the star, those to the right precede it.
    for (std::size_t i = 1; i < degree; ++i) {
      const Index w = star[(here + i) % degree];
      if (orientation(a, b, graph_.points[w]) <= 0) break;
      for (std::size_t j = 1; i + j < degree; ++j) {
        const Index y = star[(here + degree - j) % degree];
        if (orientation(a, b, graph_.points[y]) >= 0) break;
        const bool crosses = orientation(graph_.points[y], graph_.points[w], b) < 0 &&
                             orientation(graph_.points[y], graph_.points[w], a) > 0;
        if (crosses && has_edge(y, w)) return false;
      }
    }
    return true;
  }

  void look_at_the_clock() const {
    if (context_.deadline_passed()) throw SearchStopped("the deadline passed while marking certain edges");
  }

  void mark_edges_from_smaller_end(Index s) {
    constexpr Index kVerticesPerLook = 64;
    constexpr std::uint32_t kLargeStar = 128;
    if (s % kVerticesPerLook == 0) look_at_the_clock();
    const bool is_large = graph_.first[s + std::size_t{1}] - graph_.first[s] > kLargeStar;
    for (std::uint32_t i = graph_.first[s]; i < graph_.first[s + std::size_t{1}]; ++i) {
      const Index t = graph_.target[i];
      if (is_large) look_at_the_clock();
      if (s < t && is_certain(s, t)) graph_.certain[i] = 1;
    }
  }

  void copy_marks_to_larger_end(Index t) {
    for (std::uint32_t i = graph_.first[t]; i < graph_.first[t + std::size_t{1}]; ++i) {
      const Index s = graph_.target[i];
      if (s > t) continue;
      const auto star = graph_.star(s);
      const auto position = static_cast<std::uint32_t>(std::find(star.begin(), star.end(), t) - star.begin());
      graph_.certain[i] = graph_.certain[graph_.first[s] + position];
    }
  }

  CandidateGraph graph_;
  const std::vector<Star>& stars_;
  const Context& context_;
  std::mutex hidden_mutex_;
  std::vector<Edge> hidden_;  // edges through another point
};

}  // namespace

CandidateGraph mark_certain_edges(Points points, const StarTable& stars, const Context& context) {
  return Marking(points, stars, context).run();
}

}  // namespace mwt
