#include "algorithms/subset_dp/subset_dp.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <string>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/max_points.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "geometry/convex_hull.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

__extension__ using Count = unsigned __int128;

// A set of points by their ranks in lexicographic order; as a path, the points on it.
using Path = std::uint32_t;

constexpr Path only(Index rank) { return Path{1} << rank; }
constexpr Path below(Index rank) { return only(rank) - 1; }
Index first_of(Path path) { return static_cast<Index>(std::countr_zero(path)); }
Index last_of(Path path) { return static_cast<Index>(std::bit_width(path)) - 1; }

std::string decimal(Count count) {
  std::string digits;
  do {
    digits += static_cast<char>('0' + static_cast<int>(count % 10));
    count /= 10;
  } while (count > 0);
  std::reverse(digits.begin(), digits.end());
  return digits;
}

// Points by rank, and over which triangles a path may advance.
class SweepGeometry {
 public:
  explicit SweepGeometry(Points points) : order_(lexicographic_order(points)), n_(static_cast<Index>(points.size())) {
    for (const Index i : order_) points_.push_back(points[i]);
    for (Index p = 0; p < n_; ++p) {
      for (Index q = 0; q < n_; ++q) {
        lengths_.push_back(length(points_[p], points_[q]));
        detours_.push_back(apexes_between(p, q, +1));
        shortcuts_.push_back(apexes_between(p, q, -1));
      }
    }
    find_hull_paths();
  }

  /// The points r above the edge pq such that the triangle pqr is empty and r lies between p and q in order.
  [[nodiscard]] Path detours(Index p, Index q) const { return detours_[p * n_ + q]; }
  /// The same for points below.
  [[nodiscard]] Path shortcuts(Index p, Index q) const { return shortcuts_[p * n_ + q]; }
  [[nodiscard]] const DoubleDouble& length_of(Index p, Index q) const { return lengths_[p * n_ + q]; }
  [[nodiscard]] Path lower_hull() const { return lower_hull_; }
  [[nodiscard]] Path upper_hull() const { return upper_hull_; }
  [[nodiscard]] Index size() const { return n_; }
  [[nodiscard]] Index input_index(Index rank) const { return order_[rank]; }

 private:
  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const {
    for (Index p = 0; p < n_; ++p) {
      const bool is_corner = p == a || p == b || p == c;
      if (!is_corner && in_closed_triangle(points_[p], points_[a], points_[b], points_[c])) return false;
    }
    return true;
  }

  [[nodiscard]] Path apexes_between(Index p, Index q, int turn) const {
    Path apexes = 0;
    for (Index r = p + 1; r < q; ++r) {
      if (orientation(points_[p], points_[q], points_[r]) != turn) continue;
      if (turn > 0 ? is_empty(p, q, r) : is_empty(p, r, q)) apexes |= only(r);
    }
    return apexes;
  }

  void find_hull_paths() {
    bool on_lower = true;
    for (const Index rank : convex_hull(points_)) {  // counter-clockwise from rank 0
      if (on_lower) lower_hull_ |= only(rank);
      on_lower = on_lower && rank != n_ - 1;
      if (!on_lower) upper_hull_ |= only(rank);
    }
    upper_hull_ |= only(0);
  }

  std::vector<Index> order_;
  Index n_;
  std::vector<Point> points_;
  std::vector<DoubleDouble> lengths_;
  std::vector<Path> detours_;
  std::vector<Path> shortcuts_;
  Path lower_hull_ = 0;
  Path upper_hull_ = 0;
};

// The dynamic program proper. All ways to a path advance over equally many triangles, so paths come in layers.
class PathProgram {
 public:
  explicit PathProgram(const SweepGeometry& geometry)
      : geometry_(geometry), place_(std::size_t{1} << (geometry.size() - 2), kUnseen) {
    const Path start = geometry.lower_hull();
    DoubleDouble hull_length;
    for (const auto& [p, q] : edges_of_path(start)) hull_length += geometry.length_of(p, q);
    find_or_add(start, start, hull_length);
    next_.counts[0] = 1;
  }

