// The ears of a large face that need no queue: taken in the order of memory.
#pragma once

#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/boundary/face_boundary.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/ears/ear_search.h"
#include "algorithms/greedy/ears/pockets.h"
#include "algorithms/greedy/faces/fixed_stars.h"

namespace mwt {

/// Cuts certain ears (EarSearch) off the boundary of a face and fixes them in the mesh. Corners are looked at in blocks
/// that lie near each other, first come, first served; each ear that is taken brings the two corners on either side
/// back, since what it hides may have stood against them. Few looks take many steps of search; those are put off until
/// the others are done.
class CertainEars {
 public:
  CertainEars(PlanarMesh& mesh, const EdgeOrder& order, FixedStars& stars, EarInsertion& insertion,
              const Context& context)
      : mesh_(mesh),
        pockets_(mesh, order, stars, insertion, context),
        search_(mesh, order),
        stars_(stars),
        insertion_(insertion),
        context_(context) {}

  /// `face`: all edges inside the face, none of them fixed; it still holds all of them afterwards. Linear time as far
  /// as the search is concerned: long searches are given up when they took 4 steps per corner that may be an ear. False
  /// if the deadline has passed.
  bool take(std::span<const MeshEdge> face);

  /// Ears taken so far that were no edges of the mesh before.
  [[nodiscard]] std::size_t inserted() const { return inserted_ + pockets_.inserted(); }

 private:
  static constexpr std::size_t kBlock = 4096;        // so many corners, with their surroundings, fit the cache
  static constexpr std::size_t kFewSteps = 64;       // of a look that is not put off
  static constexpr std::size_t kStepsPerCorner = 4;  // of all that were put off

  void look_at_waiting(FaceBoundary& boundary);
  void look_at_put_off(FaceBoundary& boundary, std::size_t max_steps);
  void look_at(FaceBoundary& boundary, Corner c, std::size_t max_steps);
  [[nodiscard]] bool is_certain(const FaceBoundary& boundary, Corner c, std::size_t max_steps);
  void take_ear(FaceBoundary& boundary, Corner c);

  PlanarMesh& mesh_;
  Pockets pockets_;
  EarSearch search_;
  FixedStars& stars_;
  EarInsertion& insertion_;
  const Context& context_;
  KeptVector<Corner> waiting_;  // to be looked at
  KeptVector<Corner> put_off_;  // to be looked at with more patience, once nothing else waits
  std::size_t inserted_ = 0;
  std::size_t looks_ = 0;
  bool stopped_ = false;
};

}  // namespace mwt
