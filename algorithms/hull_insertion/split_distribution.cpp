#include "algorithms/hull_insertion/split_distribution.h"

#include <algorithm>
#include <array>
#include <utility>

#include "algorithms/hull_insertion/split_history.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// A point waiting for insertion; its coordinates beside it spare cache misses.
struct Waiting {
  Point at;
  Index index;
};
using WaitingList = std::vector<Waiting>;

// A region's points may pass through this many regions below it before their number must have halved.
constexpr int kPatience = 32;

// What happened on the way from the outermost region to one inside it.
struct Progress {
  std::size_t halving_from = 0;  // points of the region around it since which they have not halved
  int levels = 0;                // regions since then
  std::size_t splits = 0;        // triangles split on the way

  [[nodiscard]] Progress inwards(std::size_t count) const {
    if (2 * count <= halving_from) return {count, 0, splits};
    return {halving_from, levels + 1, splits};
  }
  [[nodiscard]] Progress after_split() const { return {halving_from, levels, splits + 1}; }
};

class Distribution {
 public:
  explicit Distribution(Points points) : points_(points) {}

  // Triangulates the part of the polygon between `chain` and its chord. `triangles` are its triangles so far.
  void cut_polygon(std::span<const Index> chain, std::span<const Triangle> triangles, WaitingList waiting,
                   const Progress& progress) {
    if (waiting.empty()) {
      append(triangles, progress.splits);
    } else if (progress.levels > kPatience) {
      insert_by_search(SplitHistory(points_, chain, triangles, waiting.size()), waiting, progress.splits);
    } else {
      deal_to_parts(chain, triangles, std::move(waiting), progress);
    }
  }

  SplitTriangles take() { return std::move(result_); }

 private:
  void append(std::span<const Triangle> triangles, std::size_t splits) {
    result_.triangles.insert(result_.triangles.end(), triangles.begin(), triangles.end());
    result_.depth = std::max(result_.depth, splits);
  }

  void deal_to_parts(std::span<const Index> chain, std::span<const Triangle> triangles, WaitingList waiting,
                     const Progress& progress) {
    const Triangle& triangle = triangles.front();
    const auto [a, b, c] = triangle;
    WaitingList in_triangle, in_first, in_last;
    for (const Waiting& point : waiting) {
      const int first_side = orientation(points_[a], points_[b], point.at);
      const int last_side = orientation(points_[b], points_[c], point.at);
      if (first_side >= 0 && last_side >= 0) in_triangle.push_back(point);
      if (first_side <= 0) in_first.push_back(point);
      if (last_side <= 0) in_last.push_back(point);
    }
    waiting = {};
    const auto middle = static_cast<std::size_t>(std::find(chain.begin(), chain.end(), b) - chain.begin());
    const auto first = chain.first(middle + 1), last = chain.subspan(middle);
    const std::size_t first_count = first.size() - 2;  // triangles of a chain: its vertices less 2
    const Progress in_triangle_progress = progress.inwards(in_triangle.size());
    split_triangle(triangle, std::move(in_triangle), in_triangle_progress);
    const Progress in_first_progress = progress.inwards(in_first.size());
    if (first.size() > 2) cut_polygon(first, triangles.subspan(1, first_count), std::move(in_first), in_first_progress);
    const Progress in_last_progress = progress.inwards(in_last.size());
    if (last.size() > 2) cut_polygon(last, triangles.subspan(1 + first_count), std::move(in_last), in_last_progress);
  }

  void split_triangle(const Triangle& triangle, WaitingList waiting, const Progress& progress) {
    if (waiting.empty()) {
      append(std::span(&triangle, 1), progress.splits);
    } else if (progress.levels > kPatience) {
      insert_by_search(SplitHistory(points_, triangle, waiting.size()), waiting, progress.splits);
    } else {
      deal_to_triangles(triangle, std::move(waiting), progress);
    }
  }

  // Splits `triangle` by the first of its points and deals out the others.
  void deal_to_triangles(const Triangle& triangle, WaitingList waiting, const Progress& progress) {
    const Waiting p = waiting.front();
    std::array<WaitingList, 3> dealt;
    for (std::size_t w = 1; w < waiting.size(); ++w) {
      std::array<int, 3> sides{};  // of the rays from p through the corners
      for (std::size_t i = 0; i < 3; ++i) sides[i] = orientation(p.at, points_[triangle[i]], waiting[w].at);
      for (std::size_t i = 0; i < 3; ++i) {
        if (sides[i] >= 0 && sides[(i + 1) % 3] <= 0) dealt[i].push_back(waiting[w]);
      }
    }
    waiting = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = triangle[i], to = triangle[(i + 1) % 3];
      const bool is_flat = orientation(points_[from], points_[to], p.at) == 0;
      const Progress inwards = progress.inwards(dealt[i].size()).after_split();
      if (is_flat) {
        ++result_.edge_splits;
      } else {
        split_triangle({from, to, p.index}, std::move(dealt[i]), inwards);
      }
    }
  }

  void insert_by_search(SplitHistory history, const WaitingList& waiting, std::size_t splits) {
    for (const Waiting& point : waiting) history.insert(point.index);
    append(history.triangles(), splits + history.depth());
    result_.edge_splits += history.edge_splits();
  }

  Points points_;
  SplitTriangles result_;
};

}  // namespace

SplitTriangles insert_by_splitting(Points points, std::span<const Index> polygon, std::span<const Triangle> triangles,
                                   std::span<const Index> interior) {
  WaitingList waiting;
  waiting.reserve(interior.size());
  for (const Index p : interior) waiting.push_back({points[p], p});
  Distribution distribution(points);
  distribution.cut_polygon(polygon, triangles, std::move(waiting), {interior.size(), 0, 0});
  return distribution.take();
}

}  // namespace mwt