  /// What stopped it first, if anything did.
  std::optional<StopReason> run(const Context& context) {
    constexpr std::size_t kPathsBetweenChecks = 1024;
    while (place_of(geometry_.upper_hull()) == kUnseen) {
      const Layer layer = std::exchange(next_, Layer{records_.size(), {}, {}});
      for (std::size_t i = 0; i < layer.first_count.size(); ++i) {
        if (i % kPathsBetweenChecks == 0) {
          if (context.deadline_passed()) return StopReason::deadline;
          if (!context.fits(bytes_soon(layer))) return StopReason::memory;
        }
        advance(records_[layer.first_record + i].path, &layer.counts[layer.first_count[i]]);
      }
    }
    return {};
  }

  /// After run(): the upper hull is the only path of the last layer.
  [[nodiscard]] Count total() const {
    Count sum = 0;
    for (const Count count : next_.counts) sum += count;
    return sum;
  }
  [[nodiscard]] DoubleDouble lightest_weight() const { return record_of(geometry_.upper_hull()).weight; }
  [[nodiscard]] std::uint64_t paths() const { return records_.size(); }

  [[nodiscard]] Triangulation lightest() const {
    Triangulation result{geometry_.size(), {}};
    for (Path path = geometry_.upper_hull(); path != geometry_.lower_hull(); path = record_of(path).previous) {
      result.triangles.push_back(triangle_between(record_of(path).previous, path));
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kUnseen = ~std::uint32_t{0};

  struct Record {
    Path path;
    Path previous;  // on a lightest way here
    DoubleDouble weight;
  };

  // Paths with equally many triangles below: records_[first_record + i] has one count per mark from
  // counts[first_count[i]] on.
  struct Layer {
    std::size_t first_record = 0;
    std::vector<std::size_t> first_count;
    std::vector<Count> counts;

    [[nodiscard]] std::uint64_t bytes() const {
      return first_count.capacity() * sizeof(std::size_t) + counts.capacity() * sizeof(Count);
    }
  };

  // Of all tables, when those that grow have doubled once more.
  [[nodiscard]] std::uint64_t bytes_soon(const Layer& layer) const {
    return place_.size() * sizeof(place_[0]) + layer.bytes() +
           2 * (records_.capacity() * sizeof(Record) + next_.bytes());
  }

  static std::vector<std::pair<Index, Index>> edges_of_path(Path path) {
    std::vector<std::pair<Index, Index>> edges;
    for (Index p = 0; (path >> p) > 1;) {
      const Index q = first_of(path & ~below(p + 1));
      edges.push_back({p, q});
      p = q;
    }
    return edges;
  }

  // The first and the last point are on every path: the others' bits number the paths.
  [[nodiscard]] std::size_t slot(Path path) const { return (path & below(geometry_.size() - 1)) >> 1; }
  [[nodiscard]] std::uint32_t place_of(Path path) const { return place_[slot(path)]; }
  [[nodiscard]] const Record& record_of(Path path) const { return records_[place_of(path)]; }

  // The counts of `path` in the next layer; keeps the lighter way to it.
  Count* find_or_add(Path path, Path previous, const DoubleDouble& weight) {
    std::uint32_t& place = place_[slot(path)];
    if (place == kUnseen) {
      place = static_cast<std::uint32_t>(records_.size());
      records_.push_back({path, previous, weight});
      next_.first_count.push_back(next_.counts.size());
      next_.counts.resize(next_.counts.size() + static_cast<std::size_t>(std::popcount(path)) - 1, 0);
    } else if (weight < records_[place].weight) {
      records_[place].previous = previous;
      records_[place].weight = weight;
    }
    return &next_.counts[next_.first_count[place - next_.first_record]];
  }

  // Takes every advance from `path` that some mark allows. counts[m]: ways to get here with the mark at edge m.
  void advance(Path path, const Count* counts) {
    const DoubleDouble weight = record_of(path).weight;
    const auto edges = edges_of_path(path);
    Count ways = 0;  // with a mark at or left of the advance's last edge
    for (std::size_t m = 0; m < edges.size(); ++m) {
      ways += counts[m];
      if (ways == 0) continue;
      const auto [p, q] = edges[m];
      for (Path apexes = geometry_.detours(p, q); apexes != 0; apexes &= apexes - 1) {
        const Index r = first_of(apexes);
        const DoubleDouble detour = geometry_.length_of(p, r) + geometry_.length_of(r, q);
        find_or_add(path | only(r), path, weight + detour)[m] += ways;
      }
      if (m == 0) continue;
      const Index before = edges[m - 1].first;
      if (geometry_.shortcuts(before, q) & only(p)) {
        find_or_add(path ^ only(p), path, weight + geometry_.length_of(before, q))[m - 1] += ways;
      }
    }
  }

  [[nodiscard]] Triangle triangle_between(Path lower, Path upper) const {
    const Path apex = lower ^ upper;
    const Index r = first_of(apex);
    const Index p = last_of(lower & below(r)), q = first_of(lower & ~below(r + 1));
    const bool is_detour = upper & apex;
    const auto index = [&](Index rank) { return geometry_.input_index(rank); };
    return is_detour ? Triangle{index(p), index(q), index(r)} : Triangle{index(p), index(r), index(q)};
  }

  const SweepGeometry& geometry_;
  std::vector<std::uint32_t> place_;  // in records_, by slot
  std::vector<Record> records_;
  Layer next_;
};

Solution solve(Points points, Context& context) {
  require_max_points("subset_dp", points, context, kSubsetDpMaxN);
  Solution solution;
  std::optional<SubsetDpResult> result;
  {
    const OtherDeadline leaving_time(context, deadline_before_heuristics(context.deadline, points.size()));
    result = count_and_optimise(points, context, solution.stop_reason);
  }
  if (!result) {
    solution.optimum = {cycle_length(points, convex_hull(points)).lower, std::numeric_limits<double>::infinity()};
    improve_by_heuristics(points, context, solution);
    return solution;
  }
  solution.triangulation = std::move(result->lightest);
  solution.optimum = result->optimum;
  solution.count = std::move(result->count);
  solution.counters["paths"] = static_cast<double>(result->paths);
  return solution;
}

Solution solve_at_any_size(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

std::optional<SubsetDpResult> count_and_optimise(Points points, const Context& context,
                                                 std::optional<StopReason>& stop_reason) {
  const SweepGeometry geometry(points);
  PathProgram program(geometry);
  stop_reason = program.run(context);
  if (stop_reason) return {};
  SubsetDpResult result;
  result.lightest = program.lightest();
  const double terms = 3 * static_cast<double>(points.size());
  const double lower = enclose(program.lightest_weight(), (terms + 8) * kDoubleDoubleError).lower;
  result.optimum = {lower, weight(points, result.lightest).upper};
  result.count = decimal(program.total());
  result.paths = program.paths();
  return result;
}

AlgorithmInfo subset_dp_entry() {
  AlgorithmInfo info;
  info.name = "subset_dp";
  info.summary = "counts all triangulations and finds a lightest one by a dynamic program over marked monotone paths";
  info.source =
      "V. Alvarez, R. Seidel, A simple aggregative algorithm for counting triangulations of planar point sets and "
      "related "
      "problems, SoCG 2013";
  info.guarantee = "optimal; with too little time or memory a certified interval";
  info.time = "O(n^2 2^n)";
  info.space = "O(n 2^n)";
  info.exactness = Exactness::exact;
  info.max_n = 24;
  info.version = 2;
  info.parameters = {{"max_points", ParameterType::integer, "24",
                      "largest number of points it takes, 3 to 26; memory quadruples with every two points"}};
  info.function = solve_at_any_size;
  return info;
}

}  // namespace mwt
