// The ears of a large face that need no queue: taken in the order of memory.
#pragma once

#include <span>
#include <vector>

#include "algorithms/greedy/ears/ear_search.h"
#include "algorithms/greedy/greedy_parts.h"

namespace mwt {

class FaceBoundary;

/// Cuts certain ears (EarSearch) off the boundary of a face and fixes them in the mesh. Corners are looked at in blocks
/// that lie near each other, first come, first served; each ear that is taken brings the two corners on either side
/// back, since what it hides may have stood against them. Few looks take many steps of search; those are put off until
/// the others are done.
class CertainEars {
 public:
  explicit CertainEars(const GreedyParts& parts) : parts_(parts), search_(parts.mesh, parts.order) {}

  /// `face`: all edges inside the face, none of them fixed; it still holds all of them afterwards. Linear time as far
  /// as the search is concerned: long searches are given up when they took 4 steps per corner that may be an ear. False
  /// if the deadline has passed.
  bool take(std::span<const MeshEdge> face);

  /// Ears taken so far that were no edges of the mesh before.
  [[nodiscard]] std::size_t inserted() const { return inserted_; }

 private:
  static constexpr std::size_t kBlock = 4096;        // so many corners, with their surroundings, fit the cache
  static constexpr std::size_t kFewSteps = 64;       // of a look that is not put off
  static constexpr std::size_t kStepsPerCorner = 4;  // of all that were put off

  void look_at_waiting(FaceBoundary& boundary);
  void look_at_put_off(FaceBoundary& boundary, std::size_t max_steps);
  void look_at(FaceBoundary& boundary, Corner c, std::size_t max_steps);
  [[nodiscard]] bool is_certain(const FaceBoundary& boundary, Corner c, std::size_t max_steps);
  void take_ear(FaceBoundary& boundary, Corner c);

  GreedyParts parts_;
  EarSearch search_;
  KeptVector<Corner> waiting_;  // to be looked at
  KeptVector<Corner> put_off_;  // to be looked at with more steps, once waiting_ is empty
  std::size_t inserted_ = 0;
  std::size_t looks_ = 0;
  bool stopped_ = false;
};

}  // namespace mwt
