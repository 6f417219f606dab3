#include "algorithms/polygon_dp/convex_bounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace mwt {

namespace {

// The last level has no more positions, for its triples are looked at one by one.
constexpr std::size_t kMaxTop = 2048;

// Every 2^level-th vertex of the polygon, or the blocks of vertices from each to the next. Numbered on from period()
// for a second time around, as are vertices; no number reaches a third.
class Positions {
 public:
  Positions(std::size_t polygon_size, int level)
      : polygon_size_(polygon_size),
        level_(level),
        period_((polygon_size + step() - 1) / step()),
        finer_period_((2 * polygon_size + step() - 1) / step()) {}

  [[nodiscard]] std::size_t period() const { return period_; }
  [[nodiscard]] Positions coarser() const { return {polygon_size_, level_ + 1}; }

  /// The vertex at a position, the first of the block.
  [[nodiscard]] std::size_t vertex(std::size_t position) const {
    return position < period_ ? position * step() : polygon_size_ + (position - period_) * step();
  }
  /// The last vertex of the block.
  [[nodiscard]] std::size_t last_vertex(std::size_t position) const { return vertex(position + 1) - 1; }

  /// The same vertex's position among the finer ones; the first half of the block.
  [[nodiscard]] std::size_t in_finer(std::size_t position) const {
    return position < period_ ? 2 * position : finer_period_ + 2 * (position - period_);
  }

  /// Whether the longest intervals of a band reach around half the polygon from any of its vertices.
  [[nodiscard]] bool is_top(std::size_t longest) const {
    return period_ <= kMaxTop && half() <= std::min(longest, period_ - 1);
  }

  /// Blocks of vertices that are at most half a polygon apart are so many positions apart at most, blocks on the border
  /// and the short last one of a period included.
  [[nodiscard]] std::size_t half() const { return period_ / 2 + 4; }

 private:
  [[nodiscard]] std::size_t step() const { return std::size_t{1} << level_; }

  std::size_t polygon_size_;
  int level_;
  std::size_t period_;
  std::size_t finer_period_;
};

// Intervals that start in the first time around.
class Level {
 public:
  Level(const Positions& positions, std::size_t reach)
      : positions_(positions), band_(positions.period() + std::min(reach * kTile, positions.period() - 1), reach) {}

  [[nodiscard]] const Positions& positions() const { return positions_; }
  [[nodiscard]] IntervalBand& band() { return band_; }
  [[nodiscard]] const IntervalBand& band() const { return band_; }
  [[nodiscard]] std::size_t period() const { return positions_.period(); }
  [[nodiscard]] std::size_t longest() const { return std::min(band_.longest(), period() - 1); }

  /// The cost of an interval, wherever it starts; kNoCost if it is longer than the band is wide.
  [[nodiscard]] TileCost cost(std::size_t i, std::size_t j) const {
    if (i >= period()) {
      i -= period();
      j -= period();
    }
    return j < band_.positions() && band_.covers(i, j) ? band_.cost(i, j) : kNoCost;
  }

 private:
  Positions positions_;
  IntervalBand band_;
};

// Three positions around the polygon and the sum of the costs between them.
struct Triple {
  TileCost cost = 3 * (kNoCost / 2);
  std::size_t first = 0;
  std::size_t second = 0;
  std::size_t third = 0;
};

// The best i < j < k < period with no interval longer than about half of the period.
Triple best_triple(const Level& level) {
  const std::size_t period = level.period(), half = level.positions().half();
  std::vector<Triple> best(period);
  tbb::parallel_for(std::size_t{0}, period, [&](std::size_t i) {
    for (std::size_t j = i + 1; j <= std::min(i + half, period - 1); ++j) {
      const TileCost to_second = level.band().cost(i, j);
      const std::size_t first = std::max(j + 1, i + period - std::min(half, period));
      for (std::size_t k = first; k <= std::min(j + half, period - 1); ++k) {
        const TileCost sum = to_second + level.band().cost(j, k) + level.band().cost(k, i + period);
        if (sum < best[i].cost) best[i] = {sum, i, j, k};
      }
    }
  });
  return *std::min_element(best.begin(), best.end(), [](const Triple& a, const Triple& b) { return a.cost < b.cost; });
}

// The program from above.
class UpperProgram {
 public:
  UpperProgram(const ConvexChords& chords, std::size_t reach, const Deadline& deadline)
      : chords_(chords), reach_(reach), deadline_(deadline) {}

