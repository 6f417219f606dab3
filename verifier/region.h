// One region of a proof: its dual values, and what they prove. The theory is in regions.h.
#pragma once

#include <cstdint>
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

  /// Reads the tree of decisions, and checks the dual values of its leaves over all empty triangles with three sides in
  /// the region.
  [[nodiscard]] std::vector<Leaf> read_leaves(ProofReader& proof);

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
  // An edge as its first corner sees it.
  struct Spoke {
    Corner to;
    EdgeNumber edge;
  };
  struct Decision {
    EdgeNumber edge;
    bool is_in = true;
    std::vector<EdgeNumber> removed;  // that were not before
  };

  EdgeNumber add_edge(Index from, Index to, bool is_open);
  void compute_half_lengths();
  void decide(Decision& decision);
  void take_back(const Decision& decision);
  [[nodiscard]] Leaf read_leaf(ProofReader& proof);
  [[nodiscard]] std::int64_t worst_triangle();
  void look_at(const RegionEdge& ab, const RegionEdge& bc, const RegionEdge& ac, std::int64_t& worst) const;

  Points points_;
  const PointTree& tree_;
  long unit_exponent_ = 0;
  std::vector<Index> corners_;  // distinct, ascending
  std::vector<Side> sides_;
  std::vector<OpenEdge> open_edges_;
  std::vector<RegionEdge> edges_;
  std::vector<std::vector<Spoke>> spokes_;  // of each corner, to later ones
  std::vector<EdgeNumber> edge_of_side_;    // by position in sides_
  std::vector<EdgeNumber> edge_of_open_;    // by position in open_edges_
  std::vector<EdgeNumber> edge_to_;         // from the corner at hand, by the other corner
};

}  // namespace mwt::verifier
