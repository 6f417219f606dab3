// One region of a proof: its dual values, and what they prove. The theory is in regions.h.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "verifier/point_tree.h"
#include "verifier/proof_reader.h"

namespace mwt::verifier {

/// The side of a certain edge on which its triangle lies to the left of from -> to.
struct Side {
  Index from, to;
};

struct OpenEdge {
  Index a, b;
};

/// What one leaf of a tree of decisions proves: at least `sum` + N * `worst`.
struct Leaf {
  std::int64_t sum = 0;    ///< of dual values
  std::int64_t worst = 0;  ///< at most 0
};

class Region {
 public:
  /// Reads the unit, the sides and the open edges, but not the decisions and dual values.
  /// Throws Refused where an edge appears twice, or both as certain and as open.
  Region(Points points, const PointTree& tree, ProofReader& proof);

  [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }
  [[nodiscard]] const std::vector<OpenEdge>& open_edges() const { return open_edges_; }
  [[nodiscard]] long unit_exponent() const { return unit_exponent_; }  ///< the unit of length is 2^unit_exponent

  /// Reads the tree of decisions, checks the dual values of its leaves over all empty triangles with three sides in the
  /// region, and calls visit(leaf) for each leaf.
  void read_leaves(ProofReader& proof, const std::function<void(const Leaf&)>& visit);

 private:
  using Corner = std::uint32_t;  // position in corners_
  using EdgeNumber = std::uint32_t;

  // An edge of the region between corners a < b.
  struct RegionEdge {
    Corner a, b;
    bool is_open = false;
    bool has_forward = false, has_backward = false;  // the side left of ab, of ba
    std::int64_t half_length = 0;                    // in units, rounded down; 0 if the edge is certain
    std::int64_t forward = 0, backward = 0;          // dual values
    bool is_removed = false;                         // by a decision
    bool is_decided_in = false;
  };
  // What a triangle pays for an edge ab, a < b, if it lies left of ab or of ba: half the length, less the dual value;
  // kAbsent if no triangle can.
  struct SideCosts {
    std::int64_t forward, backward;
  };
  // An edge as its first corner sees it.
  struct Spoke {
    Corner to;
    EdgeNumber edge;
    SideCosts cost{0, 0};
  };
  struct Neighbour {
    Corner to;
    EdgeNumber edge;
  };
  struct Decision {
    EdgeNumber edge;
    bool is_in = true;
    std::vector<EdgeNumber> removed;  // that were not before
  };
  struct SideDuals {
    std::int64_t forward, backward;
  };
  // Dual values that the leaves below share, but for those that they change.
  struct Base {
    std::size_t decisions;         // above it
    std::vector<SideDuals> duals;  // by edge
    Leaf leaf;                     // what they prove by themselves
  };

  EdgeNumber add_edge(Index from, Index to, bool is_open);
  void compute_half_lengths();
  void decide(Decision& decision);
  void take_back(const Decision& decision);
  void take_back_and_go_on(std::vector<Decision>& path);
  [[nodiscard]] static std::int64_t read_dual(ProofReader& proof);
  [[nodiscard]] Leaf read_leaf(ProofReader& proof);
  [[nodiscard]] Leaf read_changes(ProofReader& proof);
  [[nodiscard]] RegionEdge& note_change(EdgeNumber number);
  void add_base(std::size_t decisions, const Leaf& leaf);
  [[nodiscard]] static SideCosts costs_of(const RegionEdge& edge);
  void update_costs();
  void update_cost(EdgeNumber number);
  [[nodiscard]] std::int64_t worst_triangle();
  [[nodiscard]] std::int64_t worst_changed_triangle();
  template <class Neighbours>
  void look_around(Corner v, const Neighbours& neighbours, std::int64_t& worst);
  void look_at(Corner a, Corner b, Corner c, std::int64_t cost, std::int64_t& worst) const;

  Points points_;
  const PointTree& tree_;
  long unit_exponent_ = 0;
  std::vector<Index> corners_;  // distinct, ascending
  std::vector<Side> sides_;
  std::vector<OpenEdge> open_edges_;
  std::vector<RegionEdge> edges_;
  std::vector<std::vector<Spoke>> spokes_;      // of each corner, to later ones
  std::vector<EdgeNumber> edge_of_side_;        // by position in sides_
  std::vector<EdgeNumber> edge_of_open_;        // by position in open_edges_
  std::vector<SideCosts> cost_to_;              // of edges from the corner at hand, by the other corner
  std::vector<Base> bases_;                     // that the node at hand is below
  bool is_loaded_ = false;                      // whether edges_ has the dual values of the last one
  std::vector<std::vector<Neighbour>> around_;  // of each corner; only if there are bases
  std::vector<EdgeNumber> changed_;             // in the leaf at hand, each once
  std::vector<bool> is_changed_;                // by edge
};

}  // namespace mwt::verifier