  [[nodiscard]] const Level& last() const { return *levels_.back(); }

  // Whether the deadline allowed it.
  [[nodiscard]] bool add_level() {
    const int number = static_cast<int>(levels_.size());
    levels_.push_back(std::make_unique<Level>(Positions(chords_.size(), number), reach_));
    return levels_.back()->band().compute(
        [&](std::size_t i, std::size_t first, RowCosts& costs) {
          number == 0 ? all_chords(i, first, costs) : chords_and_known(number, i, first, costs);
        },
        deadline_);
  }

  [[nodiscard]] std::vector<Triangle> triangles() const {
    const Triple triple = best_triple(last());
    if (triple.cost >= kNoCost) return {};
    const int top = static_cast<int>(levels_.size()) - 1;
    std::vector<Triangle> result;
    add_triangle(top, triple.first, triple.second, triple.third, result);
    std::vector<Part> open = {{top, triple.first, triple.second},
                              {top, triple.second, triple.third},
                              {top, triple.third, triple.first + last().period()}};
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      open_up(part, open, result);
    }
    return result;
  }

 private:
  struct Part {
    int level;
    std::size_t i;
    std::size_t j;
  };

  void all_chords(std::size_t i, std::size_t first, RowCosts& costs) const {
    chords_.lengths_from(i, first, costs.chords.data());
    costs.known.fill(kNoCost);
    if (i + 1 - first < kTile) costs.known[i + 1 - first] = 0;  // a side of the polygon
  }

  void chords_and_known(int number, std::size_t i, std::size_t first, RowCosts& costs) const {
    const Level& level = *levels_[static_cast<std::size_t>(number)];
    const Level& finer = *levels_[static_cast<std::size_t>(number) - 1];
    const Positions& positions = level.positions();
    const std::size_t end = std::min(first + kTile, level.band().positions());
    for (std::size_t j = std::max(i + 1, first); j < end; ++j) {
      const TileCost known = finer.cost(positions.in_finer(i), positions.in_finer(j));
      costs.known[j - first] = known;
      const bool is_new = known == kNoCost;
      costs.chords[j - first] = is_new ? chords_.length(positions.vertex(i), positions.vertex(j)) : kNoCost;
    }
  }

  void add_triangle(int number, std::size_t a, std::size_t b, std::size_t c, std::vector<Triangle>& result) const {
    const Positions& positions = levels_[static_cast<std::size_t>(number)]->positions();
    const auto vertex = [&](std::size_t p) { return static_cast<Index>(positions.vertex(p) % chords_.size()); };
    result.push_back({vertex(a), vertex(b), vertex(c)});
  }

  // Adds the triangle on the chord of `part` and what is left to open, or the same part of the finer level.
  void open_up(const Part& part, std::vector<Part>& open, std::vector<Triangle>& result) const {
    const Level& level = *levels_[static_cast<std::size_t>(part.level)];
    if (part.level > 0) {
      const std::size_t i = level.positions().in_finer(part.i), j = level.positions().in_finer(part.j);
      if (levels_[static_cast<std::size_t>(part.level) - 1]->cost(i, j) < kNoCost) {
        open.push_back({part.level - 1, i, j});
        return;
      }
    }
    if (part.j == part.i + 1) return;
    const std::size_t turn = part.i >= level.period() ? level.period() : 0;
    const std::size_t k = level.band().best_split(part.i - turn, part.j - turn) + turn;
    add_triangle(part.level, part.i, k, part.j, result);
    open.push_back({part.level, part.i, k});
    open.push_back({part.level, k, part.j});
  }

  const ConvexChords& chords_;
  std::size_t reach_;
  const Deadline& deadline_;
  std::vector<std::unique_ptr<Level>> levels_;
};

// P at every vertex, which grows by `growth_around` with every time around.
struct Potential {
  std::vector<TileCost> at;
  TileCost growth_around = 0;

  [[nodiscard]] TileCost operator()(std::size_t vertex) const {
    return at[vertex % at.size()] + (vertex < at.size() ? 0 : growth_around);
  }
};

