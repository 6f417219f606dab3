#include "algorithms/boolean_model/model_search.h"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <numeric>
#include <unordered_map>

#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// A set of edges, by their numbers in the order of the search.
class EdgeBits {
 public:
  explicit EdgeBits(std::size_t edges) : words_((edges + 63) / 64, 0) {}

  void insert(std::uint32_t e) { words_[e / 64] |= std::uint64_t{1} << (e % 64); }
  void erase(std::uint32_t e) { words_[e / 64] &= ~(std::uint64_t{1} << (e % 64)); }
  EdgeBits& operator|=(const EdgeBits& other) {
    return apply(other, [](auto a, auto b) { return a | b; });
  }
  EdgeBits& operator&=(const EdgeBits& other) {
    return apply(other, [](auto a, auto b) { return a & b; });
  }
  EdgeBits& operator-=(const EdgeBits& other) {
    return apply(other, [](auto a, auto b) { return a & ~b; });
  }
  friend bool operator==(const EdgeBits&, const EdgeBits&) = default;

  [[nodiscard]] bool is_empty() const {
    return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
  }
  /// Precondition: not empty.
  [[nodiscard]] std::uint32_t first() const {
    std::size_t i = 0;
    while (words_[i] == 0) ++i;
    return static_cast<std::uint32_t>(64 * i) + static_cast<std::uint32_t>(std::countr_zero(words_[i]));
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t word = words_[i]; word != 0; word &= word - 1)
        visit(static_cast<std::uint32_t>(64 * i) + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
  }
  [[nodiscard]] std::size_t hash() const {
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words_) hash = (hash ^ word) * 0x9E3779B97F4A7C15U ^ (hash >> 29);
    return hash;
  }

 private:
  template <class Apply>
  EdgeBits& apply(const EdgeBits& other, Apply apply) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] = apply(words_[i], other.words_[i]);
    return *this;
  }

  std::vector<std::uint64_t> words_;
};

EdgeBits common(EdgeBits a, const EdgeBits& b) { return a &= b; }

// What is left to decide: edges that are open, and edges that are out and that nothing known crosses so far.
struct Part {
  EdgeBits open, needy;
  friend bool operator==(const Part&, const Part&) = default;
};

struct HashOfPart {
  std::size_t operator()(const Part& part) const { return part.open.hash() * 31 + part.needy.hash(); }
};

// Of all ways to decide a part.
struct Outcome {
  boost::multiprecision::cpp_int count = 0;
  DoubleDouble weight;  // the least; means nothing if the count is 0
  std::size_t min_size = 0, max_size = 0;
  std::uint32_t edge = 0;  // the first decision on the way to the least weight
  bool is_in = true;
};

class PartSearch {
 public:
  PartSearch(Points points, const CrossingModel& model, const Deadline& deadline)
      : points_(points), model_(model), deadline_(deadline), number_(model.edges.size()) {
    original_.resize(model.edges.size());
    std::iota(original_.begin(), original_.end(), 0U);
    std::sort(original_.begin(), original_.end(), [&](std::uint32_t e, std::uint32_t f) { return is_before(e, f); });
    for (std::uint32_t e = 0; e < original_.size(); ++e) number_[original_[e]] = e;
    for (const std::uint32_t e : original_) {
      crossing_.emplace_back(original_.size());
      for (const std::uint32_t f : model.crossing[e]) crossing_.back().insert(number_[f]);
      const Edge& edge = model.edges[e];
      length_.push_back(length(points[edge.a], points[edge.b]));
    }
  }

  ModelSummary run(const std::vector<ModelEdge>& known) {
    Part part{EdgeBits(known.size()), EdgeBits(known.size())};
    EdgeBits chosen(known.size());
    for (std::uint32_t e = 0; e < known.size(); ++e) {
      if (known[original_[e]] == ModelEdge::open) part.open.insert(e);
      if (known[original_[e]] == ModelEdge::out) part.needy.insert(e);
      if (known[original_[e]] == ModelEdge::in) chosen.insert(e);
    }
    bool is_possible = true;
    chosen.for_each([&](std::uint32_t e) {
      is_possible = is_possible && common(crossing_[e], chosen).is_empty();
      part.open -= crossing_[e];
      part.needy -= crossing_[e];
    });
    ModelSummary summary;
    if (!is_possible) return summary;
    const Outcome outcome = search(part);
    summary.stop_reason = stop_reason_;
    if (stop_reason_ || outcome.count == 0) return summary;
    summary.count = outcome.count.str();
    summary.have_the_same_size = outcome.min_size == outcome.max_size;
    collect(part, chosen);
    LengthSum weight;
    chosen.for_each([&](std::uint32_t e) {
      const Edge& edge = model_.edges[original_[e]];
      summary.lightest.push_back(original_[e]);
      weight.add(points_[edge.a], points_[edge.b]);
    });
    std::sort(summary.lightest.begin(), summary.lightest.end());
    // Another model may be lighter by what rounding did to the sums that were compared.
    const Interval enclosure = weight.enclosure();
    const double rounding = 2 * static_cast<double>(known.size() + 8) * kDoubleDoubleError;
    summary.weight = {next_down(enclosure.lower * (1 - rounding)), enclosure.upper};
    return summary;
  }

