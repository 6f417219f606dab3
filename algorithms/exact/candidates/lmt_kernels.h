// The LMT-skeleton's inner loops, on vectors: compiled once per instruction set, of which the program picks one when it
// runs (Google Highway). lmt_scalar.h has the same functions in plain loops.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/stars.h"
#include "geometry/triangulation.h"

namespace mwt {

/// What delete_edges_without_certificate() did.
struct LmtCounters {
  std::uint64_t checks = 0;
  std::uint64_t deleted = 0;

  void add(const LmtCounters& other) {
    checks += other.checks;
    deleted += other.deleted;
  }
};

/// Which edges lie on the convex hull: those need a triangle on one side only and are never deleted.
struct HullEdges {
  std::vector<Index> next;  ///< for each vertex on the hull its successor, kNoIndex for others

  [[nodiscard]] bool contains(Index p, Index q) const { return next[p] == q || next[q] == p; }
};

/// Deletes from the stars every one of `edges` that has no certificate, and, while that breaks the certificates of
/// edges examined before, examines those again. An edge's certificate is a triangle of candidates on either side, with
/// no known point certainly inside, such that the quadrilateral is not certainly convex or the other diagonal is not
/// certainly shorter: the edge is (or may be) locally minimal in it. Only the stars of vertices reached from `edges`
/// change.
///
/// All decisions are made in floats with error margins; what is uncertain, or not a number (Star::component), keeps the
/// edge. After the context's deadline the remaining edges are kept unexamined. The edges deleted are appended to
/// `deleted`, if there is one, in their order. Edges between two stars of more than `max_examined` edges are kept, too.
LmtCounters delete_edges_without_certificate(StarTable& table, Points points, const HullEdges& hull,
                                             std::span<const CandidatePair> edges, const Context& context,
                                             std::vector<Edge>* deleted = nullptr,
                                             std::uint32_t max_examined = Star::kMaxExamined);

/// For tests: the same by the loops of lmt_scalar.h, with the rounding of the instruction set in use.
LmtCounters delete_edges_without_certificate_plainly(StarTable& table, Points points, const HullEdges& hull,
                                                     std::span<const CandidatePair> edges, const Context& context);

/// Deletes `edges` from the stars, and then every edge that was examined before and has no certificate any more; the
/// latter are appended to `deleted`, if there is one, in their order. Each of them has none without all of `edges`.
LmtCounters delete_edges(StarTable& table, Points points, const HullEdges& hull, std::span<const CandidatePair> edges,
                         const Context& context, std::vector<Edge>* deleted = nullptr);

}  // namespace mwt
