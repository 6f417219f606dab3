// What greedy notes on the edges of its mesh while it works.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

inline constexpr std::uint32_t kFixedMark = 2;                          // chosen by greedy
inline constexpr std::uint32_t kFlippedMark = 4;                        // no longer the edge that its face started with
inline constexpr std::array<std::uint32_t, 2> kWatchedMarks = {8, 16};  // the halfedge blocks an ear of its wedge
inline constexpr std::uint32_t kInnerMark = 32;                         // lies inside the region being restored
inline constexpr std::uint32_t kFaceMark = 64;                          // its face is being or has been solved
inline constexpr std::uint32_t kCandidateMark = 128;                    // in the queue
inline constexpr std::uint32_t kEarsTakenMark = 1024;                   // certain ears of its face have been taken
inline constexpr std::uint32_t kDividedMark = 2048;                     // certain edges of its face have been fixed
inline constexpr std::uint32_t kLoweredMark = 4096;                     // has a new CrossingBounds

inline constexpr std::uint32_t kGreedyMarks = kFixedMark | kFlippedMark | kWatchedMarks[0] | kWatchedMarks[1] |
                                              kInnerMark | kFaceMark | kCandidateMark | kEarsTakenMark | kDividedMark |
                                              kLoweredMark;
static_assert((kGreedyMarks & (kHullMark | kLastingMarks)) == 0);

/// Whether greedy has chosen the edge.
[[nodiscard]] inline bool is_fixed_edge(const PlanarMesh& mesh, MeshEdge e) {
  return (mesh.marks(e) & kFixedMark) != 0;
}
[[nodiscard]] inline bool is_fixed(const PlanarMesh& mesh, Halfedge h) { return is_fixed_edge(mesh, edge_of(h)); }

/// Whether the edge is inside the face at hand: one of those that were collected, and not fixed since.
[[nodiscard]] inline bool is_inside_face(const PlanarMesh& mesh, MeshEdge e) {
  return (mesh.marks(e) & (kFixedMark | kFaceMark)) == kFaceMark;
}

}  // namespace mwt
