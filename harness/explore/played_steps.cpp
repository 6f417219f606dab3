#include "harness/explore/played_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "algorithms/proof_trace.h"
#include "algorithms/step_trace.h"
#include "harness/explore/frame.h"

namespace mwt {

namespace {

using Kind = PlayedStep::Kind;

PlayedStep step_of(Kind kind, const Edge& edge, const Edge& other = {kNoIndex, kNoIndex}, double value = 0) {
  return {kind, edge.a, edge.b, other.a, other.b, value};
}

std::vector<Edge> edges_in_input(const Solution& solution, const PointSet& set) {
  return edges_of({set.input_count, to_input_indices(set, solution.triangulation.triangles)});
}

// Puts the stages of a proof together.
class ProofPlayer {
 public:
  ProofPlayer(const ProofTrace& proof, const PointSet& set) : proof_(proof), set_(set) {}

  PlayedSteps play(const Solution& solution) {
    survive_the_diamond_test();
    for (const EdgeConclusions& conclusions : proof_.edges) conclude(conclusions);
    weigh_open_edges();
    arrive_at(edges_in_input(solution, set_));
    return std::move(played_);
  }

 private:
  [[nodiscard]] Index in_input(Index position) const {
    return set_.input_indices[proof_.order.empty() ? position : proof_.order[position]];
  }

  [[nodiscard]] Edge in_input(const Edge& edge) const {
    return edge.a == edge.b ? Edge{kNoIndex, kNoIndex} : make_edge(in_input(edge.a), in_input(edge.b));
  }

  static Edge open_edge(const DualRegion& region, std::size_t position) {
    const auto& [a, b] = region.open_edges[position];
    return {region.places[a], region.places[b]};
  }

  void begin_stage(std::string name, std::string reason) {
    played_.stages.push_back({std::move(name), std::move(reason), played_.steps.size()});
  }

  // Whatever is concluded or weighed later has passed the test.
  void survive_the_diamond_test() {
    std::set<Edge> candidates;
    for (const EdgeConclusions& conclusions : proof_.edges) {
      for (const Edge& edge : conclusions.edges) candidates.insert(in_input(edge));
    }
    for (const DualRegion& region : proof_.regions) {
      for (std::size_t i = 0; i < region.open_edges.size(); ++i) candidates.insert(in_input(open_edge(region, i)));
    }
    begin_stage("diamond test",
                "passes the diamond test: one of the two triangles on it with base angles pi/4.6 is empty");
    for (const Edge& edge : candidates) played_.steps.push_back(step_of(Kind::add, edge));
    shown_ = std::move(candidates);
  }

  void conclude(const EdgeConclusions& conclusions) {
    const bool is_certain =
        conclusions.reason == EdgeReason::uncrossed || conclusions.reason == EdgeReason::in_beta_skeleton;
    const auto [name, reason] = description_of(conclusions.reason);
    if (conclusions.edges.empty()) return;
    begin_stage(name, reason);
    for (std::size_t i = 0; i < conclusions.edges.size(); ++i) {
      const Edge edge = in_input(conclusions.edges[i]);
      if (is_certain) {
        played_.steps.push_back(step_of(Kind::certain, edge));
        continue;
      }
      const Edge crossed = i < conclusions.crossed.size() ? in_input(conclusions.crossed[i]) : Edge{kNoIndex, kNoIndex};
      played_.steps.push_back(step_of(Kind::remove, edge, crossed));
      shown_.erase(edge);
    }
  }

  static std::pair<std::string, std::string> description_of(EdgeReason reason) {
    switch (reason) {
      case EdgeReason::not_locally_minimal:
        return {"LMT-skeleton",
                "leaves: in every quadrilateral of empty triangles of candidates around it, a flip shortens it"};
      case EdgeReason::crosses_certain: return {"crossing edges", "leaves: it crosses an edge that is certain"};
      case EdgeReason::uncrossed: return {"certain edges", "is certain: no triangle of candidates can take its place"};
      case EdgeReason::in_beta_skeleton:
        return {"beta-skeleton", "is certain: no point sees it at more than 58 degrees"};
    }
    return {};
  }

  // The first dual values of each region: those of the linear program before any decision.
  void weigh_open_edges() {
    double largest = 0;
    for (const DualRegion& region : proof_.regions) {
      for (const double price : prices_of(region)) largest = std::max(largest, price);
    }
    const bool any =
        std::ranges::any_of(proof_.regions, [](const DualRegion& region) { return !region.open_edges.empty(); });
    if (!any) return;
    begin_stage("open faces", "is open: a face's program decides; the shade is its dual value");
    for (const DualRegion& region : proof_.regions) {
      const std::vector<double> prices = prices_of(region);
      for (std::size_t i = 0; i < region.open_edges.size(); ++i) {
        const double price = i < prices.size() && largest > 0 ? prices[i] / largest : 0;
        played_.steps.push_back(step_of(Kind::open, in_input(open_edge(region, i)), {kNoIndex, kNoIndex}, price));
      }
    }
  }