 private:
  // From left to right, so that what is decided lies left of what is not.
  [[nodiscard]] bool is_before(std::uint32_t e, std::uint32_t f) const {
    const auto ends = [&](std::uint32_t edge) {
      const Point &p = points_[model_.edges[edge].a], &q = points_[model_.edges[edge].b];
      return lexicographically_less(p, q) ? std::pair(p, q) : std::pair(q, p);
    };
    const auto [p, q] = ends(e);
    const auto [r, s] = ends(f);
    return lexicographically_less(p, r) || (p == r && lexicographically_less(q, s));
  }

  // The parts of a part that no crossing joins.
  [[nodiscard]] std::vector<Part> split(Part rest) const {
    std::vector<Part> parts;
    while (!rest.open.is_empty() || !rest.needy.is_empty()) {
      Part& part = parts.emplace_back(Part{EdgeBits(original_.size()), EdgeBits(original_.size())});
      std::vector<std::uint32_t> pending;
      const auto take = [&](std::uint32_t e, EdgeBits& from, EdgeBits& to) {
        from.erase(e);
        to.insert(e);
        pending.push_back(e);
      };
      if (rest.open.is_empty()) {
        take(rest.needy.first(), rest.needy, part.needy);
      } else {
        take(rest.open.first(), rest.open, part.open);
      }
      while (!pending.empty()) {
        const std::uint32_t e = pending.back();
        pending.pop_back();
        common(crossing_[e], rest.open).for_each([&](std::uint32_t f) { take(f, rest.open, part.open); });
        common(crossing_[e], rest.needy).for_each([&](std::uint32_t f) { take(f, rest.needy, part.needy); });
      }
    }
    return parts;
  }

  Outcome search(const Part& part) {
    Outcome all;
    all.count = 1;
    for (const Part& one : split(part)) {
      const Outcome outcome = search_connected(one);
      all.count *= outcome.count;
      if (all.count == 0) return all;
      all.weight += outcome.weight;
      all.min_size += outcome.min_size;
      all.max_size += outcome.max_size;
    }
    return all;
  }

  Outcome search_connected(const Part& part) {
    const auto known = outcomes_.find(part);
    if (known != outcomes_.end()) return known->second;
    constexpr std::size_t kPartsPerLook = 256;
    if (++steps_ % kPartsPerLook == 0 && has_passed(deadline_)) stop_reason_ = StopReason::deadline;
    if (outcomes_.size() >= kMaxParts) stop_reason_ = StopReason::memory;
    if (stop_reason_) return {};
    const Outcome outcome = decide(part);
    outcomes_.emplace(part, outcome);
    return outcome;
  }

  Outcome decide(const Part& part) {
    if (part.open.is_empty()) return {};
    const auto [is_possible, forced] = forced_edge(part);
    if (!is_possible) return {};
    const std::uint32_t edge = forced.value_or(part.open.first());
    Outcome in = search(with(part, edge));
    in.weight += length_[edge];
    ++in.min_size;
    ++in.max_size;
    in.edge = edge;
    const bool can_be_out = !forced && !common(crossing_[edge], part.open).is_empty();
    if (!can_be_out) return in;
    Outcome out = search(without(part, edge));
    out.edge = edge;
    out.is_in = false;
    if (in.count == 0 || out.count == 0) return in.count == 0 ? out : in;
    Outcome& lighter = out.weight < in.weight ? out : in;
    const auto [least, most] = std::pair(std::min(in.min_size, out.min_size), std::max(in.max_size, out.max_size));
    lighter.count = in.count + out.count;
    lighter.min_size = least;
    lighter.max_size = most;
    return lighter;
  }

  // An edge that is out needs one that crosses it: the last one that can, must. False if there is none.
  [[nodiscard]] std::pair<bool, std::optional<std::uint32_t>> forced_edge(const Part& part) const {
    bool is_possible = true;
    std::optional<std::uint32_t> forced;
    part.needy.for_each([&](std::uint32_t e) {
      EdgeBits reasons = common(crossing_[e], part.open);
      is_possible = is_possible && !reasons.is_empty();
      if (!is_possible || forced) return;
      const std::uint32_t first = reasons.first();
      reasons.erase(first);
      if (reasons.is_empty()) forced = first;
    });
    return {is_possible, forced};
  }

  [[nodiscard]] Part with(Part part, std::uint32_t edge) const {
    part.open.erase(edge);
    part.open -= crossing_[edge];
    part.needy -= crossing_[edge];
    return part;
  }

  [[nodiscard]] static Part without(Part part, std::uint32_t edge) {
    part.open.erase(edge);
    part.needy.insert(edge);
    return part;
  }

  // The decisions that lead to the least weight.
  void collect(const Part& part, EdgeBits& chosen) {
    for (const Part& one : split(part)) {
      const Outcome outcome = search_connected(one);
      if (outcome.is_in) chosen.insert(outcome.edge);
      collect(outcome.is_in ? with(one, outcome.edge) : without(one, outcome.edge), chosen);
    }
  }

  static constexpr std::size_t kMaxParts = 2'000'000;

  Points points_;
  const CrossingModel& model_;
  const Deadline& deadline_;
  std::vector<std::uint32_t> original_, number_;  // from the search's order to the model's and back
  std::vector<EdgeBits> crossing_;
  std::vector<DoubleDouble> length_;
  std::unordered_map<Part, Outcome, HashOfPart> outcomes_;
  std::size_t steps_ = 0;
  std::optional<StopReason> stop_reason_;
};

}  // namespace

ModelSummary search_models(Points points, const CrossingModel& model, const std::vector<ModelEdge>& known,
                           const Deadline& deadline) {
  return PartSearch(points, model, deadline).run(known);
}

}  // namespace mwt
