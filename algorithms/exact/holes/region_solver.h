// Minimum weight triangulation of a face with holes or isolated vertices.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/stop_reason.h"
#include "geometry/weight.h"

namespace mwt {

class CutLog;  // algorithms/exact/holes/cut_log.h

struct RegionCounters {
  std::uint64_t reductions = 0;  ///< regions cut open and bounded
  std::uint64_t programs = 0;    ///< linear programs
  std::uint64_t branchings = 0;  ///< of regions and of linear programs

  void add(const RegionCounters& other) {
    reductions += other.reductions;
    programs += other.programs;
    branchings += other.branchings;
  }
};

struct RegionSolution {
  std::vector<Triangle> triangles;  ///< of the region; none if candidates admit none, or none below the limit
  LengthSum diagonals;              ///< their total length
  double lower_bound = 0;           ///< certified: triangulations by candidates are not lighter, or not below the limit
  bool solved = false;              ///< nothing lighter than `triangles`, or than the limit, exists, up to rounding
  std::optional<StopReason> stop_reason;  ///< why not, unless solved
  RegionCounters counters;

  [[nodiscard]] bool is_feasible() const { return lower_bound < std::numeric_limits<double>::infinity(); }
  [[nodiscard]] static RegionSolution infeasible() {
    return {{}, {}, std::numeric_limits<double>::infinity(), true, {}, {}};
  }
};

/// Which methods may be used beyond polygons' programs: all, except in tests, which let one stand in for another.
struct RegionMethods {
  bool annuli = true;      ///< annulus_face.h for one hole
  bool reductions = true;  ///< region_reduction.h
  bool programs = true;    ///< linear programs
};

struct RegionSearch {
  Deadline deadline;
  double limit = std::numeric_limits<double>::infinity();  ///< what is not lighter than this is of no interest
  RegionMethods methods{};
  Deadline bounds_deadline{};  ///< until when what the deadline left is bounded from below
  CutLog* cuts = nullptr;      ///< optional: gets the cuts of all reductions
};

/// The best triangulation by candidates. Where the deadline stops it: the best triangulation found, parts of it perhaps
/// constrained Delaunay, and bounds that still hold.
///
/// With one hole or isolated vertex: annulus_face.h. With more, region_reduction.h bounds the region and leaves fewer
/// candidates; those that nothing crosses divide it into polygons and smaller regions, which are solved in turn. If
/// nothing divides it: where its empty triangles are few, they are reduced to those that can fit together
/// (consistent_triangles.h), which may divide it, else they make a linear program with branching
/// (algorithms/triangle_lp/triangle_cover.h); where they are many, one of few candidates, of which every triangulation
/// contains one, joins a hole to the rest, one after the other.
[[nodiscard]] RegionSolution solve_region(Points points, const FaceRegion& region, const RegionSearch& search);

/// The region filled with a constrained Delaunay triangulation, and the best of the bounds (bounds/) that need no
/// solution. The deadline is that of the bounds.
[[nodiscard]] RegionSolution leave_unsolved(Points points, const FaceRegion& region, StopReason reason,
                                            const Deadline& bounds_deadline);

}  // namespace mwt
