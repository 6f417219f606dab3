// Which ears are certain because nothing but the boundary beside them comes near: found without a search.
#pragma once

#include <cstddef>

#include "algorithms/greedy/faces/wedge.h"
#include "geometry/mesh/edge_order.h"

namespace mwt {

class BoundaryStretch;
class FaceBoundary;

/// What cuts off corner c: the edge from b, previous on the boundary, to a, the next.
struct DistantEar {
  Corner a, b, c;
  bool is_in_mesh = false;    ///< as far as known
  double squared_length = 0;  ///< of ab, rounded
  double enough = 0;          ///< a squared length above this is certainly more, also in floats
  float at_a = 0;             ///< clearances for BoundaryStretch::cut, once the ear is known to be certain
  float at_b = 0;
  float hidden = 0;
};

/// Looks for what comes near ears of a stretch; keeps count of its work.
class DistantEars {
 public:
  DistantEars(const PlanarMesh& mesh, const EdgeOrder& order, BoundaryStretch& stretch)
      : mesh_(mesh), order_(order), stretch_(stretch) {}

  /// Whether in a sample of the boundary nearly no ear has anything near it; otherwise a search in the mesh is the
  /// better way (EarSearch). O(1) samples.
  [[nodiscard]] bool is_promising(FaceBoundary& boundary);

  /// Allows as much time for short spokes as a boundary of so many corners is worth.
  void begin(std::size_t corners);

  /// Whether the ear is certainly greedy, by lemma 8 of PROOFS.md: the corner is convex and not acute; along the
  /// boundary to either side, the first corner beyond a and b that is not out of sight is farther from c than the ear
  /// is long; and no spoke of the corners on the way, hidden ones included, is as short as the ear, leads as near to c
  /// and leaves this neighbourhood. Exact where it returns true. O(1) unless there are short spokes or the boundary
  /// doubles back.
  [[nodiscard]] bool is_certain(DistantEar& ear);

  /// Whether short spokes have taken too much time since begin() for this to be worth while.
  [[nodiscard]] bool is_hopeless() const { return steps_ >= last_step_ || runs_ > certain_ / 8 + kFewRuns; }

 private:
  static constexpr std::size_t kStepsPerCorner = 2;
  static constexpr std::size_t kFewRuns = 1000;

  struct RunCorner {
    Index point;
    Corner corner;
    bool is_of_ear;
  };

  [[nodiscard]] bool seems_distant(FaceBoundary& boundary, Corner c);
  template <typename Step>
  [[nodiscard]] bool is_far_along(const DistantEar& ear, Corner end, Step step);
  [[nodiscard]] bool is_in_view(const DistantEar& ear, Corner x) const;
  [[nodiscard]] bool precedes(const DistantEar& ear, Corner x) const;
  [[nodiscard]] bool is_clear(const DistantEar& ear, Corner x);
  [[nodiscard]] bool is_clear_around(DistantEar& ear);
  [[nodiscard]] bool is_clear_along_run(DistantEar& ear);
  void collect_run(const DistantEar& ear);
  void add_to_run(Corner from, Corner back_to, bool is_of_ear);
  [[nodiscard]] bool leads_only_within(DistantEar& ear, Corner x, float& least);
  [[nodiscard]] const RunCorner* find_in_run(Corner x, Index target) const;

  const PlanarMesh& mesh_;
  const EdgeOrder& order_;
  BoundaryStretch& stretch_;
  KeptVector<RunCorner> run_;  // the corners of the ear, hidden ones included, and of the pockets beside it, by points
  std::size_t steps_ = 0;
  std::size_t last_step_ = 0;
  std::size_t runs_ = 0;
  std::size_t certain_ = 0;
};

}  // namespace mwt