// What the next position costs at intervals of three quarters of the level's longest: the mean for both ends.
double growth_at(const Level& level, std::size_t position) {
  const std::size_t length = level.longest() * 3 / 4;
  const std::size_t end = position < length ? position + level.period() : position;
  const std::array<TileCost, 4> costs = {level.cost(end - length, end + 1), level.cost(end - length, end),
                                         level.cost(position, position + 1 + length),
                                         level.cost(position + 1, position + 1 + length)};
  if (*std::max_element(costs.begin(), costs.end()) == kNoCost) return 0;
  return std::max(0.0, 0.5 * static_cast<double>(costs[0] - costs[1] + costs[2] - costs[3]));
}

// Never grows by more than kMaxCost around.
Potential potential_of(const Level& level, std::size_t polygon_size) {
  std::vector<double> growth(level.period());
  for (std::size_t r = 0; r < growth.size(); ++r) growth[r] = growth_at(level, r);
  constexpr double kMax = static_cast<double>(ConvexChords::kMaxCost) * 0.99;
  const double factor = std::min(1.0, kMax / std::max(1.0, std::accumulate(growth.begin(), growth.end(), 0.0)));
  Potential potential{std::vector<TileCost>(polygon_size, 0), 0};
  for (std::size_t r = 0; r < growth.size(); ++r) {
    const std::size_t first = level.positions().vertex(r), last = level.positions().last_vertex(r);
    const auto per_vertex = static_cast<TileCost>(growth[r] * factor / static_cast<double>(last - first + 1));
    for (std::size_t v = first; v <= last; ++v) {
      potential.at[v] = potential.growth_around;
      potential.growth_around += per_vertex;
    }
  }
  return potential;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double squared = x * x + y * y;
  const double along = squared > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - (a.x + along * x), p.y - (a.y + along * y));
}

// A block of vertices: within `sagitta` of the segment from its first to its last one.
struct Block {
  Point first;
  Point last;
  double sagitta = 0;
  TileCost growth = 0;        // of the potential from its first to its last vertex
  TileCost least_change = 0;  // what its vertices' potentials were before, less what they are
  TileCost greatest_change = 0;
};

// The least distance between the vertices of two blocks, in local coordinates and but for rounding. Segments between
// vertices in convex position do not cross.
double distance_between(const Block& u, const Block& v) {
  const double segments =
      std::min(std::min(distance_to_segment(u.first, v.first, v.last), distance_to_segment(u.last, v.first, v.last)),
               std::min(distance_to_segment(v.first, u.first, u.last), distance_to_segment(v.last, u.first, u.last)));
  return segments - u.sagitta - v.sagitta;
}

// The program from below. Level 0 is that of the program from above: blocks of one vertex, no potential.
class LowerProgram {
 public:
  LowerProgram(const ConvexChords& chords, std::size_t reach, const Deadline& deadline)
      : chords_(chords), reach_(reach), deadline_(deadline), potential_{std::vector<TileCost>(chords.size(), 0), 0} {}

  // Goes on from `finest`, then from its own last level, to the next. `model` is the last level from above.
  [[nodiscard]] bool add_level(const Level& finest, const Level& model) {
    const Level& finer = level_ ? *level_ : finest;
    Potential next = potential_of(model, chords_.size());
    change_around_ = potential_.growth_around - next.growth_around;
    auto level = std::make_unique<Level>(finer.positions().coarser(), reach_);
    const std::vector<Block> halves = blocks_of(finer.positions(), next);
    const std::vector<Block> blocks = blocks_of(level->positions(), next);
    const bool in_time = level->band().compute(
        [&](std::size_t i, std::size_t first, RowCosts& costs) {
          for (std::size_t j = std::max(i + 1, first); j < std::min(first + kTile, level->band().positions()); ++j) {
            bound(*level, finer, blocks, halves, i, j, costs.chords[j - first], costs.known[j - first]);
          }
        },
        deadline_);
    level_ = std::move(level);
    blocks_ = blocks;
    potential_ = std::move(next);
    return in_time;
  }

