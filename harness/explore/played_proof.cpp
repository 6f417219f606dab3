#include "harness/explore/played_proof.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "harness/explore/edge_witnesses.h"

namespace mwt {

namespace {

using Sides = EdgeWitnesses::Sides;

class ProofPlayer {
 public:
  ProofPlayer(const ProofTrace& proof, const StepTrace& steps, const PointSet& set)
      : proof_(proof), steps_(steps), set_(set), witnesses_(set.points), stars_(set.points.size()) {}

  PlayedSteps play(const Solution& solution) {
    survive_the_diamond_test();
    for (const EdgeConclusions& conclusions : proof_.edges) conclude(conclusions);
    weigh_open_edges();
    cut();
    std::set<Edge> shown;
    for (const Edge& edge : shown_) shown.insert(in_input(edge));
    played_.arrive_at(solution, set_, shown, "optimum", "is in the optimum");
    return std::move(played_);
  }

 private:
  // From positions in the proof to those in the set, and from there to the input, which keeps the order.
  [[nodiscard]] Index in_set(Index position) const { return proof_.order.empty() ? position : proof_.order[position]; }
  [[nodiscard]] Edge in_set(const Edge& edge) const { return make_edge(in_set(edge.a), in_set(edge.b)); }
  [[nodiscard]] Index in_input(Index point) const { return point == kNoIndex ? kNoIndex : set_.input_indices[point]; }
  [[nodiscard]] Edge in_input(const Edge& edge) const { return {in_input(edge.a), in_input(edge.b)}; }

  void add(PlayedStep::Kind kind, const Edge& edge, const Edge& other = {kNoIndex, kNoIndex}, double value = 0) {
    played_.add(kind, in_input(edge), in_input(other), value);
  }

  static Edge open_edge(const DualRegion& region, std::size_t position) {
    const auto& [a, b] = region.open_edges[position];
    return {region.places[a], region.places[b]};
  }

  // Whatever is concluded or weighed later has passed the test.
  void survive_the_diamond_test() {
    for (const EdgeConclusions& conclusions : proof_.edges) {
      for (const Edge& edge : conclusions.edges) shown_.insert(in_set(edge));
    }
    for (const DualRegion& region : proof_.regions) {
      for (std::size_t i = 0; i < region.open_edges.size(); ++i) shown_.insert(in_set(open_edge(region, i)));
    }
    played_.begin_stage("diamond test", "passes the diamond test: one of the two triangles of its diamond is empty");
    for (const Edge& edge : shown_) {
      stars_.add(edge);
      const std::optional<Sides> inside = witnesses_.in_diamond(edge);
      if (inside) {
        add(PlayedStep::Kind::pass, edge, {(*inside)[0], (*inside)[1]});
      } else {
        add(PlayedStep::Kind::add, edge);
      }
    }
  }

  void conclude(const EdgeConclusions& conclusions) {
    const bool is_certain =
        conclusions.reason == EdgeReason::uncrossed || conclusions.reason == EdgeReason::in_beta_skeleton;
    const auto [name, reason] = description_of(conclusions.reason);
    if (conclusions.edges.empty()) return;
    played_.begin_stage(name, reason);
    for (std::size_t i = 0; i < conclusions.edges.size(); ++i) {
      const Edge edge = in_set(conclusions.edges[i]);
      if (is_certain) {
        add(PlayedStep::Kind::certain, edge);
        continue;
      }
      if (i < conclusions.crossed.size()) {
        remove_crossing(edge, conclusions.crossed[i]);
      } else {
        remove_refuted(edge);
      }
      stars_.remove(edge);
      shown_.erase(edge);
    }
  }

  // From a point to itself: the edge passes through it.
  void remove_crossing(const Edge& edge, const Edge& crossed) {
    if (crossed.a == crossed.b) return add(PlayedStep::Kind::remove, edge);
    add(PlayedStep::Kind::remove, edge, in_set(crossed));
  }

  void remove_refuted(const Edge& edge) {
    const std::optional<Sides> apexes = witnesses_.apexes(edge, stars_);
    if (!apexes) return add(PlayedStep::Kind::remove, edge);
    add(PlayedStep::Kind::refute, edge, {(*apexes)[0], (*apexes)[1]});
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
    played_.begin_stage("open faces", "is open: a face's program decides; the shade is its dual value");
    for (const DualRegion& region : proof_.regions) {
      const std::vector<double> prices = prices_of(region);
      for (std::size_t i = 0; i < region.open_edges.size(); ++i) {
        const double price = i < prices.size() && largest > 0 ? prices[i] / largest : 0;
        add(PlayedStep::Kind::open, in_set(open_edge(region, i)), {kNoIndex, kNoIndex}, price);
      }
    }
  }

  static std::vector<double> prices_of(const DualRegion& region) {
    const auto node = std::ranges::find_if(region.tree, [](const DualNode& each) { return !each.edge_duals.empty(); });
    std::vector<double> prices;
    if (node == region.tree.end()) return prices;
    for (const std::int64_t dual : node->edge_duals)
      prices.push_back(std::ldexp(std::abs(static_cast<double>(dual)), region.unit_exponent));
    return prices;
  }

  void cut() {
    if (steps_.cuts.empty()) return;
    played_.begin_stage("cuts", "is cut along: a shortest candidate that joins a hole to the rest of its face");
    for (const Edge& edge : steps_.cuts) {
      if (shown_.insert(edge).second) add(PlayedStep::Kind::add, edge);  // of a face without dual values
      add(PlayedStep::Kind::cut, edge);
    }
  }

  const ProofTrace& proof_;
  const StepTrace& steps_;
  const PointSet& set_;
  EdgeWitnesses witnesses_;
  CandidateStars stars_;
  PlayedSteps played_;
  std::set<Edge> shown_;  // by positions in the set
};

}  // namespace

PlayedSteps played_proof(const ProofTrace& proof, const StepTrace& steps, const Solution& solution,
                         const PointSet& set) {
  return ProofPlayer(proof, steps, set).play(solution);
}

}  // namespace mwt