  static std::vector<double> prices_of(const DualRegion& region) {
    std::vector<double> prices;
    if (region.tree.empty()) return prices;
    for (const std::int64_t dual : region.tree.front().edge_duals)
      prices.push_back(std::ldexp(std::abs(static_cast<double>(dual)), region.unit_exponent));
    return prices;
  }

  void arrive_at(const std::vector<Edge>& solution) {
    begin_stage("optimum", "is in the optimum");
    const std::set<Edge> wanted(solution.begin(), solution.end());
    for (const Edge& edge : shown_) {
      if (!wanted.contains(edge)) played_.steps.push_back(step_of(Kind::remove, edge));
    }
    for (const Edge& edge : solution) {
      if (!shown_.contains(edge)) played_.steps.push_back(step_of(Kind::add, edge));
    }
  }

  const ProofTrace& proof_;
  const PointSet& set_;
  PlayedSteps played_;
  std::set<Edge> shown_;
};

template <class Values>
void append_values(std::string& bytes, const Values& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
}

}  // namespace

PlayedSteps played_flips(const Solution& solution, const PointSet& set) {
  const auto in_input = [&](const Edge& edge) {
    return make_edge(set.input_indices[edge.a], set.input_indices[edge.b]);
  };
  PlayedSteps played;
  played.stages.push_back({"flips", "is flipped: the other diagonal of its quadrilateral is shorter", 0});
  const std::vector<Edge> end = edges_in_input(solution, set);
  std::set<Edge> edges(end.begin(), end.end());
  for (auto flip = solution.flips.rbegin(); flip != solution.flips.rend(); ++flip) {
    edges.erase(in_input(flip->added));
    edges.insert(in_input(flip->removed));
  }
  for (const Flip& flip : solution.flips)
    played.steps.push_back(step_of(Kind::flip, in_input(flip.removed), in_input(flip.added), flip.gain));
  played.start.assign(edges.begin(), edges.end());
  return played;
}

PlayedSteps played_proof(const ProofTrace& proof, const Solution& solution, const PointSet& set) {
  return ProofPlayer(proof, set).play(solution);
}

namespace {

// A split joins the corners to the point; where the point lies on a side, that side leaves first.
void play_split(const TracedSplit& split, const PointSet& set, std::set<Edge>& edges, std::vector<PlayedStep>& steps) {
  const auto in_input = [&](Index a, Index b) { return make_edge(set.input_indices[a], set.input_indices[b]); };
  for (std::size_t i = 0; i < split.triangle.size(); ++i) {
    if (split.triangle[i] != split.opposite) continue;
    const Edge side = in_input(split.triangle[(i + 1) % 3], split.triangle[(i + 2) % 3]);
    if (edges.erase(side) > 0) steps.push_back(step_of(Kind::remove, side));
  }
  for (const Index corner : split.triangle) {
    const Edge edge = in_input(corner, split.point);
    if (edges.insert(edge).second) steps.push_back(step_of(Kind::add, edge));
  }
}

}  // namespace

PlayedSteps played_trace(const StepTrace& trace, const PointSet& set) {
  PlayedSteps played;
  if (!trace.kept.empty()) {
    played.stages.push_back({"greedy", "is the shortest that crosses none taken before", 0});
    for (const Edge& edge : trace.kept)
      played.steps.push_back(step_of(Kind::add, make_edge(set.input_indices[edge.a], set.input_indices[edge.b])));
    return played;
  }
  played.stages.push_back({"insertion", "joins an inserted point to a corner of the triangle that holds it", 0});
  played.start = edges_of({set.input_count, to_input_indices(set, trace.start)});
  std::set<Edge> edges(played.start.begin(), played.start.end());
  for (const TracedSplit& split : trace.splits) play_split(split, set, edges, played.steps);
  return played;
}

std::string bytes_of(const PlayedSteps& played) {
  std::string bytes;
  for (const PlayedStep& step : played.steps) append_values(bytes, std::array{step.value});
  for (const PlayedStep& step : played.steps)
    append_values(bytes, std::array{static_cast<std::uint32_t>(step.kind), step.a, step.b, step.c, step.d});
  append_indices(bytes, played.start);
  return bytes;
}

}  // namespace mwt