  // In units. All three corners in different blocks, or two of them in one.
  [[nodiscard]] TileCost least_total(const Level& finest) const {
    const Level& level = level_ ? *level_ : finest;
    TileCost least = best_triple(level).cost;
    const std::size_t period = level.period(), half = level.positions().half();
    for (std::size_t u = 0; level_ && u < period; ++u) {
      for (std::size_t w = u + period - half; w <= u + half; ++w) {
        const TileCost out = level.cost(u, w), back = level.cost(w, u + period);
        if (out < kNoCost && back < kNoCost) least = std::min(least, out + back - blocks_[u].growth);
      }
    }
    return least < kNoCost ? std::max<TileCost>(0, least + potential_.growth_around) : 0;
  }

 private:
  [[nodiscard]] std::vector<Block> blocks_of(const Positions& positions, const Potential& next) const {
    std::vector<Block> blocks(positions.period());
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
      Block& block = blocks[b];
      const std::size_t first = positions.vertex(b), last = positions.last_vertex(b);
      block.first = chords_.local(first);
      block.last = chords_.local(last);
      block.growth = next(last) - next(first);
      block.least_change = block.greatest_change = potential_(first) - next(first);
      for (std::size_t v = first; v <= last; ++v) {
        block.sagitta = std::max(block.sagitta, distance_to_segment(chords_.local(v), block.first, block.last));
        block.least_change = std::min(block.least_change, potential_(v) - next(v));
        block.greatest_change = std::max(block.greatest_change, potential_(v) - next(v));
      }
    });
    return blocks;
  }

  // The least of the halves' F after the change of potentials, as far as they are known; else what the chord adds to
  // the best split.
  void bound(const Level& level, const Level& finer, const std::vector<Block>& blocks, const std::vector<Block>& halves,
             std::size_t i, std::size_t j, TileCost& chord, TileCost& known) const {
    known = kNoCost;
    bool all_known = true;
    const std::size_t i_end = level.positions().in_finer(i + 1), j_end = level.positions().in_finer(j + 1);
    for (std::size_t a = level.positions().in_finer(i); a < i_end; ++a) {
      for (std::size_t b = level.positions().in_finer(j); b < j_end; ++b) {
        const TileCost cost = finer.cost(a, b);
        all_known = all_known && cost < kNoCost;
        if (cost < kNoCost) known = std::min(known, cost + least_change(halves, a, b));
      }
    }
    chord = kNoCost;
    if (all_known) return;
    const Block &u = blocks[i % blocks.size()], &v = blocks[j % blocks.size()];
    chord = chords_.units_at_most(distance_between(u, v));
    chord += std::min<TileCost>(0, chord - u.growth - v.growth);
  }

  // Of cost(i, j) - (P(j) - P(i)) by the new potential instead of the old one, for vertices i of block a and j of b.
  [[nodiscard]] TileCost least_change(const std::vector<Block>& blocks, std::size_t a, std::size_t b) const {
    const TileCost at_b =
        b < blocks.size() ? blocks[b].least_change : blocks[b - blocks.size()].least_change + change_around_;
    const TileCost at_a =
        a < blocks.size() ? blocks[a].greatest_change : blocks[a - blocks.size()].greatest_change + change_around_;
    return at_b - at_a;
  }

  const ConvexChords& chords_;
  std::size_t reach_;
  const Deadline& deadline_;
  std::unique_ptr<Level> level_;
  std::vector<Block> blocks_;
  Potential potential_;
  TileCost change_around_ = 0;
};

}  // namespace

std::optional<ConvexBounds> bound_convex_polygon(const ConvexChords& chords, std::size_t reach,
                                                 const Deadline& deadline) {
  UpperProgram upper(chords, reach, deadline);
  LowerProgram lower(chords, reach, deadline);
  if (!upper.add_level()) return {};
  const Level& finest = upper.last();
  while (!upper.last().positions().is_top(reach * kTile)) {
    if (!lower.add_level(finest, upper.last()) || !upper.add_level()) return {};
  }
  ConvexBounds bounds;
  bounds.diagonals_at_least = chords.true_length_at_least(lower.least_total(finest));
  bounds.triangles = upper.triangles();
  return bounds;
}

std::uint64_t bytes_for_convex_bounds(std::size_t n, std::size_t reach) {
  return 3 * IntervalBand::bytes(n + 2 * reach * kTile, reach);
}

}  // namespace mwt
