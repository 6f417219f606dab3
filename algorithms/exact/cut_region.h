// Faces with holes or isolated vertices, cut open until their boundary is in one piece: then they are polygons.
#pragma once

#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/candidate_graph.h"
#include "algorithms/exact/face_region.h"
#include "algorithms/exact/polygon_face.h"

namespace mwt {

/// One region, to be cut in different ways one after the other.
class CutRegion {
 public:
  /// `points` are those of the instance; they and the region must stay alive.
  CutRegion(Points points, const FaceRegion& region);

  /// Candidates of which every triangulation of a region with two boundary components contains one at least.
  ///
  /// The inner component's last point in lexicographic order, u, has all its boundary edges on one side. A
  /// triangulation leaves no angle of 180 degrees at u, so some edge leads to a later point, which is none of its
  /// component. The same holds for the first point, and with x and y exchanged: the fewest of the four are taken.
  [[nodiscard]] std::vector<Edge> unavoidable_cuts() const;

  /// Adds the lightest triangulation by candidates that contains the cuts to `result`, if the outcome is `solved`.
  /// Preconditions: the cuts are candidates that do not cross and join all components without a cycle.
  [[nodiscard]] PolygonFaceOutcome solve(std::span<const Edge> cuts, const Deadline& deadline, FaceTriangles& result);

 private:
  [[nodiscard]] CandidateGraph graph_with(std::span<const Edge> cuts) const;

  const FaceRegion& region_;
  // By position in region.vertices:
  std::vector<Point> points_;
  std::vector<Index> component_;  // its smallest vertex
  std::vector<Edge> boundary_;    // undirected, each once
  std::vector<Edge> candidates_;
};

}  // namespace mwt
